// NamedForms.h - the forms of Fit.h, sized to the data and the budget.
#pragma once
#include <fbrdf/fit/Fit.h>

namespace fbrdf {

/// Bytes of a material of this form, three channels: texels x channels x bytes a channel.
size_t formBytes(const Form& form, Storage storage);

/// Texels of all tables: what samples have to decide, near enough (a symmetric table counts twice).
size_t formTexels(const Form& form);
constexpr size_t kSamplesPerTexel = 6;  ///< that a size needs

/// The largest size of a named form that `samples` can decide (kSamplesPerTexel) and that fits
/// `maxBytes` (0: any). Throws Error(usage) when even the smallest does not fit.
Form makeFormFor(const std::string& name, size_t samples, size_t maxBytes, Storage storage);
/// The same, or nothing when even the smallest does not fit.
std::optional<Form> largestFormFor(const std::string& name, size_t samples, size_t maxBytes,
                                   Storage storage);

}  // namespace fbrdf
