#include <fbrdf/io/MaterialFile.h>

#include "ExrMaterial.h"
#include "Files.h"
#include "Manifest.h"
#include "Waterloo.h"

#include <fbrdf/base/Error.h>

#include <filesystem>

namespace fbrdf {
namespace {

// Enough to recognise each format: OpenEXR headers begin with the attributes that are looked for.
constexpr size_t kBeginning = 4096;

bool isFolder(const std::string& path)
{
    std::error_code error;
    return std::filesystem::is_directory(path, error);
}

}  // namespace

Material readMaterial(const std::string& path)
{
    if (isFolder(path)) return readWaterloo(path);
    const std::string bytes = readFile(path), beginning = bytes.substr(0, kBeginning);
    if (looksLikeExrMaterial(beginning)) return readExrMaterial(bytes, path);
    if (looksLikeManifest(beginning)) return readManifest(bytes, path);
    // Nothing else is called .txt: the reader can say which line is wrong.
    if (looksLikeWaterloo(path) || std::filesystem::path(path).extension() == ".txt")
        return readWaterloo(path);
    throw Error(ErrorKind::input, path,
                "found another kind of file, expected a .fbrdf, the NAME.txt of factor maps of "
                "2001, or a JSON manifest of fbrdf");
}

bool isMaterialFile(const std::string& path)
{
    if (isFolder(path)) return looksLikeWaterloo(path);
    const std::string beginning = readBeginning(path, kBeginning);
    return looksLikeExrMaterial(beginning) || looksLikeManifest(beginning) ||
           looksLikeWaterloo(path);
}

void writeMaterial(const Material& material, const std::string& path)
{
    validate(material, path);
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".fbrdf") return writeExrMaterial(material, path);
    if (extension == ".json") return writeManifest(material, path);
    if (extension == ".txt") return writeWaterloo(material, path);
    throw Error(ErrorKind::usage, path,
                "found extension '" + extension + "', expected .fbrdf, .txt or .json");
}

Material materialFromFileBytes(const std::string& bytes, const std::string& where)
{
    if (!looksLikeExrMaterial(bytes.substr(0, kBeginning)))
        throw Error(ErrorKind::input, where, "found other bytes, expected those of a .fbrdf");
    return readExrMaterial(bytes, where);
}

std::string materialFileBytes(const Material& material)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("material.fbrdf");
    writeMaterial(material, path);
    return readFile(path);
}

}  // namespace fbrdf
