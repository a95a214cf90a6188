// PlanarSpectra.cpp - reflectance spectra measured in the plane of incidence, as a table of text:
// the export of goniospectrophotometers that Ansys' tools read ("2D measurement"). A header
// (NamedTable.h): Incident_angle, Measure_angle, and wavelengths "390nm", "400nm", ... Rows are in
// degrees; the angle of measurement is signed, and the mirror direction is at that of incidence.
// Values are f in 1/sr without the cosine, or reflectance factors, which are pi f: these where the
// median of all values is above 1 / pi, the f of a perfect diffuser. A row of zeros alone was not
// measured, as the detector is in the beam there. FILE@550 takes one wavelength.
#include "Formats.h"
#include "NamedTable.h"
#include "SampleRow.h"
#include "Wavelengths.h"

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

struct PlanarRow {
    double incident, measured;  ///< degrees
    Vec3f value;
    bool measuredAtAll;
};

/// The rows, and the median of all their values.
std::vector<PlanarRow> readPlanarRows(NamedTable& table, const PlanarColumns& columns,
                                      const BandColour& colour, double& median)
{
    std::vector<PlanarRow> rows;
    std::vector<float> all;
    std::vector<double> bands(columns.bands.size());
    while (table.next()) {
        bool any = false;
        for (size_t b = 0; b < bands.size(); ++b) {
            bands[b] = table.number(columns.bands[b]);
            any |= bands[b] != 0.0;
            if (bands[b] != 0.0) all.push_back(static_cast<float>(bands[b]));
        }
        rows.push_back({table.number(columns.incident), table.number(columns.measured),
                        Vec3f(colour(bands.data())), any});
    }
    const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    median = all.empty() ? 0.0 : double(*middle);
    return rows;
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
            "found other columns, expected Incident_angle, Measure_angle and wavelengths");
    const BandColour colour(request, columns->wavelengths);
    double median = 0.0;
    const std::vector<PlanarRow> rows = readPlanarRows(table, *columns, colour, median);
    const bool factors = median > 1.0 / kPi;
    Source source;
    for (const PlanarRow& row : rows) {
        if (!row.measuredAtAll)
            addInvalidRow(source.report);
        else
            addRow(
                {directionFromDegrees(row.measured, 0.0), directionFromDegrees(-row.incident, 0.0),
                 Vec3d(row.value) / (factors ? kPi : 1.0)},
                source.samples, source.report);
    }
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
