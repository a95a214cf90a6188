// Speos.cpp - the two text formats of Ansys Speos (OPTIS) for scattering surfaces, reflection only.
// Both start with a title "OPTIS - brdf surface file v8.0" or "OPTIS - Anisotropic BSDF surface
// file v8.0", the mode (0: text), a comment, and a description behind its length.
//   .brdf             flags of reflection and transmission; type of values; counts of incidences
//   and
//                     of wavelengths, and the lists (degrees, nm); then for each side, incidence
//                     and wavelength the total in percent and a table.
//   .anisotropicbsdf  the vector of anisotropy; the flags and the type; the count and list of
//   angles
//                     of anisotropy, and for each of these that of incidences; zenith angle and
//                     azimuth at which the spectrum was measured; a line for people; the count of
//                     wavelengths, and for each its total in percent; then a table for each angle
//                     of anisotropy and incidence.
// A table has the counts of zenith angles and azimuths, a line of azimuths, and lines of a zenith
// angle and its values. Azimuth 0 is towards the mirror direction. Values of type 1 are
// proportional to f, those of type 0 to f cos theta; the total, the integral of f cos theta, sets
// the scale. In the anisotropic format it does so for the incidence at which the spectrum was
// measured, and other incidences keep their proportion to that one. From the comments of Ansys'
// converters (optical-automation), and from a surface that they wrote for Zemax as well: for one
// incidence the two differ by a factor that does not depend on the direction.
#include "Formats.h"
#include "formats/SpeosText.h"
#include "SampleRow.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fbrdf {
namespace {

constexpr size_t kMostIncidences = 10000;

/// One direction of the light, for which the file has a table at each wavelength, or one for all.
struct SpeosIncidence {
    double theta = 0.0, turn = 0.0;  ///< degrees; the sample is turned by the latter
    uint64_t first = 0;              ///< row of its first node
    size_t grid = 0;                 ///< index of the nodes of its tables
};

/// Tables and grids are shared where they are equal: files may have millions of small ones.
struct SpeosSurface {
    std::vector<SpeosIncidence> incidences;
    std::vector<SpeosGrid> grids;
    size_t tables = 1;           ///< of each incidence
    std::vector<float> values;   ///< incidences x tables x nodes, nodes fastest
    std::vector<double> scales;  ///< f of a value: incidences x tables, or bands of all incidences
    std::optional<BandColour> colour;
    bool timesCosine = false;

    const SpeosGrid& gridOf(const SpeosIncidence& incidence) const { return grids[incidence.grid]; }
    const float* tableOf(const SpeosIncidence& incidence, size_t table) const
    {
        return values.data() + incidence.first * tables + table * gridOf(incidence).nodes();
    }
    uint64_t rows() const { return incidences.back().first + gridOf(incidences.back()).nodes(); }
};

/// What a value of 1 stands for, so that the table has its total.
double scaleOf(const SpeosGrid& grid, const float* values, double percent, bool timesCosine)
{
    const double integral = grid.integral(values, !timesCosine);
    return integral > 0.0 ? percent / 100.0 / integral : 0.0;
}

/// Reads the first table of an incidence, behind those of the incidences before it.
void readFirstTable(SpeosText& text, SpeosSurface& surface, SpeosIncidence& incidence)
{
    incidence.first = surface.values.size() / surface.tables;
    SpeosGrid grid = readSpeosTable(text, surface.values);
    if (surface.grids.empty() || !(surface.grids.back() == grid))
        surface.grids.push_back(std::move(grid));
    incidence.grid = surface.grids.size() - 1;
}

/// Reads the table of a further wavelength.
void readNextTable(SpeosText& text, SpeosSurface& surface, const SpeosIncidence& incidence)
{
    if (!(readSpeosTable(text, surface.values) == surface.gridOf(incidence)))
        throw text.fail(Found("other angles").expected("those of the first wavelength"));
}

void readSpectralTables(SpeosText& text, SpeosSurface& surface)
{
    for (SpeosIncidence& incidence : surface.incidences)
        for (size_t w = 0; w < surface.tables; ++w) {
            const double percent = text.number("a total in percent");
            if (w == 0)
                readFirstTable(text, surface, incidence);
            else
                readNextTable(text, surface, incidence);
            surface.scales.push_back(scaleOf(surface.gridOf(incidence),
                                             surface.tableOf(incidence, w), percent,
                                             surface.timesCosine));
        }
}

SpeosSurface readSpectral(const FileRequest& request, SpeosText& text)
{
    SpeosSurface surface;
    surface.values.reserve(request.file->size() / 2);  // a number and a blank: more than there are
    surface.timesCosine = readSpeosFlags(text).times_cosine;
    const size_t incidences = text.count("a count of incidences", 1, kMostIncidences);
    const size_t wavelengths = text.count("a count of wavelengths", 1, kMostIncidences);
    for (const double theta : text.numbers(incidences, "incidences"))
        surface.incidences.push_back({theta, 0.0, 0, 0});
    surface.colour.emplace(request, text.numbers(wavelengths, "wavelengths"));
    surface.tables = wavelengths;
    readSpectralTables(text, surface);
    return surface;
}

/// The incidence of the first angle of anisotropy that is nearest to an angle.
const SpeosIncidence& nearestIncidence(const SpeosSurface& surface, double theta)
{
    return *std::min_element(surface.incidences.begin(), surface.incidences.end(),
                             [&](const SpeosIncidence& a, const SpeosIncidence& b) {
                                 return std::abs(a.theta - theta) < std::abs(b.theta - theta);
                             });
}

SpeosSurface readAnisotropic(const FileRequest& request, SpeosText& text)
{
    SpeosSurface surface;
    surface.values.reserve(request.file->size() / 2);
    text.numbers(3, "the vector of anisotropy");
    surface.timesCosine = readSpeosFlags(text).times_cosine;
    const size_t turns = text.count("a count of angles of anisotropy", 1, kMostIncidences);
    for (const double turn : text.numbers(turns, "angles of anisotropy")) {
        const size_t incidences = text.count("a count of incidences", 1, kMostIncidences);
        for (const double theta : text.numbers(incidences, "incidences"))
            surface.incidences.push_back({theta, turn, 0, 0});
    }
    const double reference = text.number("the zenith angle of the spectrum");
    text.number("the azimuth of the spectrum");
    text.line();
    text.line();  // a comment on the spectrum
    const size_t wavelengths = text.count("a count of wavelengths", 1, kMostIncidences);
    const std::vector<double> spectrum = text.numbers(2 * wavelengths, "the spectrum");
    std::vector<double> bands(wavelengths);
    for (size_t w = 0; w < wavelengths; ++w) bands[w] = spectrum[2 * w];
    surface.colour.emplace(request, bands);
    for (SpeosIncidence& incidence : surface.incidences) readFirstTable(text, surface, incidence);
    const SpeosIncidence& measured = nearestIncidence(surface, reference);
    for (size_t w = 0; w < wavelengths; ++w)
        surface.scales.push_back(scaleOf(surface.gridOf(measured), surface.tableOf(measured, 0),
                                         spectrum[2 * w + 1], surface.timesCosine));
    return surface;
}

/// f at a node, before the cosine is divided out.
Vec3d valueAt(const SpeosSurface& surface, size_t incidence, size_t node,
              std::vector<double>& bands)
{
    const bool shared = surface.tables == 1;  // one table for all bands
    bands.resize(surface.colour->bands());
    for (size_t b = 0; b < bands.size(); ++b) {
        const float* table = surface.tableOf(surface.incidences[incidence], shared ? 0 : b);
        const size_t scale =
            surface.scales.size() == bands.size() ? b : incidence * bands.size() + b;
        bands[b] = surface.scales[scale] * double(table[node]);
    }
    return (*surface.colour)(bands.data());
}

void readRowsOf(const SpeosSurface& surface, uint64_t first, size_t count,
                std::vector<Sample>& samples, SampleReport& report)
{
    std::vector<double> bands;
    for (uint64_t row = first; row < first + count; ++row) {
        const auto after = std::upper_bound(
            surface.incidences.begin(), surface.incidences.end(), row,
            [](uint64_t r, const SpeosIncidence& incidence) { return r < incidence.first; });
        const SpeosIncidence& incidence = *(after - 1);
        const SpeosGrid& grid = surface.gridOf(incidence);
        const auto node = static_cast<size_t>(row - incidence.first);
        const size_t t = node / grid.phi.size(), p = node % grid.phi.size();
        const Vec3d wo = directionFromDegrees(grid.theta[t], grid.phi[p] + incidence.turn);
        Vec3d f = valueAt(surface, size_t(after - surface.incidences.begin()) - 1, node, bands);
        if (surface.timesCosine) f /= std::max(wo.z, kHorizonCosine);
        addRow({wo, speosLight(incidence.theta, incidence.turn), f, grid.weight(t, p)}, samples,
               report);
    }
}

Source sourceOf(const FileRequest& request, SpeosSurface read, const char* name)
{
    const auto surface = std::make_shared<const SpeosSurface>(std::move(read));
    Source source;
    source.description = std::string(name) + ", " + surface->colour->description() + ", 1/sr" +
                         (surface->timesCosine ? " (cos theta_o divided out)" : "");
    source.assumptions = surface->colour->assumptions();
    source.assumptions.emplace_back("the reflection; transmission is not read");
    source.assumptions.emplace_back("azimuth 0 is towards the mirror direction");
    source.stream.rows = surface->rows();
    source.stream.read = [surface](uint64_t first, size_t count, std::vector<Sample>& samples,
                                   SampleReport& report) {
        readRowsOf(*surface, first, count, samples, report);
    };
    requireSamples(source, request.file->path());
    return source;
}

bool startsWithTitle(const InputFile& file, const char* kind)
{
    if (!looksLikeText(file.bytes())) return false;
    const std::string line = lowerCase(file.bytes().substr(0, 80));
    return line.substr(0, 5) == "optis" && line.find(kind) != std::string::npos;
}

}  // namespace

bool isSpeos(const InputFile& file)
{
    return startsWithTitle(file, "brdf surface file") || startsWithTitle(file, "bsdf surface file");
}

Source readSpeos(const FileRequest& request)
{
    SpeosText text(*request.file);
    const bool anisotropic = startsWithTitle(*request.file, "anisotropic");
    readSpeosTitle(text);
    SpeosSurface surface =
        anisotropic ? readAnisotropic(request, text) : readSpectral(request, text);
    const bool oneTurn = std::all_of(
        surface.incidences.begin(), surface.incidences.end(),
        [&](const SpeosIncidence& i) { return i.turn == surface.incidences.front().turn; });
    Source source = sourceOf(request, std::move(surface),
                             anisotropic ? "Speos anisotropic BSDF" : "Speos spectral BRDF");
    source.isotropic = oneTurn;
    if (oneTurn) source.assumptions.emplace_back("isotropic, as there is one angle of anisotropy");
    return source;
}

}  // namespace fbrdf
