// FitReport.h - the page that `fit --report` writes.
#pragma once
#include "FitJob.h"

#include <string>

namespace fbrdf::tool {

/// Throws Error(output).
void writeFitReport(const FitJob& job, const FitOutcome& outcome, double writeSeconds,
                    const std::string& path);

}  // namespace fbrdf::tool
