// SampleRow.h - from the numbers in a row of a file to a Sample, with every row accounted for.
#pragma once
#include <fbrdf/sources/Source.h>

#include <string>

namespace fbrdf {

/// cos of the lowest elevation that is above the horizon. A zenith angle of 90 degrees written in
/// decimals comes out within 4e-8 of 0 in float, on either side; such a pair reflects nothing.
constexpr double kHorizonCosine = 1e-6;

struct SampleRow {
    Vec3d wo{0.0}, wi{0.0};  ///< need not be unit
    Vec3d f{0.0};            ///< 1/sr, without cosine
    double weight = 1.0;
};

/// Unit direction from zenith angle and azimuth in degrees; the zenith angle may be signed.
Vec3d directionFromDegrees(double theta, double phi);

/// Counts the row and, when it is usable, appends its sample. Not usable: anything that is not
/// finite, a direction of length 0 or a weight below 0 (nonFinite); a direction at or below the
/// horizon.
void addRow(const SampleRow& row, std::vector<Sample>& samples, SampleReport& report);

/// The same for directions that are unit already, as the cells of a grid are: several times faster.
void addUnitRow(const SampleRow& row, std::vector<Sample>& samples, SampleReport& report);

/// Counts a row that the file marks as not measured.
void addInvalidRow(SampleReport& report);

/// "1439 rows, 3 not finite, 2 below the horizon": for messages.
std::string briefReport(const SampleReport& report);

/// Throws Error(input) naming `where` when no sample is usable, in memory or of the stream.
void requireSamples(const Source& source, const std::string& where);

}  // namespace fbrdf
