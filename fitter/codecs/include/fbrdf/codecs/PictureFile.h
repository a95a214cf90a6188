// PictureFile.h - pictures of formats beside OpenEXR and PNG (fbrdf::pictures), as bytes in memory.
// OpenImageIO reads and writes them, in a module that the first call of encodePicture,
// decodePicture or requirePictureModule opens. Safe to call from several threads.
// Images are top row first, channel contiguous, then x, then y.
#pragma once
#include <fbrdf/base/Error.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// What the samples of a file mean.
enum class PictureEncoding {
    srgb8,   ///< 8 bits, encoded by the curve of sRGB (Srgb.h)
    srgb16,  ///< 16 bits, encoded likewise
    linear,  ///< floating point, linear, Rec. 709 primaries
};

/// A format that can be written.
struct PictureFormat {
    const char* extension;  ///< ".jpg", in lower case
    const char* name;       ///< OpenImageIO's name of the format, "jpeg"
    PictureEncoding encoding;
};

/// The format that the extension of a path names, in any case of letters; null for OpenEXR, PNG and
/// every extension that is not in the table.
const PictureFormat* pictureFormatOf(const std::string& path);

/// All extensions of the table, ".bmp, .gif, ...".
std::string pictureExtensions();

/// A picture to write. The samples are those of the file: encoded in [0, 1] for srgb8 and srgb16
/// (clamped there), radiance for linear.
struct PictureSamples {
    int width = 0, height = 0;   ///< at least 1
    int channels = 3;            ///< 1, 3 or 4
    std::vector<float> samples;  ///< width x height x channels
};

/// The bytes of a file. Throws Error(output) naming `where` if the module cannot be loaded or the
/// format does not take the picture.
std::string encodePicture(const PictureSamples& picture, const PictureFormat& format,
                          const std::string& where);

/// A picture that was read. Integer samples are in [0, 1]; no curve was undone.
struct DecodedPicture {
    int width = 0, height = 0;
    std::vector<std::string> channels;  ///< names, "R", "G", "B"
    std::string colourSpace;            ///< "sRGB", "linear", ...; empty where none is declared
    std::string sampleType;             ///< in the file: "uint8", "uint16", "half", "float", ...
    std::vector<float> samples;         ///< width x height x channels.size()
};

/// Judges a picture by its header: `samples` is empty yet. Throws an Error to refuse it.
using PictureCheck = std::function<void(const DecodedPicture&)>;

/// The first image of a file of OpenImageIO's format `format` ("tiff", "hdr", ...). `check` is
/// called before a sample is decoded, so that files of kinds that nobody asked for meet no decoder;
/// what it throws leaves this function. Throws Error(input) naming `where` if the module cannot be
/// loaded, the file is damaged, has more than 2^24 pixels, samples of more than 4 times its bytes
/// and 12 MiB, or tiles larger than itself.
DecodedPicture decodePicture(std::string_view bytes, const char* format, const std::string& where,
                             const PictureCheck& check = {});

/// Opens the module, before long work whose result needs it. Throws Error(kind) naming `where` and
/// every path that was tried.
void requirePictureModule(ErrorKind kind, const std::string& where);

}  // namespace fbrdf
