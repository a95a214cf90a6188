// Astm.cpp - text files after ASTM E1392 as Cornell's Program of Computer Graphics publishes them.
// Header lines "KEY value" up to "VARS name,name,..."; NUM_POINTS is the number of rows. Rows are
// comma-separated. Angles theta_i, phi_i (0 where absent), theta_s, phi_s, both directions away
// from the surface; then R,G,B (linear), or X,Y,Z (to linear sRGB), or wavelengths NNNnm
// (Spectrum.h), or one value such as "Integrated[..]". Values in 1/sr without the cosine. From the
// readers of ALTA (plugin data_astm) and libbsdf (AstmReader); no such file was at hand. Cornell
// writes radians; a file with zenith angles above pi is taken to be in degrees, the unit of the
// standard itself.
#include "Formats.h"
#include "NumberRows.h"

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
    std::vector<double> wavelengths;
    std::optional<SpectrumToRgb> toRgb;
};

struct AstmHeader {
    long long points = -1;
    std::vector<std::string> names;
    size_t line = 0;  ///< of VARS
};

/// Reads up to VARS and leaves `lines` at the first row.
AstmHeader readHeader(LineReader& lines)
{
    AstmHeader header;
    std::string_view line;
    std::vector<std::string_view> words;
    while (header.names.empty() && lines.next(line)) {
        splitWords(line, words);
        if (words.size() >= 2 && words[0] == "NUM_POINTS") parseInteger(words[1], header.points);
        if (words.empty() || words[0] != "VARS") continue;
        const std::string_view list = line.substr(line.find("VARS") + 4);
        splitFields(list, list.find(',') == std::string_view::npos ? ' ' : ',', words);
        for (const std::string_view word : words)
            if (!word.empty()) header.names.emplace_back(word);
        header.line = lines.number();
    }
    return header;
}

/// Wavelength of a column named "532nm"; 0 for any other name.
double wavelengthOf(const std::string& name)
{
    double nm = 0.0;
    const std::string lower = lowerCase(name);
    const bool isOne = lower.size() > 2 && lower.substr(lower.size() - 2) == "nm" &&
                       parseNumber(std::string_view(lower).substr(0, lower.size() - 2), nm);
    return isOne ? nm : 0.0;
}

std::vector<std::string> valueNames(const AstmHeader& header, AstmLayout& layout)
{
    std::vector<std::string> names;
    for (size_t i = 0; i < header.names.size(); ++i) {
        const std::string& name = header.names[i];
        size_t* angle = name == "theta_i"   ? &layout.theta_i
                        : name == "phi_i"   ? &layout.phi_i
                        : name == "theta_s" ? &layout.theta_s
                        : name == "phi_s"   ? &layout.phi_s
                                            : nullptr;
        if (angle) {
            *angle = i;
            continue;
        }
        names.push_back(name);
        layout.valueColumns.push_back(i);
    }
    return names;
}

AstmLayout layoutOf(const InputFile& file, const AstmHeader& header)
{
    using Value = AstmLayout::Value;
    AstmLayout layout;
    layout.columns = header.names.size();
    const std::vector<std::string> names = valueNames(header, layout);
    for (const std::string& name : names) layout.wavelengths.push_back(wavelengthOf(name));
    const bool spectral =
        !names.empty() && std::all_of(layout.wavelengths.begin(), layout.wavelengths.end(),
                                      [](double nm) { return nm > 0.0; });
    if (names == std::vector<std::string>{"R", "G", "B"})
        layout.value = Value::rgb;
    else if (names == std::vector<std::string>{"X", "Y", "Z"})
        layout.value = Value::xyz;
    else if (spectral)
        layout.value = Value::spectrum;
    else if (names.size() != 1)
        throw lineError(file, header.line,
                        "found " + std::to_string(names.size()) +
                            " value columns, expected R,G,B or X,Y,Z or "
                            "wavelengths NNNnm or one value");
    for (const size_t angle : {layout.theta_i, layout.theta_s, layout.phi_s})
        if (angle == kAbsent)
            throw lineError(file, header.line, "found no theta_i, theta_s or phi_s, expected them");
    if (spectral) layout.toRgb.emplace(layout.wavelengths);
    return layout;
}

Vec3d valueOf(const AstmLayout& layout, const std::vector<double>& numbers)
{
    std::vector<double> values;
    for (const size_t column : layout.valueColumns) values.push_back(numbers[column]);
    switch (layout.value) {
        case AstmLayout::Value::rgb: return {values[0], values[1], values[2]};
        case AstmLayout::Value::xyz: return linearSrgbFromXyz({values[0], values[1], values[2]});
        case AstmLayout::Value::spectrum: return (*layout.toRgb)(values.data());
        case AstmLayout::Value::single: break;
    }
    return Vec3d(values[0]);
}

void countOutOfGamut(const AstmLayout& layout, Source& source)
{
    if (layout.value == AstmLayout::Value::xyz || layout.value == AstmLayout::Value::spectrum)
        source.report.outOfGamut = source.report.negative;
}

}  // namespace

bool isAstm(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes().substr(0, 16384));
    const AstmHeader header = readHeader(lines);
    return std::count(header.names.begin(), header.names.end(), "theta_i") == 1;
}

Source readAstm(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    const AstmHeader header = readHeader(lines);
    if (header.names.empty()) throw inputError(file, "found no VARS line, expected one");
    const AstmLayout layout = layoutOf(file, header);
    AngleRows rows;
    long long count = 0;
    std::string_view line;
    std::vector<std::string_view> fields;
    std::vector<double> numbers;
    for (; lines.nextData(line); ++count) {
        splitFields(line, ',', fields);
        if (fields.size() != layout.columns)
            throw lineError(file, lines.number(),
                            "found " + std::to_string(fields.size()) + " fields, expected " +
                                std::to_string(layout.columns) + " as in VARS");
        parseNumbers(file, lines.number(), fields, numbers);
        rows.add(numbers[layout.theta_i], layout.phi_i == kAbsent ? 0.0 : numbers[layout.phi_i],
                 numbers[layout.theta_s], numbers[layout.phi_s], valueOf(layout, numbers));
    }
    if (header.points >= 0 && header.points != count)
        throw inputError(file, "found " + std::to_string(count) + " rows, expected NUM_POINTS " +
                                   std::to_string(header.points));
    Source source;
    rows.addTo(source);
    countOutOfGamut(layout, source);
    source.isotropic = layout.phi_i == kAbsent;
    source.description = std::string("ASTM E1392 samples, angles in ") +
                         (rows.inDegrees() ? "degrees" : "radians") + ", 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
