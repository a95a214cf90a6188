// Nist.cpp - BRDF and Mueller matrices as NIST publishes them in CSV (Germer, "Full
// four-dimensional and reciprocal Mueller matrix bidirectional reflectance distribution function of
// sintered polytetrafluoroethylene", Applied Optics 2017). One header line, columns by position:
// wavelength in um, theta_i, phi_i, theta_r, phi_r in degrees, f_r in 1/sr without the cosine, then
// 15 ratios of the Mueller matrix, which are not read. Both directions point away from the surface;
// a negative theta_i means azimuth + 180. From the README of the data set and the header line,
// which spells its columns "lambda,thetai,phi,thetar,phir". A file has several laser lines:
// FILE@0.532 takes one, the whole file all of them.
#include "Formats.h"
#include "NamedTable.h"
#include "NumberRows.h"
#include "SampleRow.h"
#include "Wavelengths.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

#include <cmath>
#include <set>

namespace fbrdf {
namespace {

/// Half of the least difference between two laser lines in a table with three decimals.
constexpr double kSameLaserLine = 5e-4;

/// Wavelength in um, 0 for all.
double chosenWavelength(const FileRequest& request)
{
    double wavelength = 0.0;
    if (request.choice.empty()) return wavelength;
    const bool read = parseLocalNumber(request.choice, wavelength);
    const std::optional<double> unit = nanometresInUnitOf({wavelength});
    if (!read || !unit)
        throw Error(ErrorKind::usage, request.file->path(),
                    Found(inQuotes(request.choice)).expected("a wavelength in um or nm"));
    return wavelength * *unit / 1000.0;
}

std::string listOf(const std::set<double>& wavelengths)
{
    std::string list;
    for (const double wavelength : wavelengths) {
        list += (list.empty() ? "" : ", ") + numberText(wavelength);
        if (list.size() > 200) return list + ", ...";
    }
    return list;
}

}  // namespace

bool isNist(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    const std::vector<std::string> names = columnNamesOf(file.bytes().substr(0, 4096));
    return names.size() >= 6 && names[0] == "lambda" && names[1] == "thetai" &&
           names[3] == "thetar" && names[5].substr(0, 3) == "f_r";
}

Source readNist(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const double chosen = chosenWavelength(request);
    NamedTable table(file);
    if (table.names().size() < 6)
        throw lineError(file, table.line(),
                        Found(std::to_string(table.names().size()) + " columns").expected("6"));
    Source source;
    std::set<double> wavelengths;
    source.samples.reserve(mostRows(file, 6));
    while (table.next()) {
        const double wavelength = table.number(0);
        wavelengths.insert(wavelength);
        if (chosen > 0.0 && std::abs(wavelength - chosen) > kSameLaserLine) continue;
        addRow({directionFromDegrees(table.number(3), table.number(4)),
                directionFromDegrees(table.number(1), table.number(2)), Vec3d(table.number(5))},
               source.samples, source.report);
    }
    if (chosen > 0.0 && source.report.given == 0)
        throw Error(ErrorKind::usage, file.path(),
                    Found("no rows at " + request.choice + " um")
                        .expected("one of " + listOf(wavelengths)));
    source.description = "NIST BRDF, one channel, " +
                         (chosen > 0.0 ? request.choice : listOf(wavelengths)) + " um, 1/sr";
    if (chosen == 0.0 && wavelengths.size() > 1)
        source.assumptions.emplace_back("all wavelengths as one channel; FILE@UM takes one");
    source.assumptions.emplace_back("one channel as grey");
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
