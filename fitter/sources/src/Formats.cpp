#include "Formats.h"

#include <cctype>
#include <cstdio>

namespace fbrdf {
namespace {

/// In the order in which they are tried: a beginning that nothing else has, then a size that
/// nothing else has, then text with marks of its own, and last what is only columns of numbers.
constexpr Format kFormats[] = {
    {"rgl", " bsdf ", false, isRgl, readRgl},
    {"columns", " f32c ", false, isBinaryColumns, readBinaryColumns},
    {"exr", " exr ", false, isExrTable, readExrTable},
    {"picture", " hdr tif tiff ", false, isPictureTable, readPictureTable},
    {"merl", " binary ", false, isMerl, readMerl},
    {"npf", "", true, isNpf, readNpf, npfRows},
    {"utia", " bin ", false, isUtia, readUtia},
    {"nbrdf", " f32 ", true, isNbrdf, readNbrdf, nbrdfRows},
    {"klems", " xml ", true, isKlems, readKlems},
    {"fred", "", false, isFred, readFred},
    {"zemax", "", false, isZemax, readZemax},
    {"alta", " alta dat ", false, isAlta, readAlta},
    {"astm", " astm ", true, isAstm, readAstm},
    {"lumos", "", false, isLumos, readLumos},
    {"csv", " csv ", false, isCsv, readCsv},
    {"rt300s", "", false, isRt300s, readRt300s},
    {"nist", "", true, isNist, readNist},
    {"cornell", " brdf ", true, isCornell, readCornell},
    {"scattered", "", false, isScattered, readScattered},
};

bool hasExtension(const Format& format, const std::string& extension)
{
    return !extension.empty() &&
           std::string(format.extensions).find(" " + extension + " ") != std::string::npos;
}

std::string firstBytes(std::string_view bytes)
{
    std::string text;
    for (const char c : bytes.substr(0, 8)) {
        char hex[8];
        std::snprintf(hex, sizeof hex, text.empty() ? "%02x" : " %02x",
                      unsigned(static_cast<unsigned char>(c)));
        text += hex;
    }
    return text;
}

std::string formatNames()
{
    std::string names;
    for (const Format& format : kFormats)
        names += std::string(names.empty() ? "" : ", ") + format.name;
    return names;
}

}  // namespace

const Format& formatOf(const InputFile& file)
{
    for (const Format& format : kFormats)
        if (format.recognises(file)) return format;
    const std::string extension = file.extension();
    for (const Format& format : kFormats)
        if (hasExtension(format, extension)) return format;
    throw inputError(file, "found an unknown format (" + std::to_string(file.size()) +
                               " bytes that start with " + firstBytes(file.bytes()) +
                               "), expected one of " + formatNames() + ", or a material");
}

}  // namespace fbrdf
