// BatchResults.h - results.csv of `batch`: one row a material, in the order of the list. A row is
// made from the material file as it is on the disk, so it does not matter which run or rank wrote
// it.
#pragma once
#include "batch/BatchList.h"

#include <fbrdf/brdf/Material.h>

#include <string>
#include <vector>

namespace fbrdf::tool {

/// What became of one item.
struct BatchOutcome {
    enum class State { fitted, kept, failed } state = State::failed;
    std::string error;  ///< of a failed one: a line as `fit` would print it
};

/// "name,source,form,bytes,..." with a newline: the heading of the table.
std::string resultsHeader();
/// The row of a material, with a newline.
std::string resultsRow(const BatchItem& item, const Material& material);
/// The row of an item that failed: name, source and error alone.
std::string failureRow(const BatchItem& item, const std::string& error);

}  // namespace fbrdf::tool
