// FormatPage.h - a writer and a reader of .fbrdf files that know docs/format.md, OpenEXR's C++
// library and a JSON parser, and nothing of fbrdf: their sources include none of its headers.
#pragma once
#include <array>
#include <string>

namespace page {

using Triple = std::array<double, 3>;

/// Writes a file of three parts. f = (1, 2, 3) a(theta_i) b(h) + (0, 0, 1) c(theta_h), where
///   log2 a = 2 cos theta_i                                               (float, RGB)
///   log2 b = 1 at h = n, falling linearly over the disc to -1 at its rim  (half, Y)
///   log2 c = 2, 4, 3 at u = 0, 1/2, 1 with u = sqrt(1 - cos theta_h)       (log8, RGB)
void writeThreeTables(const std::string& path);

/// Writes the example of the page: one part, f = 0.5 / pi.
void writeGrey(const std::string& path);

/// f(wo, wi) of any .fbrdf file, for unit vectors above the horizon.
Triple evaluateFile(const std::string& path, const Triple& wo, const Triple& wi);

}  // namespace page
