// PriorFile.h - priors of table fits in files.
#pragma once
#include <fbrdf/fit/TablePrior.h>

#include <string>

namespace fbrdf::tool {

/// Throws Error(input) naming the path for what cannot be read, or is no prior.
TablePrior readPrior(const std::string& path);

}  // namespace fbrdf::tool
