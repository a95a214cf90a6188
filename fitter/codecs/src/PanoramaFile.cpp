#include "CubeLayout.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/codecs/PanoramaFile.h>

#include <filesystem>
#include <fstream>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

/// A panorama of 16384 x 8192 has some 400 MB.
constexpr uintmax_t kMostFileBytes = uintmax_t(2) << 30;

/// Names that the files of six faces end in: right, left, up, down, forward, back.
constexpr const char* kFaceNames[][6] = {
    {"px", "nx", "py", "ny", "pz", "nz"},
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"right", "left", "top", "bottom", "front", "back"},
};

std::string bytesOf(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw Error(ErrorKind::input, path, Found("no such file").expected("a panorama"));
    if (!fs::is_regular_file(status))  // a pipe would block, and a device may never end
        throw Error(ErrorKind::input, path, Found("a folder or a device").expected("a file"));
    const uintmax_t size = fs::file_size(path, error);
    if (error || size > kMostFileBytes)
        throw Error(ErrorKind::input, path,
                    Found(std::to_string(size) + " bytes").expected("at most 2 GiB"));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(size, '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw Error(ErrorKind::input, path, "cannot be read");
    return bytes;
}

bool begins(const std::string& bytes, const char* with, size_t count)
{
    return bytes.compare(0, count, with, count) == 0;
}

/// OpenImageIO's name of the format, or null.
const char* formatOf(const std::string& bytes)
{
    if (begins(bytes, "\x76\x2f\x31\x01", 4)) return "openexr";
    if (begins(bytes, "\x89PNG", 4)) return "png";
    if (begins(bytes, "\xff\xd8\xff", 3)) return "jpeg";
    if (begins(bytes, "II*\0", 4) || begins(bytes, "MM\0*", 4)) return "tiff";
    return nullptr;
}

LightPicture readLight(const std::string& path)
{
    const std::string bytes = bytesOf(path);
    if (begins(bytes, "#?", 2)) return decodeRadianceHdr(bytes, path);
    if (const char* format = formatOf(bytes)) return decodeLightPicture(bytes, format, path);
    throw Error(ErrorKind::input, path,
                Found(bytes.empty() ? "an empty file" : "a file of another kind")
                    .expected("OpenEXR, Radiance HDR, PNG, JPEG or TIFF"));
}

std::string lower(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string upper(std::string text)
{
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

/// The path of a face of the same six as `path`, which has `known` at the end of its stem.
std::string otherFace(const fs::path& path, const std::string& known, const std::string& wanted)
{
    const std::string stem = path.stem().string();
    const std::string end = stem.substr(stem.size() - known.size());
    const bool isUpper = end == upper(end);
    const std::string other = stem.substr(0, stem.size() - known.size()) +
                              (isUpper ? upper(wanted) : wanted) + path.extension().string();
    return (path.parent_path() / other).string();
}

/// The paths of all six, or none where the name is not that of a face.
std::vector<std::string> facesOf(const std::string& path)
{
    const std::string stem = lower(fs::path(path).stem().string());
    std::vector<std::string> paths;
    for (const auto& names : kFaceNames)
        for (const std::string known : names) {
            if (stem.size() < known.size() ||
                stem.compare(stem.size() - known.size(), known.size(), known) != 0)
                continue;
            paths.clear();
            for (const char* name : names) paths.push_back(otherFace(path, known, name));
        }
    return paths;
}

std::string sidesOf(const LightPicture& picture)
{
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

Panorama readFaces(const std::string& path, const LightPicture& first, std::string& note)
{
    const std::vector<std::string> paths = facesOf(path);
    if (paths.empty())
        throw Error(ErrorKind::input, path,
                    Found("a square picture of " + sidesOf(first) + " pixels")
                        .expected("a name that ends in px nx py ny pz nz, posx negx posy negy posz "
                                  "negz, or right left top bottom front back, with the other five "
                                  "beside it"));
    std::array<LightPicture, 6> faces;
    for (size_t i = 0; i < 6; ++i) {
        faces[i] = readLight(paths[i]);
        if (faces[i].width != first.width || faces[i].height != first.height)
            throw Error(
                ErrorKind::input, paths[i],
                Found(sidesOf(faces[i]) + " pixels").expected(sidesOf(first) + " as in " + path));
        if (!faces[i].notes.empty())
            note += "; " + fs::path(paths[i]).filename().string() + faces[i].notes;
    }
    return panoramaOfFaces(faces);
}

}  // namespace

Panorama readPanorama(const std::string& path, std::string* note)
{
    LightPicture picture = readLight(path);
    const LightLayout layout = layoutOf(picture.width, picture.height);
    std::string said = nameOf(layout) + (" " + sidesOf(picture));
    Panorama panorama;
    if (layout == LightLayout::face) {
        panorama = readFaces(path, picture, said);
    } else {
        said += picture.notes;
        panorama = layout == LightLayout::latLong
                       ? Panorama{picture.width, picture.height, std::move(picture.texels)}
                       : panoramaOfFaces(picture, layout);
    }
    if (note != nullptr) *note = said;
    return panorama;
}

}  // namespace fbrdf
