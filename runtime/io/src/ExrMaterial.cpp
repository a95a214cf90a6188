#include "ExrMaterial.h"

#include "Codes.h"
#include "ExrHeader.h"
#include "ExrPixels.h"
#include "LobeJson.h"
#include "Printable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/pictures/Exr.h>

#include <cstring>
#include <set>

namespace fbrdf {
namespace {

constexpr int kFormatVersion = 1;
constexpr char kVersionName[] = "fbrdf:version", kForm[] = "fbrdf:form", kScales[] = "fbrdf:scales",
               kUnits[] = "fbrdf:units", kColorSpace[] = "fbrdf:colorspace", kName[] = "fbrdf:name",
               kNote[] = "fbrdf:note:", kError[] = "fbrdf:error:", kStorage[] = "fbrdf:storage",
               kLower[] = "fbrdf:lower", kUpper[] = "fbrdf:upper", kStride[] = "fbrdf:stride",
               kOffset[] = "fbrdf:offset", kStart[] = "fbrdf:start",
               kUnsupported[] = "fbrdf:unsupported", kLobes[] = "fbrdf:lobes",
               kLobeKnots[] = "fbrdf:lobe_knots";
constexpr char kUnitsValue[] = "1/sr", kColorSpaceValue[] = "lin_rec709";
// OpenEXR allows names of 255 bytes.
constexpr size_t kMaxKey = 200;
// A form is a few kilobytes; parsing takes some thirty times the bytes of hostile JSON.
constexpr size_t kMaxForm = 1 << 20;
// Decoded tables take at most this much more than their file, or a sum that honest materials of
// nearly constant tables reach: 32 MiB are 16 tables of 1024 x 512 texels.
constexpr size_t kMaxDecodedRatio = 12, kAlwaysDecoded = size_t(32) << 20;

using Attributes = std::vector<std::pair<std::string, ExrValue>>;

std::string keyedName(const char* prefix, const std::string& key, const std::string& where)
{
    if (key.size() > kMaxKey || key.find('\0') != std::string::npos)
        throw Error(ErrorKind::usage, where,
                    Found("a note or error named '" + key.substr(0, kMaxKey) + "'")
                        .expected("at most 200 bytes and no zero byte"));
    return prefix + key;
}

// OpenEXR's library ends a text at its first zero byte; what follows must not be lost silently.
const std::string& checkedText(const std::string& text, const std::string& name,
                               const std::string& where)
{
    if (text.find('\0') != std::string::npos)
        throw Error(ErrorKind::usage, where,
                    name + ": " + Found("a text with a zero byte").expected("none"));
    return text;
}

std::vector<float> floatsOf(const std::vector<Vec3f>& triples)
{
    std::vector<float> floats;
    for (const Vec3f& v : triples) floats.insert(floats.end(), {v.x, v.y, v.z});
    return floats;
}

// The colour space stands near the beginning, where looksLikeExrMaterial finds it.
Attributes materialAttributes(const Material& material, const std::string& where)
{
    Attributes attributes = {
        {kVersionName, kFormatVersion},
        {kUnits, std::string(kUnitsValue)},
        {kColorSpace, std::string(kColorSpaceValue)},
        {"Software", std::string("fbrdf " FBRDF_VERSION)},
        {kName, checkedText(material.name, kName, where)},
        {kForm, jsonFromForm(material.form).dump(-1, ' ', false, Json::error_handler_t::replace)},
        {kScales, floatsOf(material.scales)}};
    for (const auto& [key, text] : material.notes) {
        const std::string name = keyedName(kNote, key, where);
        attributes.emplace_back(name, checkedText(text, name, where));
    }
    for (const auto& [key, number] : material.errors)
        attributes.emplace_back(keyedName(kError, key, where), number);
    if (!material.lobes.isEmpty()) {
        attributes.emplace_back(kLobes, jsonFromLobes(material.lobes).dump());
        attributes.emplace_back(kLobeKnots, lobeNumbers(material.lobes));
    }
    return attributes;
}

Attributes tableAttributes(const Table& table)
{
    const auto triple = [](const Vec3f& v) { return std::array<float, 3>{v.x, v.y, v.z}; };
    Attributes attributes = {{kStorage, std::string(storageName(table.storage))},
                             {kLower, triple(table.lower)},
                             {kUpper, triple(table.upper)}};
    if (table.storage == Storage::log8) {
        attributes.emplace_back(kStride, table.log8.stride);
        attributes.emplace_back(kOffset, table.log8.offset);
        attributes.emplace_back(kStart, table.log8.start);
    }
    if (!table.unsupported.empty())
        attributes.emplace_back(kUnsupported, runsOfMarks(table.unsupported));
    return attributes;
}

// Part names must be unique and not empty; names of tables need be neither.
std::string partName(const Form& form, size_t index, std::set<std::string>& taken)
{
    const std::string& table = form.tables[index].name;
    // The reader goes by the index of a part, so any name that is unique will do.
    std::string name = table.empty() ? "table" : table.substr(0, table.find('\0'));
    if (taken.count(name)) name += "#" + std::to_string(index);
    while (!taken.insert(name).second) name += "'";
    return name;
}

ExrImage imageFromTable(const Table& table, const std::string& name)
{
    const auto size = domainSize(table.domain);
    ExrImage image;
    image.name = name;
    image.width = size[0];
    image.height = size[1] * size[2];  // slices of a volume lie below each other
    image.channels = table.channels;
    image.half = table.storage != Storage::float32;
    image.pixels = table.texels;
    // Half represents every integer up to 2048, so codes of 8 bits come back exactly.
    if (bytesPerChannel(table.storage) == 1) {
        const std::vector<uint16_t> codes = codesOfTable(table);
        image.pixels.assign(codes.begin(), codes.end());
    }
    return image;
}

/// Typed access to the attributes of one part.
class PartReader {
public:
    PartReader(const std::string& bytes, const ExrPart& part, std::string where)
        : bytes_(bytes), part_(part), where_(std::move(where))
    {
    }

    std::string text(const char* name) const
    {
        const ExrAttribute& a = attribute(name, {"string"}, 1);
        return bytes_.substr(a.offset, a.size);
    }
    int integer(const char* name) const
    {
        const ExrAttribute& a = attribute(name, {"int"}, 4);
        if (a.size != 4) fail(a, Found(std::to_string(a.size) + " bytes").expected("4"));
        return value<int>(a.offset);
    }
    /// A floatvector of any length.
    std::vector<float> floats(const char* name) const
    {
        const ExrAttribute& a = attribute(name, {"floatvector"}, 4);
        std::vector<float> numbers(a.size / 4);
        for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = value<float>(a.offset + 4 * i);
        return numbers;
    }
    /// Reads a floatvector, or one of the types that the first fbrdf wrote for three and nine
    /// floats: v3f and m33f.
    std::vector<float> floats(const char* name, size_t count) const
    {
        const ExrAttribute& a = attribute(name, {"floatvector", "v3f", "m33f"}, 4);
        if (a.size != 4 * count)
            fail(a, Found(std::to_string(a.size / 4) + " numbers").expected(std::to_string(count)));
        std::vector<float> numbers;
        for (size_t i = 0; i < count; ++i) numbers.push_back(value<float>(a.offset + 4 * i));
        return numbers;
    }
    Vec3f triple(const char* name) const
    {
        const std::vector<float> v = floats(name, 3);
        return {v[0], v[1], v[2]};
    }
    std::array<int, 3> integerTriple(const char* name) const
    {
        const ExrAttribute& a = attribute(name, {"v3i"}, 12);
        if (a.size != 12) fail(a, Found(std::to_string(a.size) + " bytes").expected("12"));
        return {value<int>(a.offset), value<int>(a.offset + 4), value<int>(a.offset + 8)};
    }
    void expectText(const char* name, const char* expected) const
    {
        if (text(name) != expected)
            fail(attribute(name, {"string"}, 1),
                 Found("'" + text(name) + "'").expected(std::string("'") + expected + "'"));
    }
    template <class T>
    T value(size_t offset) const
    {
        T result;
        std::memcpy(&result, bytes_.data() + offset, sizeof result);
        return result;
    }
    const std::string& where() const { return where_; }
    const ExrPart& part() const { return part_; }
    [[noreturn]] void fail(const ExrAttribute& at, const std::string& what) const
    {
        throw Error(ErrorKind::input, where_ + ": byte " + std::to_string(at.offset),
                    at.name + ": " + what);
    }
    const ExrAttribute& attribute(const char* name, std::initializer_list<const char*> types,
                                  size_t unit) const
    {
        const ExrAttribute* a = part_.find(name);
        if (!a)
            throw Error(ErrorKind::input, where_, Found(std::string("no ") + name).expected("it"));
        for (const char* type : types)
            if (a->type == type && a->size % unit == 0) return *a;
        fail(*a, Found("type " + printable(a->type)).expected(*types.begin()));
    }

private:
    const std::string& bytes_;
    const ExrPart& part_;
    std::string where_;
};

void checkVersion(const PartReader& reader)
{
    const int version = reader.integer(kVersionName);
    if (version < 1 || version > kFormatVersion)
        throw Error(ErrorKind::input, reader.where(),
                    Found("format version " + std::to_string(version))
                        .expected("at most " + std::to_string(kFormatVersion) +
                                  (version > 1 ? ": written by a newer fbrdf" : "")));
    reader.expectText(kUnits, kUnitsValue);
    reader.expectText(kColorSpace, kColorSpaceValue);
}

void readDescription(const std::string& bytes, const PartReader& reader, Material& material)
{
    const std::string where = reader.where() + ": " + kForm, text = reader.text(kForm);
    if (text.size() > kMaxForm)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(text.size()) + " bytes").expected("at most 2^20"));
    // The form comes first: it decides how many scales and tables there have to be.
    const Json json = parseJson(text, where);
    material.form = formFromJson(JsonField(json, where));
    const std::vector<float> scales = reader.floats(kScales, 3 * material.form.terms.size());
    for (size_t t = 0; t < material.form.terms.size(); ++t)
        material.scales.emplace_back(scales[3 * t], scales[3 * t + 1], scales[3 * t + 2]);
    material.name = reader.text(kName);
    // Other tools may add attributes of their own: what is not ours by name and type is ignored.
    for (const ExrAttribute& a : reader.part().attributes) {
        if (a.name.rfind(kNote, 0) == 0 && a.type == "string")
            material.notes[a.name.substr(std::strlen(kNote))] = bytes.substr(a.offset, a.size);
        if (a.name.rfind(kError, 0) == 0 && a.type == "double" && a.size == sizeof(double))
            material.errors[a.name.substr(std::strlen(kError))] = reader.value<double>(a.offset);
    }
}

void readLobes(const PartReader& reader, Material& material)
{
    if (!reader.part().find(kLobes)) return;
    const std::string where = reader.where() + ": " + kLobes, text = reader.text(kLobes);
    if (text.size() > kMaxForm)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(text.size()) + " bytes").expected("at most 2^20"));
    const Json json = parseJson(text, where);
    material.lobes = lobesFromJson(JsonField(json, where), reader.floats(kLobeKnots));
}

Table readTable(ExrPixels& pixels, size_t index, const TableSpec& spec, const PartReader& reader)
{
    const auto size = domainSize(spec.domain);
    const ExrPart& part = reader.part();
    if (part.width != size[0] || part.height != size[1] * size[2])
        throw Error(
            ErrorKind::input, reader.where(),
            Found(std::to_string(part.width) + " x " + std::to_string(part.height) + " texels")
                .expected(std::to_string(size[0]) + " x " + std::to_string(size[1] * size[2])));
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    table.channels = part.channels;
    const std::string storage = reader.text(kStorage);
    if (!knownStorage(storage, table.storage))
        reader.fail(*part.find(kStorage),
                    Found("'" + storage + "'").expected("log8, half, float, linear8 or signed"));
    if (part.half != (table.storage != Storage::float32))
        reader.fail(*part.find(kStorage),
                    Found(storage + (part.half ? " in half" : " in float") + " channels")
                        .expected(part.half ? "float channels" : "half channels"));
    table.lower = reader.triple(kLower);
    table.upper = reader.triple(kUpper);
    if (table.storage == Storage::log8)
        table.log8 = {reader.integerTriple(kStride), reader.integerTriple(kOffset),
                      reader.integerTriple(kStart)};
    if (part.find(kUnsupported))
        table.unsupported = marksFromRuns(reader.text(kUnsupported), texelCount(spec.domain),
                                          reader.where() + ": " + kUnsupported);
    checkCoding(table, reader.where());
    table.texels = pixels.read(index, part, reader.where());
    if (bytesPerChannel(table.storage) == 1) decodeTexels(table, reader.where());
    return table;
}

// Part names are for people and may be any bytes, but an error is one line.
std::string partWhere(const std::string& where, const ExrPart& part, size_t index,
                      const std::string& bytes)
{
    std::string text = where + ": part " + std::to_string(index);
    if (const ExrAttribute* name = part.find("name"))
        text += " '" + printable(bytes.substr(name->offset, name->size)) + "'";
    return text;
}

// Refuses tables that no honest file of this size contains: deflate shrinks zeros a thousandfold.
void checkDecodedSize(const std::vector<ExrPart>& parts, size_t fileSize, const std::string& where)
{
    size_t decoded = 0;
    for (const ExrPart& part : parts)
        decoded += static_cast<size_t>(part.width) * static_cast<size_t>(part.height) *
                   static_cast<size_t>(part.channels) * sizeof(float);
    const size_t most = kMaxDecodedRatio * fileSize + kAlwaysDecoded;
    if (decoded > most)
        throw Error(ErrorKind::input, where,
                    Found("texels of " + std::to_string(decoded) + " bytes in a file of " +
                          std::to_string(fileSize))
                        .expected("at most " + std::to_string(most)));
}

}  // namespace

bool looksLikeExrMaterial(const std::string& beginning)
{
    return looksLikeExr(beginning) && beginning.find(kColorSpace) != std::string::npos;
}

Material readExrMaterial(const std::string& bytes, const std::string& where)
{
    const std::vector<ExrPart> parts = scanExr(bytes, where);
    checkDecodedSize(parts, bytes.size(), where);
    const PartReader first(bytes, parts[0], partWhere(where, parts[0], 0, bytes));
    checkVersion(first);
    Material material;
    readDescription(bytes, first, material);
    readLobes(first, material);
    if (parts.size() != material.form.tables.size())
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(parts.size()) + " parts")
                        .expected("one for each of " + std::to_string(material.form.tables.size()) +
                                  " tables"));
    // The decoder sees the file only now, when all that it would trust has been checked.
    ExrPixels pixels(bytes, where);
    for (size_t k = 0; k < parts.size(); ++k)
        material.tables.push_back(
            readTable(pixels, k, material.form.tables[k],
                      PartReader(bytes, parts[k], partWhere(where, parts[k], k, bytes))));
    validate(material, where);
    return material;
}

std::string encodeExrMaterial(const Material& material, const std::string& where)
{
    std::vector<ExrImage> images;
    std::set<std::string> taken;
    for (size_t k = 0; k < material.tables.size(); ++k) {
        checkStorable(material.tables[k], ErrorKind::usage, where);
        images.push_back(imageFromTable(material.tables[k], partName(material.form, k, taken)));
        if (k == 0) images[0].attributes = materialAttributes(material, where);
        const Attributes table = tableAttributes(material.tables[k]);
        images[k].attributes.insert(images[k].attributes.end(), table.begin(), table.end());
    }
    return encodeExr(images, where);
}

}  // namespace fbrdf
