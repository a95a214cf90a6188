#include "Manifest.h"

#include "Codes.h"
#include "Files.h"
#include "LobeJson.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/pictures/Png.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

constexpr int kManifestVersion = 1;
constexpr char kFormat[] = "fbrdf-material";
constexpr double kWideCodes = 65535.0;

Json jsonFromTriple(const Vec3f& v)
{
    return Json::array({v.x, v.y, v.z});
}

Vec3f tripleFromJson(const JsonField& json)
{
    if (json.size() != 3) json.fail("three numbers");
    Vec3f v;
    for (int c = 0; c < 3; ++c) v[c] = static_cast<float>(json.at(static_cast<size_t>(c)).number());
    return v;
}

/// Smallest and largest texel of each channel, which the 16-bit codes of half and float span. A
/// picture that people open should use its whole range; a .fbrdf keeps every digit of them.
struct Range {
    Vec3f lower{0.0f}, upper{0.0f};
};

Range rangeOf(const Table& table)
{
    Range range;
    for (int c = 0; c < table.channels; ++c) {
        range.lower[c] = range.upper[c] = table.texel(0, c);
        for (int i = 1; i < texelCount(table.domain); ++i) {
            range.lower[c] = std::min(range.lower[c], table.texel(i, c));
            range.upper[c] = std::max(range.upper[c], table.texel(i, c));
        }
    }
    return range;
}

std::vector<uint16_t> wideCodes(const Table& table, const Range& range)
{
    std::vector<uint16_t> codes;
    codes.reserve(table.texels.size());
    const auto channels = static_cast<size_t>(table.channels);
    for (size_t i = 0; i < table.texels.size(); ++i) {
        const int c = static_cast<int>(i % channels);
        const double low = double(range.lower[c]), span = double(range.upper[c]) - low;
        // A constant channel has no span, and any code stands for it.
        const double unit = span > 0.0 ? (double(table.texels[i]) - low) / span : 0.0;
        codes.push_back(static_cast<uint16_t>(std::lround(unit * kWideCodes)));
    }
    return codes;
}

void decodeWide(Table& table, const Range& range, const std::vector<uint16_t>& codes)
{
    const auto channels = static_cast<size_t>(table.channels);
    table.texels.resize(codes.size());
    for (size_t i = 0; i < codes.size(); ++i) {
        const int c = static_cast<int>(i % channels);
        const double low = double(range.lower[c]), span = double(range.upper[c]) - low;
        const auto value = static_cast<float>(low + span * (codes[i] / kWideCodes));
        // A half that was stored as a code of 16 bits comes back as the nearest half, so that the
        // table can be stored as half again.
        table.texels[i] =
            bytesPerChannel(table.storage) == 2 ? floatFromHalf(halfFromFloat(value)) : value;
    }
}

std::vector<uint16_t> unorm16Codes(const Table& table)
{
    std::vector<uint16_t> codes;
    codes.reserve(table.texels.size());
    for (int i = 0; i < texelCount(table.domain); ++i)
        for (int c = 0; c < table.channels; ++c)
            codes.push_back(static_cast<uint16_t>(unorm16Of(table, i, c)));
    return codes;
}

// Sets the texels of a log8 table from its 16-bit sums. Throws unless 8-bit differences add up to
// them.
void decodeLog8(Table& table, const std::vector<uint16_t>& codes, const std::string& where)
{
    checkCoding(table, where);
    const auto channels = static_cast<size_t>(table.channels);
    for (size_t i = 0; i < codes.size(); ++i)
        table.texels.push_back(texelFromUnorm16(table, static_cast<int>(i % channels), codes[i]));
    checkStorable(table, ErrorKind::input, where);
}

int bitsOf(Storage storage)
{
    return storage == Storage::linear8 ? 8 : 16;
}

// Table names are free text; file names are not.
std::string mapFileName(const std::string& stem, const std::string& table, size_t index,
                        std::set<std::string>& taken)
{
    std::string safe;
    // Letters of other alphabets become '_' too: what a file system makes of them differs.
    for (const char c : table.substr(0, 64))
        safe += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    std::string name = stem + "_" + safe + ".png";
    if (!taken.insert(name).second) {
        name = stem + "_" + safe + "_" + std::to_string(index) + ".png";
        taken.insert(name);
    }
    return name;
}

struct Map {
    Json json;
    std::string png;
};

Map mapFromTable(const Table& table, const std::string& where)
{
    const auto size = domainSize(table.domain);
    const bool exact = bytesPerChannel(table.storage) == 1;
    const Range range = exact ? Range{table.lower, table.upper} : rangeOf(table);
    PngImage image{size[0], size[1] * size[2], table.channels, bitsOf(table.storage), {}};
    // log8 shows its 16-bit sums: its 8-bit codes are differences, and no picture.
    image.codes = table.storage == Storage::linear8 ? codesOfTable(table)
                  : exact                           ? unorm16Codes(table)
                                                    : wideCodes(table, range);
    Map map;
    map.json["storage"] = storageName(table.storage);
    map.json["bits"] = image.bits;
    map.json["lower"] = jsonFromTriple(range.lower);
    map.json["upper"] = jsonFromTriple(range.upper);
    if (table.storage == Storage::log8)
        map.json["log8"] = {{"stride", table.log8.stride},
                            {"offset", table.log8.offset},
                            {"start", table.log8.start}};
    if (!table.unsupported.empty()) map.json["unsupported"] = runsOfMarks(table.unsupported);
    map.png = encodePng(image, where);
    return map;
}

Json describe(const Material& material)
{
    Json json;
    json["format"] = kFormat;
    json["version"] = kManifestVersion;
    json["name"] = material.name;
    json["units"] = "1/sr";
    json["colorspace"] = "lin_rec709";
    json["generator"] = "fbrdf " FBRDF_VERSION;
    json["form"] = jsonFromForm(material.form);
    json["scales"] = Json::array();
    for (const Vec3f& scale : material.scales) json["scales"].push_back(jsonFromTriple(scale));
    json["maps"] = Json::array();
    json["notes"] = Json(material.notes);
    json["errors"] = Json(material.errors);
    if (!material.lobes.isEmpty()) {
        json["lobes"] = jsonFromLobes(material.lobes);
        json["lobes"]["knots"] = lobeNumbers(material.lobes);
    }
    return json;
}

void expectText(const JsonField& json, const char* expected)
{
    if (json.text() != expected) json.fail(std::string("'") + expected + "'");
}

// A manifest may come from anywhere, so it may name files beside itself but no path.
std::string mapPath(const JsonField& json, const std::string& manifest)
{
    const std::string name = json.text();
    if (name.empty() || name == ".." || name.find('/') != std::string::npos ||
        name.find('\0') != std::string::npos)
        json.fail("the name of a file beside the manifest");
    return (fs::path(manifest).parent_path() / name).string();
}

std::array<int, 3> integersFromJson(const JsonField& json)
{
    if (json.size() != 3) json.fail("three integers");
    return {json.at(size_t(0)).integer(), json.at(1).integer(), json.at(2).integer()};
}

Log8 log8FromJson(const JsonField& json)
{
    return {integersFromJson(json.at("stride")), integersFromJson(json.at("offset")),
            integersFromJson(json.at("start"))};
}

void checkSize(const PngImage& image, const TableSpec& spec, Storage storage,
               const std::string& path)
{
    const auto size = domainSize(spec.domain);
    const auto text = [](int width, int height, int bits) {
        return std::to_string(width) + " x " + std::to_string(height) + " pixels of " +
               std::to_string(bits) + " bits";
    };
    if (image.width != size[0] || image.height != size[1] * size[2] ||
        image.bits != bitsOf(storage))
        throw Error(ErrorKind::input, path,
                    Found(text(image.width, image.height, image.bits))
                        .expected(text(size[0], size[1] * size[2], bitsOf(storage))));
}

Table tableFromMap(const JsonField& json, const TableSpec& spec, const std::string& manifest)
{
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    const JsonField storage = json.at("storage");
    if (!knownStorage(storage.text(), table.storage))
        storage.fail("'log8', 'half', 'float', 'linear8' or 'signed'");
    if (json.has("unsupported"))
        table.unsupported = marksFromRuns(json.at("unsupported").text(), texelCount(spec.domain),
                                          json.where() + "/unsupported");
    const Range range{tripleFromJson(json.at("lower")), tripleFromJson(json.at("upper"))};
    const std::string path = mapPath(json.at("file"), manifest);
    const PngImage image = decodePng(readFile(path), path);
    checkSize(image, spec, table.storage, path);
    table.channels = image.channels;
    if (bytesPerChannel(table.storage) > 1) {
        decodeWide(table, range, image.codes);
        return table;
    }
    table.lower = range.lower;
    table.upper = range.upper;
    if (table.storage == Storage::log8) {
        table.log8 = log8FromJson(json.at("log8"));
        decodeLog8(table, image.codes, path);
    } else {
        checkCoding(table, json.where());
        table.texels.assign(image.codes.begin(), image.codes.end());
        decodeTexels(table, path);
    }
    return table;
}

void readNotes(const JsonField& json, Material& material)
{
    if (json.has("notes"))
        for (const auto& [key, value] : json.at("notes").object().items())
            material.notes[key] = JsonField(value, json.where() + "/notes/" + key).text();
    if (json.has("errors"))
        for (const auto& [key, value] : json.at("errors").object().items())
            material.errors[key] =  // JSON writes a number that is not finite as null
                value.is_null() ? double(NAN)
                                : JsonField(value, json.where() + "/errors/" + key).number();
}

void readLobes(const JsonField& json, Material& material)
{
    if (!json.has("lobes")) return;
    const JsonField lobes = json.at("lobes"), knots = lobes.at("knots");
    std::vector<float> numbers;
    for (size_t i = 0; i < knots.size(); ++i)
        numbers.push_back(static_cast<float>(knots.at(i).number()));
    material.lobes = lobesFromJson(lobes, numbers);
}

}  // namespace

bool looksLikeManifest(const std::string& beginning)
{
    const size_t first = beginning.find_first_not_of(" \t\r\n");
    return first != std::string::npos && beginning[first] == '{' &&
           beginning.find(kFormat) != std::string::npos;
}

Material readManifest(const std::string& text, const std::string& path)
{
    const Json parsed = parseJson(text, path);
    const JsonField json(parsed, path + ": ");
    expectText(json.at("format"), kFormat);
    const JsonField version = json.at("version");
    if (version.integer() < 1 || version.integer() > kManifestVersion)
        version.fail("at most " + std::to_string(kManifestVersion));
    expectText(json.at("units"), "1/sr");
    expectText(json.at("colorspace"), "lin_rec709");
    Material material;
    material.name = json.at("name").text();
    material.form = formFromJson(json.at("form"));
    const JsonField scales = json.at("scales"), maps = json.at("maps");
    for (size_t t = 0; t < scales.size(); ++t)
        material.scales.push_back(tripleFromJson(scales.at(t)));
    if (maps.size() != material.form.tables.size())
        maps.fail("one map for each of " + std::to_string(material.form.tables.size()) + " tables");
    for (size_t k = 0; k < maps.size(); ++k)
        material.tables.push_back(tableFromMap(maps.at(k), material.form.tables[k], path));
    readNotes(json, material);
    readLobes(json, material);
    validate(material, path);
    return material;
}

void writeManifest(const Material& material, const std::string& path)
{
    Json json = describe(material);
    const fs::path file(path);
    std::set<std::string> taken;
    OutputFiles files;
    for (size_t k = 0; k < material.tables.size(); ++k) {
        const Table& table = material.tables[k];
        checkStorable(table, ErrorKind::usage, path);
        const std::string name = mapFileName(file.stem().string(), table.name, k, taken);
        Map map = mapFromTable(table, path);
        Json entry = {{"table", material.form.tables[k].name}, {"file", name}};
        entry.update(map.json);
        json["maps"].push_back(entry);
        files.add((file.parent_path() / name).string(), map.png);
    }
    // The manifest comes last: whoever watches for it finds the maps that it names.
    files.add(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    files.commit();
}

}  // namespace fbrdf
