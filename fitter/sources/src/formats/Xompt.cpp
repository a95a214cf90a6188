// Xompt.cpp - BRDF tables of ASAM OpenMATERIAL 3D (.xompt; schema material_brdf_schema.json 1.0).
// JSON: brdf.wavelengths in metres, and brdf.lookupTable, rows of [wavelength in metres, zenith
// angle of incidence, exit zenith angle, exit azimuth relative to that of incidence, BRDF in 1/sr],
// angles in radians; null where a number is missing. Rows of one pair of directions are the bands
// of one sample, which become linear sRGB; FILE@905 takes one wavelength. The schema measures the
// exit azimuth from the incident ray; it is taken as that of the direction towards the light, so
// that 0 is back-scatter and pi the mirror. The numbers are collected while the text is parsed, so
// that no document of it is held.
#include "Formats.h"
#include "SampleRow.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fbrdf {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
using XomptRow = std::array<double, 5>;
enum XomptColumn : size_t { wavelength, thetaIn, thetaOut, azimuth, value };

/// Collects the rows of lookupTable. A row of another length ends the parsing.
class RowCollector : public nlohmann::json_sax<nlohmann::json> {
public:
    std::vector<XomptRow> rows;
    std::string problem;

    bool null() override { return add(kMissing); }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t number) override { return add(double(number)); }
    bool number_unsigned(number_unsigned_t number) override { return add(double(number)); }
    bool number_float(number_float_t number, const string_t&) override { return add(number); }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(size_t) override { return deeper(); }
    bool end_object() override { return shallower(); }
    bool key(string_t& name) override
    {
        table_ = name == "lookupTable";
        arrays_ = 0;
        return true;
    }
    bool start_array(size_t) override
    {
        if (table_) ++arrays_;
        count_ = 0;
        return deeper();
    }
    bool end_array() override
    {
        if (arrays_ == 2 && count_ != row_.size())
            return fail(Found("a row of " + std::to_string(count_) + " numbers").expected("5"));
        if (arrays_ == 2) rows.push_back(row_);
        if (arrays_ > 0) --arrays_;
        count_ = 0;
        return shallower();
    }
    bool parse_error(size_t position, const std::string&,
                     const nlohmann::detail::exception&) override
    {
        return fail(Found("no JSON at byte " + std::to_string(position)).expected("it"));
    }

private:
    bool add(double number)
    {
        if (!table_ || arrays_ != 2) return true;
        if (count_ < row_.size()) row_[count_] = number;
        ++count_;
        return true;
    }
    /// The parser keeps a bit for each level.
    bool deeper()
    {
        constexpr size_t kDeepestJson = 64;
        return ++depth_ <= kDeepestJson ||
               fail(Found("more than 64 levels of JSON").expected("fewer"));
    }
    bool shallower()
    {
        --depth_;
        return true;
    }
    bool fail(const std::string& what)
    {
        if (problem.empty()) problem = what;
        return false;
    }

    XomptRow row_{};
    bool table_ = false;
    size_t arrays_ = 0, count_ = 0, depth_ = 0;
};

std::vector<XomptRow> readRows(const InputFile& file)
{
    RowCollector collector;
    const std::string_view bytes = file.bytes();
    nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &collector);
    if (!collector.problem.empty()) throw inputError(file, collector.problem);
    if (collector.rows.empty())
        throw inputError(file, Found("no row in lookupTable").expected("one"));
    return std::move(collector.rows);
}

std::vector<double> wavelengthsOf(const InputFile& file, const std::vector<XomptRow>& rows)
{
    std::vector<double> wavelengths;
    for (const XomptRow& row : rows) {
        if (!std::isfinite(row[wavelength]))
            throw inputError(file, Found("a row without its wavelength").expected("a number"));
        if (wavelengths.empty() || wavelengths.back() != row[wavelength])
            wavelengths.push_back(row[wavelength]);
    }
    std::sort(wavelengths.begin(), wavelengths.end());
    wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
    constexpr size_t kMostBands = 4096;
    if (wavelengths.size() > kMostBands)
        throw inputError(
            file,
            Found(std::to_string(wavelengths.size()) + " wavelengths").expected("at most 4096"));
    return wavelengths;
}

bool samePair(const XomptRow& a, const XomptRow& b)
{
    return a[thetaIn] == b[thetaIn] && a[thetaOut] == b[thetaOut] && a[azimuth] == b[azimuth];
}

/// Sorts rows so that those of a pair of directions are neighbours. Missing angles come last.
void sortByPair(std::vector<XomptRow>& rows)
{
    const auto key = [](const XomptRow& row) {
        std::array<double, 3> angles{row[thetaIn], row[thetaOut], row[azimuth]};
        for (double& angle : angles)
            if (std::isnan(angle)) angle = std::numeric_limits<double>::infinity();
        return angles;
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const XomptRow& a, const XomptRow& b) { return key(a) < key(b); });
}

void addPairs(const std::vector<XomptRow>& rows, const std::vector<double>& wavelengths,
              const BandColour& colour, Source& source)
{
    std::vector<double> bands;
    for (size_t first = 0, end = 0; first < rows.size(); first = end) {
        bands.assign(wavelengths.size(), colour.isSpectral() ? kMissing : 0.0);
        bool chosen = colour.isSpectral();
        for (end = first; end < rows.size() && (end == first || samePair(rows[first], rows[end]));
             ++end) {
            const auto band =
                std::lower_bound(wavelengths.begin(), wavelengths.end(), rows[end][wavelength]);
            const auto index = size_t(band - wavelengths.begin());
            bands[index] = rows[end][value];
            chosen = chosen || index == colour.chosen();
        }
        if (!chosen) continue;
        const XomptRow& row = rows[first];
        addRow({directionFromAngles(row[thetaOut], row[azimuth]),
                directionFromAngles(row[thetaIn], 0.0), colour(bands.data())},
               source.samples, source.report);
    }
}

}  // namespace

bool isXompt(const InputFile& file)
{
    const std::string_view head = file.bytes().substr(0, 4096);
    if (!looksLikeText(head) ||
        trimmed(head.substr(0, head.find_first_not_of(" \t\r\n") + 1)) != "{")
        return false;
    const std::string lower = lowerCase(head);
    return lower.find("openmaterial") != std::string::npos ||
           lower.find("lookuptable") != std::string::npos;
}

Source readXompt(const FileRequest& request)
{
    std::vector<XomptRow> rows = readRows(*request.file);
    const std::vector<double> wavelengths = wavelengthsOf(*request.file, rows);
    const BandColour colour(request, wavelengths);
    sortByPair(rows);
    Source source;
    addPairs(rows, wavelengths, colour, source);
    if (colour.isSpectral()) source.report.outOfGamut = source.report.negative;
    source.isotropic = true;
    source.description = "OpenMATERIAL 3D table, " + colour.description() + ", 1/sr";
    if (!colour.isSpectral()) source.assumptions.emplace_back("one band as grey");
    source.assumptions.emplace_back("azimuth 0 is back towards the light");
    requireSamples(source, request.file->path());
    return source;
}

}  // namespace fbrdf
