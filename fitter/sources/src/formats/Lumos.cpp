// Lumos.cpp - white-space text tables of the `lumos` tools for satellite brightness (Fankhauser
// 2023): the Starlink chassis, and airborne scans of vegetation by NASA's CAR instrument.
// Comments start with '#', the last of them names the columns: phi_i theta_i phi_o theta_o brdf.
// BEWARE: phi is the ZENITH angle and theta the AZIMUTH. Degrees; both directions point away from
// the surface; zenith angles may be signed (negative: azimuth + 180). Values in 1/sr without the
// cosine. From the comments of the files and lumos' documentation.
#include "Formats.h"

#include <fbrdf/base/Found.h>
#include "NumberRows.h"

namespace fbrdf {
namespace {

const std::vector<std::string_view> kNames = {"phi_i", "theta_i", "phi_o", "theta_o", "brdf"};

}  // namespace

bool isLumos(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    while (lines.next(line) && !line.empty() && line.front() == '#') {
        splitWords(line.substr(1), words);
        if (words == kNames) return true;
    }
    return false;
}

Source readLumos(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    Source source;
    std::string_view line;
    std::vector<std::string_view> words;
    std::vector<double> v;
    source.samples.reserve(mostRows(file, kNames.size()));
    while (lines.nextData(line)) {
        splitNumbers(line, words);
        if (words.size() != kNames.size())
            throw lineError(file, lines.number(),
                            Found(std::to_string(words.size()) + " numbers").expected("5"));
        parseNumbers(file, lines.number(), words, v);
        addRow({directionFromDegrees(v[2], v[3]), directionFromDegrees(v[0], v[1]), Vec3d(v[4])},
               source.samples, source.report);
    }
    source.assumptions.emplace_back("one channel as grey");
    source.description = "scattered samples, one channel, 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
