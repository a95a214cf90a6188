// Csv.cpp - the project's own text format for scattered samples.
// A header names the columns, '#' starts a comment line. Directions are wo_x,wo_y,wo_z and
// wi_x,wi_y,wi_z (any length), or theta_i,phi_i,theta_o,phi_o in degrees: zenith angle and azimuth
// of wi and wo, both away from the surface, in the frame of Conventions.h. Values are r,g,b or one
// `value`, in 1/sr; without the cosine, or times cos theta_o when SourceOptions::cosine says so.
// `weight` is optional; further columns are skipped unread.
#include "Formats.h"
#include "SampleRow.h"
#include "Text.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <array>

namespace fbrdf {
namespace {

enum Column {
    wo_x,
    wo_y,
    wo_z,
    wi_x,
    wi_y,
    wi_z,
    theta_i,
    phi_i,
    theta_o,
    phi_o,
    r,
    g,
    b,
    value,
    weight,
    kColumnCount
};

constexpr std::array<const char*, kColumnCount> kColumnNames = {
    "wo_x",    "wo_y",  "wo_z", "wi_x", "wi_y", "wi_z",  "theta_i", "phi_i",
    "theta_o", "phi_o", "r",    "g",    "b",    "value", "weight"};

constexpr int kUnused = -1;

/// What the fields of a row mean.
struct Layout {
    std::vector<int> columnOfField;  ///< Column, or kUnused
    bool directions = false;         ///< wo_x..wi_z, else angles
    bool colour = false;             ///< r,g,b, else value
};

using Values = std::array<double, kColumnCount>;

int columnNamed(const std::string& name)
{
    const auto found = std::find(kColumnNames.begin(), kColumnNames.end(), name);
    return found == kColumnNames.end() ? kUnused : static_cast<int>(found - kColumnNames.begin());
}

std::vector<int> columnsOf(std::string_view header)
{
    std::vector<std::string_view> fields;
    splitFields(header, ',', fields);
    std::vector<int> columns;
    for (const std::string_view field : fields) columns.push_back(columnNamed(lowerCase(field)));
    return columns;
}

bool hasAll(const std::vector<int>& columns, int first, int last)
{
    for (int column = first; column <= last; ++column)
        if (std::count(columns.begin(), columns.end(), column) == 0) return false;
    return true;
}

void forget(std::vector<int>& columns, int first, int last)
{
    for (int& column : columns)
        if (column >= first && column <= last) column = kUnused;
}

bool hasGeometry(const std::vector<int>& columns)
{
    return hasAll(columns, wo_x, wi_z) || hasAll(columns, theta_i, phi_o);
}

void requireUnique(const InputFile& file, size_t line, const std::vector<int>& columns)
{
    for (int column = 0; column < kColumnCount; ++column)
        if (std::count(columns.begin(), columns.end(), column) > 1)
            throw lineError(file, line,
                            "found column '" + std::string(kColumnNames[size_t(column)]) +
                                "' twice, expected each name once");
}

Layout layoutOf(const InputFile& file, size_t line, std::string_view header)
{
    Layout layout;
    layout.columnOfField = columnsOf(header);
    std::vector<int>& columns = layout.columnOfField;
    requireUnique(file, line, columns);
    layout.directions = hasAll(columns, wo_x, wi_z);
    layout.colour = hasAll(columns, r, b);
    if (!hasGeometry(columns))
        throw lineError(file, line,
                        "found the header " + quoted(header) +
                            ", expected columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z or "
                            "theta_i,phi_i,theta_o,phi_o");
    if (!layout.colour && !hasAll(columns, value, value))
        throw lineError(file, line,
                        "found the header " + quoted(header) + ", expected columns r,g,b or value");
    if (layout.directions) forget(columns, theta_i, phi_o);
    if (layout.colour) forget(columns, value, value);
    return layout;
}

/// Fills `values` from one line, walking it once.
void parseRow(const InputFile& file, size_t number, std::string_view line, const Layout& layout,
              Values& values)
{
    const size_t fields = layout.columnOfField.size();
    for (size_t field = 0; field < fields; ++field) {
        const size_t comma = line.find(',');
        const bool last = field + 1 == fields;
        if (last != (comma == std::string_view::npos))
            throw lineError(file, number,
                            std::string(last ? "found more" : "found fewer") +
                                " fields, expected " + std::to_string(fields) +
                                " as in the header");
        const int column = layout.columnOfField[field];
        const std::string_view text = trimmed(line.substr(0, comma));
        if (column != kUnused && !parseNumber(text, values[size_t(column)]))
            throw lineError(file, number,
                            "found " + quoted(text) + " as " + kColumnNames[size_t(column)] +
                                ", expected a number");
        if (!last) line.remove_prefix(comma + 1);
    }
}

SampleRow rowOf(const Values& v, const Layout& layout, bool cosine)
{
    SampleRow row;
    if (layout.directions) {
        row.wo = {v[wo_x], v[wo_y], v[wo_z]};
        row.wi = {v[wi_x], v[wi_y], v[wi_z]};
    } else {
        row.wo = directionFromDegrees(v[theta_o], v[phi_o]);
        row.wi = directionFromDegrees(v[theta_i], v[phi_i]);
    }
    row.f = layout.colour ? Vec3d(v[r], v[g], v[b]) : Vec3d(v[value]);
    row.weight = v[weight];
    if (cosine) row.f *= glm::length(row.wo) / std::max(row.wo.z, kHorizonCosine);
    return row;
}

}  // namespace

bool isCsv(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view header;
    return lines.nextData(header) && hasGeometry(columnsOf(header));
}

Source readCsv(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    std::string_view line;
    if (!lines.nextData(line)) throw inputError(file, "found no line of data, expected a header");
    const Layout layout = layoutOf(file, lines.number(), line);
    Source source;
    Values values{};
    values[weight] = 1.0;
    while (lines.nextData(line)) {
        parseRow(file, lines.number(), line, layout, values);
        addRow(rowOf(values, layout, request.options.cosine), source.samples, source.report);
    }
    source.description = std::string("scattered samples, ") +
                         (layout.colour ? "linear RGB" : "one channel") + ", 1/sr" +
                         (request.options.cosine ? " (cos theta_o divided out)" : "");
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
