// PlanarSpectra.cpp - reflectance spectra measured in the plane of incidence, as a table of text:
// the export of goniospectrophotometers that Ansys' tools read ("2D measurement"). A header
// (NamedTable.h): Incident_angle, Measure_angle, and wavelengths "390nm", "400nm", ... Rows are in
// degrees; the angle of measurement is signed, and the mirror direction is at that of incidence.
// Values are f in 1/sr without the cosine, or reflectance factors, which are pi f: these where the
// median of all values is above 1 / pi, the f of a perfect diffuser. A row of zeros alone was not
// measured, as the detector is in the beam there. FILE@550 takes one wavelength.
#include "Formats.h"
#include "NamedTable.h"
#include "NumberRows.h"
#include "SampleRow.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>

namespace fbrdf {
namespace {

struct PlanarColumns {
    size_t incident = 0, measured = 0;
    std::vector<size_t> bands;
    std::vector<double> wavelengths;
};

/// Nothing where the names are not those of such a table.
std::optional<PlanarColumns> planarColumns(const std::vector<std::string>& names)
{
    PlanarColumns columns;
    bool hasIncident = false, hasMeasured = false;
    for (size_t i = 0; i < names.size(); ++i) {
        const double nm = wavelengthNamed(names[i]);
        if (nm > 0.0) {
            columns.bands.push_back(i);
            columns.wavelengths.push_back(nm);
        } else if (sameWord(names[i], "incident_angle") && !hasIncident) {
            columns.incident = i;
            hasIncident = true;
        } else if (sameWord(names[i], "measure_angle") && !hasMeasured) {
            columns.measured = i;
            hasMeasured = true;
        } else if (!names[i].empty()) {
            return {};
        }
    }
    if (!hasIncident || !hasMeasured || columns.bands.empty()) return {};
    return columns;
}

/// Counts on which side of 1 / pi the median of values lies.
class MedianSide {
public:
    void add(double value)
    {
        if (value != 0.0) (value > 1.0 / kPi ? above_ : below_) += 1;
    }
    bool isAbove() const { return above_ > below_; }

private:
    size_t above_ = 0, below_ = 0;
};

/// Adds the rows with values as they stand in the file.
MedianSide readPlanarRows(NamedTable& table, const PlanarColumns& columns, const BandColour& colour,
                          Source& source)
{
    MedianSide side;
    std::vector<double> bands(columns.bands.size());
    while (table.next()) {
        for (size_t b = 0; b < bands.size(); ++b) {
            bands[b] = table.number(columns.bands[b]);
            side.add(bands[b]);
        }
        const Vec3d wo = directionFromDegrees(table.number(columns.measured), 0.0);
        const Vec3d wi = directionFromDegrees(-table.number(columns.incident), 0.0);
        if (std::all_of(bands.begin(), bands.end(), [](double f) { return f == 0.0; }))
            addInvalidRow(source.report);
        else
            addRow({wo, wi, colour(bands.data())}, source.samples, source.report);
    }
    return side;
}

}  // namespace

bool isPlanarSpectra(const InputFile& file)
{
    return looksLikeText(file.bytes()) &&
           planarColumns(columnNamesOf(file.bytes().substr(0, 65536))).has_value();
}

Source readPlanarSpectra(const FileRequest& request)
{
    NamedTable table(*request.file);
    const std::optional<PlanarColumns> columns = planarColumns(table.names());
    if (!columns)
        throw lineError(
            *request.file, table.line(),
            Found("other columns").expected("Incident_angle, Measure_angle and wavelengths"));
    const BandColour colour(request, columns->wavelengths);
    Source source;
    source.samples.reserve(mostRows(*request.file, 2 + columns->bands.size()));
    const bool factors = readPlanarRows(table, *columns, colour, source).isAbove();
    if (factors)
        for (Sample& sample : source.samples) sample.f /= float(kPi);
    source.isotropic = true;
    source.description = "spectra in the plane of incidence, " + colour.description() + ", 1/sr";
    source.assumptions = colour.assumptions();
    source.assumptions.emplace_back(
        factors ? "values are reflectance factors (pi f), as their median is above 1 / pi"
                : "values in 1/sr");
    source.assumptions.emplace_back("a row of zeros was not measured");
    source.assumptions.emplace_back("isotropic, as the sample was not turned");
    requireSamples(source, request.file->path());
    return source;
}

}  // namespace fbrdf
