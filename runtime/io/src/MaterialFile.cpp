#include <fbrdf/io/MaterialFile.h>

#include "ExrMaterial.h"
#include "Files.h"
#include "Manifest.h"
#include "Waterloo.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>

#include <filesystem>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

// These first bytes are enough to recognise each format: no description of 2001 is longer, and
// docs/format.md puts the mark of a .fbrdf within them.
constexpr size_t kBeginning = kMaxWaterlooDescription + 1;

enum class Kind { none, exr, manifest, waterloo };

bool isFolder(const std::string& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

Kind kindOf(const std::string& path)
{
    if (isFolder(path)) return holdsWaterloo(path) ? Kind::waterloo : Kind::none;
    const std::string beginning = readBeginning(path, kBeginning);
    if (looksLikeExrMaterial(beginning)) return Kind::exr;
    if (looksLikeManifest(beginning)) return Kind::manifest;
    return looksLikeWaterloo(beginning) ? Kind::waterloo : Kind::none;
}

Material readAs(Kind kind, const std::string& path)
{
    FBRDF_ASSERT((kind == Kind::none), ==, false);
    if (kind == Kind::exr) return readExrMaterial(readFile(path), path);
    if (kind == Kind::manifest) return readManifest(readFile(path), path);
    return readWaterloo(path);
}

}  // namespace

Material readMaterial(const std::string& path)
{
    const Kind kind = kindOf(path);
    if (kind != Kind::none) return readAs(kind, path);
    // A folder or a .txt can only be meant as the layout of 2001, whose reader knows what is wrong.
    if (isFolder(path) || fs::path(path).extension() == ".txt") return readWaterloo(path);
    readFile(path);  // throws for what is missing or not a regular file
    throw Error(
        ErrorKind::input, path,
        Found("another kind of file")
            .expected(
                "a .fbrdf, the NAME.txt of factor maps of 2001, or a JSON manifest of fbrdf"));
}

bool isMaterialFile(const std::string& path)
{
    return kindOf(path) != Kind::none;
}

std::optional<Material> readIfMaterial(const std::string& path)
{
    const Kind kind = kindOf(path);
    if (kind == Kind::none) return std::nullopt;
    return readAs(kind, path);
}

void writeMaterial(const Material& material, const std::string& path)
{
    validate(material, path);
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".fbrdf") return writeFile(path, encodeExrMaterial(material, path));
    if (extension == ".json") return writeManifest(material, path);
    if (extension == ".txt") return writeWaterloo(material, path);
    throw Error(ErrorKind::usage, path,
                Found("extension '" + extension + "'").expected(".fbrdf, .txt or .json"));
}

Material materialFromFileBytes(const std::string& bytes, const std::string& where)
{
    if (!looksLikeExrMaterial(bytes.substr(0, kBeginning)))
        throw Error(ErrorKind::input, where, Found("other bytes").expected("those of a .fbrdf"));
    return readExrMaterial(bytes, where);
}

std::string materialFileBytes(const Material& material)
{
    validate(material, "material");
    return encodeExrMaterial(material, "material");
}

}  // namespace fbrdf
