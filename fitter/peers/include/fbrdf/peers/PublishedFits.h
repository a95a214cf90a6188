// PublishedFits.h - parameters that others published for MERL materials, read from their tables at
// run time: SGD (Bagher et al. 2012), ABC (Low et al. 2012), NPF (Bagher et al. 2016).
#pragma once
#include <map>
#include <string>
#include <vector>

namespace fbrdf {

/// One row of a table of parameters: column name to value.
using ParameterRow = std::map<std::string, double>;

/// The row of `material` in a CSV file whose first column is the name; empty when there is no such
/// file or no such row. Throws Error(input) naming file and line for a row that does not fit its
/// header.
ParameterRow publishedRow(const std::string& path, const std::string& material);

/// The specification of an analytic model from such a row: each name of `parameters` (model's key,
/// column) is a colour from columns NAME_r, NAME_g, NAME_b or a number from column NAME.
std::string specFromRow(const std::string& model, const ParameterRow& row,
                        const std::vector<std::pair<std::string, std::string>>& parameters);

}  // namespace fbrdf
