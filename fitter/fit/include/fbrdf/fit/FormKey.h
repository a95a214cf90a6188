// FormKey.h - a form as text that is exact, for caches and notes that compare forms.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>

namespace fbrdf {

/// Equal for two forms if and only if their tables, terms and arguments are: every number has all
/// of its digits. Names of forms and tables do not count. describe(form) is shorter and rounds.
std::string formKey(const Form& form);

}  // namespace fbrdf
