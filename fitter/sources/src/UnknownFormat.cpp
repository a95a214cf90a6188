#include "UnknownFormat.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fmt/format.h>

namespace fbrdf {
namespace {

/// Files that people try, by how they start.
struct Foreign {
    std::string_view start;
    const char* what;
};
constexpr Foreign kForeign[] = {
    {"PK\x03\x04", "a ZIP archive or a spreadsheet (.xlsx), which is to be saved as CSV"},
    {"\xD0\xCF\x11\xE0", "an old spreadsheet (.xls), which is to be saved as CSV"},
    {"\x1F\x8B", "a gzip archive, which is to be unpacked"},
    {"%PDF", "a PDF document"},
    {"\x89PNG", "a PNG picture"},
    {"\x89HDF", "an HDF5 file"},
    {"<!DOCTYPE", "a web page"},
    {"<html", "a web page"},
    {"<", "XML, but no WindowElement"},
    {"{", "JSON, but no known schema"},
};

/// True when one of the first lines starts with the word.
bool hasLine(const InputFile& file, std::string_view word)
{
    constexpr int kLines = 64;
    LineReader lines(file.bytes().substr(0, 8192));
    std::string_view line;
    std::vector<std::string_view> words;
    for (int i = 0; i < kLines && lines.nextData(line); ++i) {
        splitWords(line, words);
        if (sameWord(words.front(), word)) return true;
    }
    return false;
}

/// What the file looks like, empty where it looks like nothing in particular.
std::string resemblance(const InputFile& file)
{
    const std::string_view start = trimmed(file.bytes());
    for (const Foreign& foreign : kForeign)
        if (start.substr(0, foreign.start.size()) == foreign.start) return foreign.what;
    if (!looksLikeText(file.bytes())) return "";
    if (hasLine(file, "AOI") && hasLine(file, "POI"))
        return "LightTools' BSDF, but has no lists ScatterAzimuth and ScatterRadial";
    return "";
}

std::string firstBytes(std::string_view bytes)
{
    std::string text;
    for (const char c : bytes.substr(0, 8))
        text += fmt::format("{}{:02x}", text.empty() ? "" : " ", static_cast<unsigned char>(c));
    return text;
}

/// "text, 103 bytes that start with '# own'": what was looked at.
std::string appearance(const InputFile& file)
{
    std::string_view line;
    LineReader lines(file.bytes());
    const bool text = looksLikeText(file.bytes());
    while (text && lines.next(line) && trimmed(line).empty()) continue;
    return fmt::format("{}, {} bytes that start with {}", text ? "text" : "binary", file.size(),
                       text ? inQuotes(trimmed(line)) : firstBytes(file.bytes()));
}

/// "as .bsdf it could be rgl (...) or zemax (...)", empty where no format has the extension.
std::string couldBe(const InputFile& file)
{
    std::string list;
    for (const Format& format : formats())
        if (hasExtension(format, file.extension()))
            list += fmt::format("{}{} ({})", list.empty() ? "" : " or ", format.name, format.sign);
    return list.empty() ? "" : fmt::format("as .{} it could be {}", file.extension(), list);
}

std::string formatNames()
{
    std::string names;
    for (const Format& format : formats())
        names += std::string(names.empty() ? "" : ", ") + format.name;
    return names;
}

}  // namespace

bool hasExtension(const Format& format, const std::string& extension)
{
    return !extension.empty() &&
           std::string(format.extensions).find(" " + extension + " ") != std::string::npos;
}

Error unknownFormat(const InputFile& file)
{
    std::string what = "an unknown format (" + appearance(file) + ")";
    if (const std::string known = resemblance(file); !known.empty())
        what += ", it resembles " + known;
    if (const std::string named = couldBe(file); !named.empty()) what += "; " + named;
    return inputError(
        file, Found(what).expected("the content of one of " + formatNames() + ", or a material"));
}

}  // namespace fbrdf
