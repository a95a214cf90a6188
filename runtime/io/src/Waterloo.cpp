#include "Waterloo.h"

#include "Codes.h"
#include "Files.h"
#include "Printable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/pictures/Png.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSize = 4096;

struct Description {
    std::string title, gain;
    int kind = 0;
    Vec3f alpha{0.0f};
};

struct Lines {
    std::vector<std::string> text;
    std::string where;

    [[noreturn]] void fail(size_t line, const std::string& expected) const
    {
        const std::string found =
            line < text.size() ? "'" + printable(text[line]) + "'" : "the end of the file";
        throw Error(ErrorKind::input, where + ":" + std::to_string(line + 1),
                    Found(found).expected(expected));
    }
};

Lines linesOf(const std::string& bytes, const std::string& where)
{
    Lines lines{{}, where};
    LineReader reader(bytes);
    for (std::string_view line; reader.next(line);) lines.text.emplace_back(line);
    while (!lines.text.empty() && lines.text.back().empty()) lines.text.pop_back();
    return lines;
}

// True when the line is `count` finite numbers >= 0 and nothing else.
bool parseNumbers(const std::string& line, size_t count, float* numbers)
{
    std::vector<std::string_view> words;
    splitWords(line, words);
    if (words.size() != count) return false;
    for (size_t i = 0; i < count; ++i) {
        double number = 0.0;
        if (!parseNumber(words[i], number)) return false;
        numbers[i] = static_cast<float>(number);
        if (!std::isfinite(numbers[i]) || numbers[i] < 0.0f) return false;
    }
    return true;
}

bool isAlphaFile(const Lines& lines)
{
    float number;
    return lines.text.size() == 3 &&
           std::all_of(lines.text.begin(), lines.text.end(),
                       [&](const std::string& line) { return parseNumbers(line, 1, &number); });
}

Description parseDescription(const Lines& lines)
{
    Description d;
    if (isAlphaFile(lines)) {
        for (size_t c = 0; c < 3; ++c)
            parseNumbers(lines.text[c], 1, &d.alpha[static_cast<int>(c)]);
        return d;
    }
    if (lines.text.size() < 3)
        lines.fail(lines.text.size(), "title, kind, alpha and at most one more line");
    if (lines.text.size() > 4) lines.fail(4, "no more than four lines");
    if (std::any_of(lines.text[0].begin(), lines.text[0].end(),
                    [](char c) { return static_cast<unsigned char>(c) < 32; }))
        lines.fail(0, "a title");
    d.title = lines.text[0];
    if (lines.text[1] != "0" && lines.text[1] != "1" && lines.text[1] != "2")
        lines.fail(1, "kind 0, 1 or 2");
    d.kind = lines.text[1][0] - '0';
    if (!parseNumbers(lines.text[2], 3, &d.alpha[0])) lines.fail(2, "three numbers >= 0");
    float gain;
    if (lines.text.size() > 3) {
        if (!parseNumbers(lines.text[3], 1, &gain)) lines.fail(3, "a number >= 0");
        d.gain = lines.text[3];
    }
    return d;
}

Description readDescription(const std::string& path)
{
    const std::string bytes = readFile(path);
    if (bytes.size() > kMaxWaterlooDescription)
        throw Error(ErrorKind::input, path,
                    Found(std::to_string(bytes.size()) + " bytes").expected("at most 4096"));
    return parseDescription(linesOf(bytes, path));
}

bool isDescription(const std::string& path)
{
    return looksLikeWaterloo(readBeginning(path, kMaxWaterlooDescription + 1));
}

std::vector<std::string> filesIn(const std::string& folder, const std::string& ending)
{
    std::vector<std::string> paths;
    std::error_code error;
    // A folder that cannot be listed has no files: the error is then about what is missing in it.
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (path.size() >= ending.size() &&
            path.compare(path.size() - ending.size(), ending.size(), ending) == 0)
            paths.push_back(path);
    }
    std::sort(paths.begin(), paths.end());  // file systems list in any order, errors should not
    return paths;
}

std::vector<std::string> descriptionsIn(const std::string& folder)
{
    std::vector<std::string> paths = filesIn(folder, ".txt");
    const std::string alpha = (fs::path(folder) / "alpha").string();
    if (fs::exists(alpha)) paths.push_back(alpha);
    paths.erase(std::remove_if(paths.begin(), paths.end(),
                               [](const std::string& p) { return !isDescription(p); }),
                paths.end());
    return paths;
}

[[noreturn]] void failCount(const std::string& folder, const std::vector<std::string>& found,
                            const std::string& what)
{
    std::string names;
    for (const std::string& path : found)
        names += (names.empty() ? "" : ", ") + fs::path(path).filename().string();
    throw Error(ErrorKind::input, folder,
                Found((names.empty() ? "none" : names)).expected("one " + what));
}

std::string descriptionOf(const std::string& path)
{
    if (!fs::is_directory(path)) return path;
    const std::vector<std::string> found = descriptionsIn(path);
    if (found.size() != 1) failCount(path, found, "description of factor maps");
    return found[0];
}

// The maps have the NAME of the description or, beside `alpha`, that of the one pair NAMEp, NAMEq.
std::string baseOf(const std::string& description)
{
    const fs::path path(description);
    if (path.extension() == ".txt") return (path.parent_path() / path.stem()).string();
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string ending = "p.png";
    std::vector<std::string> pairs;
    for (const std::string& file : filesIn(folder.string(), ending)) {
        const std::string base = file.substr(0, file.size() - ending.size());
        if (fs::exists(base + "q.png")) pairs.push_back(file);
    }
    if (pairs.size() != 1) failCount(folder.string(), pairs, "pair NAMEp.png, NAMEq.png");
    return pairs[0].substr(0, pairs[0].size() - ending.size());
}

Table readMap(const std::string& base, int index, const char* name)
{
    // Both kinds of names were published: NAME_0.png, and NAMEp.png beside `alpha`.
    std::string path = base + "_" + std::to_string(index) + ".png";
    if (!fs::exists(path) && fs::exists(base + name + ".png")) path = base + name + ".png";
    const PngImage image = decodePng(readFile(path), path);
    if (image.width != image.height || image.width < kMinWaterlooSize || image.width > kMaxSize ||
        image.bits != 8)
        throw Error(ErrorKind::input, path,
                    Found(std::to_string(image.width) + " x " + std::to_string(image.height) +
                          " pixels of " + std::to_string(image.bits) + " bits")
                        .expected("a square of 8 to 4096 and 8 bits"));
    Table table;
    table.name = name;
    table.domain = waterlooDomain(image.width);
    table.storage = Storage::linear8;
    table.channels = image.channels;
    table.texels.assign(image.codes.begin(), image.codes.end());
    decodeTexels(table, path);
    return table;
}

void addTable(Material& material, Table table)
{
    material.form.tables.push_back({table.name, table.domain});
    material.tables.push_back(std::move(table));
}

void addSpecular(Material& material, const std::string& base, int index)
{
    addTable(material, readMap(base, index, "s"));
    const int table = static_cast<int>(material.tables.size()) - 1;
    material.form.terms.push_back({{{table, Direction::h}}});
    material.scales.emplace_back(1.0f);
}

}  // namespace

bool looksLikeWaterloo(const std::string& beginning)
{
    if (beginning.empty() || beginning.size() > kMaxWaterlooDescription) return false;
    // The reader itself decides, so what is recognised is what can be read.
    try {
        parseDescription(linesOf(beginning, "description"));
        return true;
    } catch (const Error&) {
        return false;
    }
}

bool holdsWaterloo(const std::string& folder)
{
    return !descriptionsIn(folder).empty();
}

Material readWaterloo(const std::string& path)
{
    const std::string file = descriptionOf(path);
    const Description description = readDescription(file);
    const std::string base = baseOf(file);
    Material material;
    material.name =
        description.title.empty() ? fs::path(base).filename().string() : description.title;
    // The gain brightens the authors' pictures and is no part of the BRDF: it is kept as a note.
    if (!description.gain.empty()) material.notes["display_gain"] = description.gain;
    material.notes["source"] = "factor maps in the layout of McCool, Ang, Ahmad 2001";
    if (description.kind != 2) {
        addTable(material, readMap(base, 0, "p"));
        addTable(material, readMap(base, 1, "q"));
        material.form.terms.push_back(
            {{{0, Direction::wo}, {1, Direction::h}, {0, Direction::wi}}});
        material.scales.push_back(description.alpha);
    }
    if (description.kind != 0) addSpecular(material, base, description.kind == 1 ? 2 : 0);
    material.form.name = description.kind == 0 ? "pqp" : description.kind == 1 ? "pqp+s" : "s";
    validate(material, path);
    return material;
}

}  // namespace fbrdf
