// FormVariants.h - the forms next to a form: one table with more or fewer texels, or with texels
// spent elsewhere. They are defined for every form, so the search knows no form by name.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <optional>

namespace fbrdf {

/// The form with every axis of table `table` `factor` times as many texels, within the limits of
/// its kind of table; nothing when that leaves it as it is. Preconditions: table <
/// form.tables.size(), factor > 0; also of rewarped.
std::optional<Form> resized(const Form& form, size_t table, double factor);

/// The form with the warp of table `table` changed by `factor`: gamma of a disc, the exponent of
/// axis `axis` of a grid (of both axes where it is symmetric). Nothing where there is no such axis
/// or the warp would leave [0.1, 2].
std::optional<Form> rewarped(const Form& form, size_t table, size_t axis, double factor);

/// Axes of a table that rewarped changes one by one.
size_t warpCount(const Domain& domain);

}  // namespace fbrdf
