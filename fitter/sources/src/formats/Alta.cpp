// Alta.cpp - data of the ALTA library, as text and binary (Belcour, Barla, Pacanowski: "ALTA: a
// BRDF analysis library", MAM 2014). Header lines "#KEY value": #DIM nX nY; #PARAM_IN names the
// coordinates (AltaInputs.h), L is the light (wi) and V the view (wo), both away from the surface;
// #PARAM_OUT the values: INV_STERADIAN (1/sr), INV_STERADIAN_COSINE_FACTOR (times cos theta_V,
// divided out here), RGB_COLOR (linear), XYZ_COLOR (to linear sRGB). A file that does not declare
// both is refused: a cosine is not to be guessed. #VS tells how many columns of confidence follow,
// which are not read. Text has one row a sample. With "#FORMAT binary" there are #SAMPLE_COUNT rows
// after the line #ALTA_END_HEADER, each of nX + nY numbers and perhaps more, in the #ENDIAN
// "little" or "big" and the #PRECISION "ieee754-double" or "ieee754-single". This follows the
// documentation of ALTA and its reader.
#include "Formats.h"
#include "formats/AltaInputs.h"
#include "NumberRows.h"
#include "Tristimulus.h"

#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace fbrdf {
namespace {

enum class Output { inverseSteradian, withCosine, rgb, xyz };
const std::map<std::string, Output> kOutputs = {
    {"INV_STERADIAN", Output::inverseSteradian},
    {"INV_STERADIAN_COSINE_FACTOR", Output::withCosine},
    {"RGB_COLOR", Output::rgb},
    {"XYZ_COLOR", Output::xyz},
};

struct AltaLayout {
    const AltaInput* input = nullptr;
    Output output = Output::inverseSteradian;
    size_t values = 1;  ///< 1 or 3

    size_t columns() const { return input->dimension + values; }
};

struct AltaHeader {
    std::map<std::string, std::vector<std::string>> lines;
    size_t end = 0;  ///< byte after the line that ends the header; 0 where none does

    /// First word after a key, empty where there is none.
    std::string first(const std::string& key) const
    {
        const auto found = lines.find(key);
        return found == lines.end() || found->second.empty() ? "" : found->second.front();
    }
};

bool endsHeader(std::string_view key)
{
    return key == "ALTA_END_HEADER" || key == "ALTA_HEADER_END";
}

/// Reads the lines that start with '#', blank ones among them.
AltaHeader readHeader(std::string_view text)
{
    constexpr size_t kLongestLine = 4096;
    AltaHeader header;
    std::vector<std::string_view> words;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.substr(at, kLongestLine).find_first_of("\r\n");
        const std::string_view line = trimmed(text.substr(at, end));
        if (!line.empty() && line.front() != '#') break;
        at = end == std::string_view::npos ? text.size() : at + end + 1;
        if (line.empty() || !looksLikeText(line)) continue;
        splitWords(line.substr(1), words);
        if (words.empty()) continue;
        header.lines[std::string(words[0])] = {words.begin() + 1, words.end()};
        if (!endsHeader(words[0])) continue;
        if (text.substr(at - 1, 2) == "\r\n") ++at;
        header.end = at;
        break;
    }
    return header;
}

std::string requireFirst(const InputFile& file, const AltaHeader& header, const std::string& key)
{
    const std::string word = header.first(key);
    if (word.empty())
        throw inputError(file, Found("no #" + key).expected("it: nothing is guessed"));
    return word;
}

const AltaInput& inputNamed(const InputFile& file, const std::string& name)
{
    std::string known;
    if (const AltaInput* input = altaInputNamed(name, known)) return *input;
    throw inputError(file, Found("#PARAM_IN " + inQuotes(name)).expected("one of " + known));
}

Output outputNamed(const InputFile& file, const std::string& name)
{
    const auto found = kOutputs.find(name);
    if (found == kOutputs.end())
        throw inputError(
            file,
            Found("#PARAM_OUT " + inQuotes(name))
                .expected("INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR, RGB_COLOR or XYZ_COLOR"));
    return found->second;
}

AltaLayout layoutOf(const InputFile& file, const AltaHeader& header)
{
    AltaLayout layout;
    layout.input = &inputNamed(file, requireFirst(file, header, "PARAM_IN"));
    layout.output = outputNamed(file, requireFirst(file, header, "PARAM_OUT"));
    requireFirst(file, header, "DIM");
    const std::vector<std::string>& dimensions = header.lines.at("DIM");
    long long x = 0, y = 0;
    const bool read =
        dimensions.size() == 2 && parseInteger(dimensions[0], x) && parseInteger(dimensions[1], y);
    const bool colour = layout.output == Output::rgb || layout.output == Output::xyz;
    if (!read || x != static_cast<long long>(layout.input->dimension) ||
        !(y == 3 || (y == 1 && !colour)))
        throw inputError(
            file, Found("#DIM " + inQuotes(dimensions.front()) + " ..")
                      .expected("two counts: " + std::to_string(layout.input->dimension) + " for " +
                                layout.input->name + (colour ? " and 3" : " and 1 or 3")));
    layout.values = static_cast<size_t>(y);
    return layout;
}

SampleRow rowOf(const AltaLayout& layout, const std::vector<double>& numbers)
{
    const DirectionPair<double> pair = layout.input->pair(numbers.data());
    const double* y = numbers.data() + layout.input->dimension;
    Vec3d f = layout.values == 3 ? Vec3d(y[0], y[1], y[2]) : Vec3d(y[0]);
    if (layout.output == Output::xyz) f = linearSrgbFromXyz(f, XyzWhite::d65);
    if (layout.output == Output::withCosine)
        f *= glm::length(pair.wo) / std::max(pair.wo.z, kHorizonCosine);
    return {pair.wo, pair.wi, f};
}

void readText(const InputFile& file, const AltaLayout& layout, Source& source)
{
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    std::vector<double> numbers;
    source.samples.reserve(mostRows(file, layout.columns()));
    while (lines.nextData(line)) {
        splitNumbers(line, words);
        if (words.size() < layout.columns())
            throw lineError(file, lines.number(),
                            Found(std::to_string(words.size()) + " numbers")
                                .expected("at least " + std::to_string(layout.columns())));
        parseNumbers(file, lines.number(), words, numbers);
        addRow(rowOf(layout, numbers), source.samples, source.report);
    }
}

/// How the numbers of a binary file are stored.
struct NumberFormat {
    size_t bytes = 8;
    bool big = false;
};

NumberFormat numberFormat(const InputFile& file, const AltaHeader& header)
{
    const std::string precision = lowerCase(header.first("PRECISION"));
    const std::string endian = lowerCase(header.first("ENDIAN"));
    NumberFormat format;
    if (precision == "ieee754-single" || precision == "ieee754-float")
        format.bytes = 4;
    else if (precision != "ieee754-double")
        throw inputError(file, Found("#PRECISION " + inQuotes(precision))
                                   .expected("ieee754-double or ieee754-single"));
    if (endian != "little" && endian != "big")
        throw inputError(file, Found("#ENDIAN " + inQuotes(endian)).expected("little or big"));
    format.big = endian == "big";
    return format;
}

double numberAt(const char* at, const NumberFormat& format)
{
    char raw[8];
    std::memcpy(raw, at, format.bytes);
    if (format.big) std::reverse(raw, raw + format.bytes);  // our machines are little endian
    if (format.bytes == 4) {
        float value = 0.0f;
        std::memcpy(&value, raw, sizeof value);
        return double(value);
    }
    double value = 0.0;
    std::memcpy(&value, raw, sizeof value);
    return value;
}

/// Numbers in each row, of which the layout needs the first.
size_t columnsOf(const InputFile& file, const AltaHeader& header, const AltaLayout& layout,
                 const NumberFormat& format)
{
    const std::string text = requireFirst(file, header, "SAMPLE_COUNT");
    long long rows = 0;
    if (!parseInteger(text, rows) || rows < 1)
        throw inputError(file, Found("#SAMPLE_COUNT " + inQuotes(text)).expected("at least 1"));
    const size_t numbers = (file.size() - header.end) / format.bytes;
    const size_t columns = numbers / static_cast<size_t>(rows);
    const bool whole =
        columns * static_cast<size_t>(rows) * format.bytes == file.size() - header.end;
    if (!whole || columns < layout.columns())
        throw inputError(file, header.end,
                         Found(std::to_string(file.size() - header.end) + " bytes of data")
                             .expected(text + " rows of at least " +
                                       std::to_string(layout.columns() * format.bytes) + " bytes"));
    return columns;
}

void readBinary(const InputFile& file, const AltaHeader& header, const AltaLayout& layout,
                Source& source)
{
    if (header.end == 0)
        throw inputError(file, Found("no line #ALTA_END_HEADER").expected("it before binary data"));
    const NumberFormat format = numberFormat(file, header);
    const size_t columns = columnsOf(file, header, layout, format);
    std::vector<double> numbers(layout.columns());
    source.samples.reserve((file.size() - header.end) / (columns * format.bytes));
    for (size_t at = header.end; at < file.size(); at += columns * format.bytes) {
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = numberAt(file.bytes().data() + at + i * format.bytes, format);
        addRow(rowOf(layout, numbers), source.samples, source.report);
    }
}

void noteAssumptions(const AltaLayout& layout, Source& source)
{
    if (layout.output == Output::xyz) source.assumptions.push_back(describeWhite(XyzWhite::d65));
    if (layout.values == 1) source.assumptions.emplace_back("one channel as grey");
    if (layout.input->isotropic)
        source.assumptions.emplace_back("isotropic, as the coordinates have no azimuth");
    if (layout.input->dimension < 3)
        source.assumptions.emplace_back(
            "light and view in one plane, as the coordinates leave open");
}

}  // namespace

bool isAlta(const InputFile& file)
{
    const std::string_view bytes = file.bytes();
    if (!looksLikeText(bytes.substr(0, 64))) return false;
    return readHeader(bytes).lines.count("DIM") != 0;
}

Source readAlta(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const AltaHeader header = readHeader(file.bytes());
    const AltaLayout layout = layoutOf(file, header);
    const bool binary = lowerCase(header.first("FORMAT")) == "binary";
    Source source;
    if (binary)
        readBinary(file, header, layout, source);
    else
        readText(file, layout, source);
    source.isotropic = layout.input->isotropic;
    source.description = std::string(binary ? "binary ALTA data, " : "ALTA data, ") +
                         layout.input->name +
                         (layout.values == 3 ? ", three channels" : ", one channel") + ", 1/sr";
    noteAssumptions(layout, source);
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
