// NamedForms.h - the forms of Fit.h, sized to the data and the budget.
#pragma once
#include <fbrdf/fit/Fit.h>

namespace fbrdf {

/// Bytes of a material of this form, three channels: texels x channels x bytes a channel.
size_t formBytes(const Form& form, Storage storage);

/// The largest size of a named form that `samples` can decide (six a texel) and that fits
/// `maxBytes` (0: any). Throws Error(usage) when even the smallest does not fit.
Form makeFormFor(const std::string& name, size_t samples, size_t maxBytes, Storage storage);

/// Texture look-ups that every light costs.
int lookupsPerLight(const Form& form);

}  // namespace fbrdf
