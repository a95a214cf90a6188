// Astm.cpp - text files after ASTM E1392 as Cornell's Program of Computer Graphics publishes them.
// Header lines "KEY value" up to "VARS name,name,..."; NUM_POINTS is the number of rows. Keys and
// names are compared without case, a ':' or '=' may follow a key. Names and rows are separated by
// commas, semicolons, tabs or blanks (Fields.h), each in its own way. Angles theta_i, phi_i (0
// where absent), theta_s, phi_s (or _r, _o), both directions away from the surface; then R, G, B
// (linear), or X, Y, Z (to linear sRGB, white D65), or wavelengths NNNnm or N.NNum, or one value
// such as "Integrated[..]". Values in 1/sr without the cosine. From the readers of ALTA (plugin
// data_astm) and libbsdf (AstmReader); no such file was at hand. Cornell writes radians; a file
// with zenith angles above pi is taken to be in degrees, the unit of the standard itself, unless
// the names of angles tell the unit (ColumnName.h). FILE@550 takes one of several wavelengths.
#include "ColumnName.h"
#include "Formats.h"
#include "NumberRows.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>
#include <optional>

namespace fbrdf {
namespace {

constexpr size_t kAbsent = size_t(-1);

struct AstmLayout {
    size_t columns = 0;
    size_t theta_i = kAbsent, phi_i = kAbsent, theta_s = kAbsent, phi_s = kAbsent;
    enum class Value { single, rgb, xyz, spectrum } value = Value::single;
    std::vector<size_t> valueColumns;
    std::optional<BandColour> colour;
    std::optional<double> degrees;  ///< in the unit that the names of the angles tell
};

struct AstmHeader {
    long long points = -1;
    std::vector<std::string> names;
    size_t line = 0;  ///< of VARS
};

/// The rest of a line after its first word, which is `key` in any case.
std::optional<std::string_view> afterKey(std::string_view line, std::string_view key)
{
    line = trimmed(line);
    if (!sameWord(line.substr(0, key.size()), key)) return {};
    line.remove_prefix(key.size());
    if (!line.empty() && std::string_view(" \t:=,;").find(line.front()) == std::string_view::npos)
        return {};
    line.remove_prefix(std::min(line.find_first_not_of(" \t:=,;"), line.size()));
    return trimmed(line);
}

/// Reads up to VARS and leaves `lines` at the first row.
AstmHeader readHeader(LineReader& lines)
{
    AstmHeader header;
    std::string_view line;
    std::vector<std::string_view> words;
    while (header.names.empty() && lines.next(line)) {
        if (const auto points = afterKey(line, "NUM_POINTS")) parseInteger(*points, header.points);
        const auto list = afterKey(line, "VARS");
        if (!list) continue;
        splitFields(*list, separatorOfNames(*list), words);
        for (const std::string_view word : words)
            if (!word.empty()) header.names.emplace_back(word);
        header.line = lines.number();
    }
    return header;
}

size_t* angleNamed(AstmLayout& layout, const std::string& base)
{
    if (base == "theta_i") return &layout.theta_i;
    if (base == "phi_i") return &layout.phi_i;
    for (const char* scattered : {"_s", "_r", "_o"}) {
        if (base == std::string("theta") + scattered) return &layout.theta_s;
        if (base == std::string("phi") + scattered) return &layout.phi_s;
    }
    return nullptr;
}

/// Sets the columns of angles and of values. Returns the names of the latter, lower case.
std::vector<std::string> placeColumns(const InputFile& file, const AstmHeader& header,
                                      AstmLayout& layout)
{
    std::vector<std::string> names;
    for (size_t i = 0; i < header.names.size(); ++i) {
        const ColumnName name = columnNameOf(header.names[i]);
        size_t* angle = angleNamed(layout, name.base);
        if (!angle) {
            names.push_back(lowerCase(header.names[i]));
            layout.valueColumns.push_back(i);
            continue;
        }
        *angle = i;
        const std::optional<double> degrees = degreesIn(name.unit);
        if (!degrees || (layout.degrees && *layout.degrees != *degrees))
            throw lineError(file, header.line,
                            Found(inQuotes(header.names[i]))
                                .expected("all angles in degrees or all in radians"));
        if (!name.unit.empty()) layout.degrees = degrees;
    }
    return names;
}

/// Puts the columns in the order of `letters` where the names are these, each once.
bool arrange(const std::vector<std::string>& names, std::string_view letters, AstmLayout& layout)
{
    std::vector<size_t> ordered;
    for (const char letter : letters) {
        const auto found = std::find(names.begin(), names.end(), std::string(1, letter));
        if (found == names.end() || names.size() != letters.size()) return false;
        ordered.push_back(layout.valueColumns[size_t(found - names.begin())]);
    }
    layout.valueColumns = ordered;
    return true;
}

AstmLayout layoutOf(const FileRequest& request, const AstmHeader& header)
{
    using Value = AstmLayout::Value;
    const InputFile& file = *request.file;
    AstmLayout layout;
    layout.columns = header.names.size();
    const std::vector<std::string> names = placeColumns(file, header, layout);
    std::vector<double> wavelengths;
    for (const std::string& name : names) wavelengths.push_back(wavelengthNamed(name));
    const bool spectral = !names.empty() && std::all_of(wavelengths.begin(), wavelengths.end(),
                                                        [](double nm) { return nm > 0.0; });
    if (arrange(names, "rgb", layout))
        layout.value = Value::rgb;
    else if (arrange(names, "xyz", layout))
        layout.value = Value::xyz;
    else if (spectral)
        layout.value = Value::spectrum;
    else if (names.size() != 1)
        throw lineError(file, header.line,
                        Found(std::to_string(names.size()) + " value columns")
                            .expected("R,G,B or X,Y,Z or wavelengths NNNnm or one value"));
    for (const size_t angle : {layout.theta_i, layout.theta_s, layout.phi_s})
        if (angle == kAbsent)
            throw lineError(file, header.line,
                            Found("no theta_i, theta_s or phi_s").expected("them"));
    if (spectral) layout.colour.emplace(request, wavelengths);
    if (!spectral && !request.choice.empty())
        throw Error(ErrorKind::usage, file.path(),
                    Found("the choice " + inQuotes(request.choice))
                        .expected("none: the file has no wavelengths"));
    return layout;
}

Vec3d valueOf(const AstmLayout& layout, const std::vector<double>& numbers)
{
    std::vector<double> values;
    for (const size_t column : layout.valueColumns) values.push_back(numbers[column]);
    switch (layout.value) {
        case AstmLayout::Value::rgb: return {values[0], values[1], values[2]};
        case AstmLayout::Value::xyz: return linearSrgbFromXyz({values[0], values[1], values[2]});
        case AstmLayout::Value::spectrum: return (*layout.colour)(values.data());
        case AstmLayout::Value::single: break;
    }
    return Vec3d(values[0]);
}

void countOutOfGamut(const AstmLayout& layout, Source& source)
{
    if (layout.value == AstmLayout::Value::xyz || (layout.colour && layout.colour->isSpectral()))
        source.report.outOfGamut = source.report.negative;
}

/// Adds the rows below the header. Returns how many there are.
long long readRows(const InputFile& file, LineReader& lines, AstmLayout& layout, AngleRows& rows)
{
    long long count = 0;
    std::string_view line;
    std::vector<std::string_view> fields;
    std::vector<double> numbers;
    for (; lines.nextData(line); ++count) {
        splitNumbers(line, fields);
        if (fields.size() != layout.columns)
            throw lineError(file, lines.number(),
                            Found(std::to_string(fields.size()) + " fields")
                                .expected(std::to_string(layout.columns) + " as in VARS"));
        parseNumbers(file, lines.number(), fields, numbers);
        rows.add(numbers[layout.theta_i], layout.phi_i == kAbsent ? 0.0 : numbers[layout.phi_i],
                 numbers[layout.theta_s], numbers[layout.phi_s], valueOf(layout, numbers));
    }
    return count;
}

void noteAssumptions(const AstmLayout& layout, const AngleRows& rows, Source& source)
{
    if (layout.colour) source.assumptions = layout.colour->assumptions();
    if (!layout.degrees) source.assumptions.push_back(rows.assumption());
    if (layout.value == AstmLayout::Value::xyz)
        source.assumptions.emplace_back("white of X, Y, Z is D65");
    if (layout.value == AstmLayout::Value::single)
        source.assumptions.emplace_back("one channel as grey");
    if (source.isotropic) source.assumptions.emplace_back("isotropic, as there is no phi_i");
}

}  // namespace

bool isAstm(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes().substr(0, 16384));
    const AstmHeader header = readHeader(lines);
    return std::count_if(header.names.begin(), header.names.end(), [](const std::string& name) {
               return columnNameOf(name).base == "theta_i";
           }) == 1;
}

Source readAstm(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    const AstmHeader header = readHeader(lines);
    if (header.names.empty()) throw inputError(file, Found("no VARS line").expected("one"));
    AstmLayout layout = layoutOf(request, header);
    AngleRows rows(layout.degrees);
    rows.reserve(mostRows(file, layout.columns));
    const long long count = readRows(file, lines, layout, rows);
    if (header.points >= 0 && header.points != count)
        throw inputError(file, Found(std::to_string(count) + " rows")
                                   .expected("NUM_POINTS " + std::to_string(header.points)));
    Source source;
    rows.addTo(source);
    countOutOfGamut(layout, source);
    source.isotropic = layout.phi_i == kAbsent;
    source.description = std::string("ASTM E1392 samples, angles in ") +
                         (rows.inDegrees() ? "degrees" : "radians") + ", 1/sr";
    if (layout.colour) source.description += ", " + layout.colour->description();
    noteAssumptions(layout, rows, source);
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
