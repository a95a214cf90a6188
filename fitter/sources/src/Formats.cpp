#include "Formats.h"

#include "UnknownFormat.h"

#include <fbrdf/base/Text.h>

namespace fbrdf {
namespace {

bool isText(const InputFile& file)
{
    return looksLikeText(file.bytes());
}

bool isBinary(const InputFile& file)
{
    return !isText(file);
}

bool startsWithMark(const InputFile& file)
{
    return isText(file) && trimmed(file.bytes()).substr(0, 1) == "#";
}

bool startsWithTag(const InputFile& file)
{
    return isText(file) && trimmed(file.bytes()).substr(0, 1) == "<";
}

bool startsWithBrace(const InputFile& file)
{
    return isText(file) && trimmed(file.bytes()).substr(0, 1) == "{";
}

/// True for text whose first word is a whole number.
bool startsWithCount(const InputFile& file)
{
    WordReader words(file.bytes());
    std::string_view word;
    long long count = 0;
    return isText(file) && words.next(word) && parseInteger(word, count);
}

}  // namespace

const std::vector<Format>& formats()
{
    // A beginning that nothing else has comes first, then a size that nothing else has, then text
    // with marks of its own, and last what is only columns of numbers.
    static const std::vector<Format> all = {
        {"rgl", " bsdf ", "binary that starts with tensor_file", false, isRgl, readRgl, isBinary},
        {"fourier", " bsdf ", "binary that starts with SCATFUN", false, isFourier, readFourier,
         isBinary},
        {"columns", " f32c ", "a first line 'fbrdf-columns 1'", false, isBinaryColumns,
         readBinaryColumns, isBinary},
        {"exr", " exr ", "OpenEXR", false, isExrTable, readExrTable, isBinary},
        {"picture", " hdr tif tiff ", "TIFF or Radiance HDR", false, isPictureTable,
         readPictureTable, isBinary},
        {"mbsdf", " mbsdf ", "binary that starts with 'NVIDIA ARC MBSDF V1'", false, isMbsdf,
         readMbsdf, isBinary},
        {"mit-aniso", " dat ", "binary of 16 int32 and planes of float32", false, isMitAniso,
         readMitAniso, isBinary},
        {"merl", " binary ", "binary of 90 x 90 x 180 x 3 float64", false, isMerl, readMerl,
         isBinary},
        {"npf", "", "binary of 256 x 512 x 3 float32", true, isNpf, readNpf, nullptr, npfRows},
        {"utia", " bin ", "binary of 288 x 288 x 3 float64", true, isUtia, readUtia, isBinary},
        {"nbrdf", " f32 ", "binary of 675 float32 a material", true, isNbrdf, readNbrdf, isBinary,
         nbrdfRows},
        {"klems", " xml ", "XML with a WindowElement", true, isKlems, readKlems, startsWithTag},
        {"xompt", " xompt ", "JSON with OpenMATERIAL 3D's lookupTable", true, isXompt, readXompt,
         startsWithBrace},
        {"speos", " brdf anisotropicbsdf ", "text with the title 'OPTIS - brdf surface file'", true,
         isSpeos, readSpeos, nullptr},
        {"fred", "", "text with 'type bsdf_data'", false, isFred, readFred, nullptr},
        {"pab", " bme ", "lines #format: theta phi and #incident_angle", true, isPab, readPab,
         startsWithMark},
        {"lighttools", " bsdf ", "text with ScatterAzimuth, ScatterRadial and AOI", true,
         isLightTools, readLightTools, nullptr},
        {"zemax", " bsdf ", "text with SpectralContent and ScatterType", false, isZemax, readZemax,
         nullptr},
        {"alta", " alta dat ", "lines #DIM, #PARAM_IN and #PARAM_OUT", false, isAlta, readAlta,
         startsWithMark},
        {"astm", " astm ", "text with a line VARS", true, isAstm, readAstm, isText},
        {"lumos", "", "a comment 'phi_i theta_i phi_o theta_o brdf'", false, isLumos, readLumos,
         nullptr},
        {"csv", " csv ", "text with a header that names the columns", false, isCsv, readCsv,
         isText},
        {"planar-spectra", "", "columns Incident_angle, Measure_angle and wavelengths NNNnm", true,
         isPlanarSpectra, readPlanarSpectra, nullptr},
        {"rt300s", "", "columns stage_deg, theta_i_deg, A_deg, R_deg, brdf", false, isRt300s,
         readRt300s, nullptr},
        {"nist", "", "columns lambda, thetai, phi, thetar, phir, f_r", true, isNist, readNist,
         nullptr},
        {"cornell", " brdf ", "text that starts with the number of wavelengths", true, isCornell,
         readCornell, startsWithCount},
        {"scattered", "", "text with 7 or 9 numbers a row", false, isScattered, readScattered,
         nullptr},
    };
    return all;
}

const Format& formatOf(const InputFile& file)
{
    for (const Format& format : formats())
        if (format.recognises(file)) return format;
    for (const Format& format : formats())
        if (hasExtension(format, file.extension()) && format.resembles && format.resembles(file))
            return format;
    throw unknownFormat(file);
}

}  // namespace fbrdf
