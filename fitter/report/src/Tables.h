// Tables.h - the numbers of a report as HTML tables.
#pragma once
#include <fbrdf/report/Report.h>

#include <string>

namespace fbrdf {

std::string metricsTable(const ReportInput& input, const ImageErrors* image);
std::string trialsTable(const std::vector<ReportTrial>& trials);
std::string samplesTable(const ReportInput& input);
/// Form, tables, scales and notes of the material.
std::string materialTable(const Material& material);

}  // namespace fbrdf
