// BaseForms.h - the forms that stand alone or as a term of a sum, in all their sizes.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <functional>
#include <vector>

namespace fbrdf {

constexpr int kMinResolution = 4, kMaxResolution = 256;

/// A form that stands alone or as a term of a sum: its sizes from the smallest to the one it has by
/// default.
struct BaseForm {
    NamedForm named;
    std::vector<Form> ladder;
    std::function<Form(int)> make;
};

const std::vector<BaseForm>& baseForms();

}  // namespace fbrdf
