// Alta.cpp - text data of the ALTA library (Belcour, Barla, Pacanowski: "ALTA: a BRDF analysis
// library", MAM 2014).
// Header lines "#KEY value": #DIM nX nY, #PARAM_IN and #PARAM_OUT name the columns, #VS how
// many columns of confidence follow (not read); other keys are for people. Then one row a sample:
// nX coordinates, nY values, radians, white space. L is the light (wi), V the view (wo), both away
// from the surface; h and d are Rusinkiewicz' half and difference vectors, where ALTA's d is that
// of V.
//   PARAM_IN   COS_TH; COS_TH_TD; RUSIN_TH_TD (phi_d = pi/2); RUSIN_TH_TD_PD (phi_h = 0);
//              RUSIN_TH_PH_TD_PD; SPHERICAL_TL_PL_TV_PV; ISOTROPIC_TV_TL_DPHI (V at azimuth 0, L at
//              dphi); ISOTROPIC_TV_PROJ_DPHI and ISOTROPIC_TL_TV_PROJ_DPHI (theta_V cos dphi,
//              theta_V sin dphi with L at azimuth 0, so dphi = 0 is RETRO-reflection and pi the
//              mirror); CARTESIAN (V, then L)
//   PARAM_OUT  INV_STERADIAN (1/sr), INV_STERADIAN_COSINE_FACTOR (times cos theta_V, divided out
//              here), RGB_COLOR (linear), XYZ_COLOR (to linear sRGB)
// This follows the documentation of ALTA's `params` class. A file that does not declare both is
// refused: a cosine is not to be guessed.
#include "Formats.h"
#include "NumberRows.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace fbrdf {
namespace {

using Pair = DirectionPair<double>;

/// One input parameterisation: its name, its coordinates, and the pair they stand for.
struct Parameterisation {
    const char* name;
    size_t dimension;
    bool isotropic;
    Pair (*pair)(const double* x);
};

/// ALTA's difference vector is the view's, Rusinkiewicz' the light's.
Pair fromHalf(double theta_h, double phi_h, double theta_d, double phi_d)
{
    const Pair pair = pairFromHalfDifference({theta_h, phi_h, theta_d, phi_d});
    return {pair.wi, pair.wo};
}

/// Zenith angle and azimuth as a point of the plane: (theta cos phi, theta sin phi).
Vec3d fromProjected(double x, double y)
{
    return directionFromAngles(std::hypot(x, y), std::atan2(y, x));
}

constexpr Parameterisation kInputs[] = {
    {"COS_TH", 1, true, [](const double* x) { return fromHalf(std::acos(x[0]), 0, 0, 0); }},
    {"COS_TH_TD", 2, true,
     [](const double* x) { return fromHalf(std::acos(x[0]), 0, std::acos(x[1]), 0); }},
    {"RUSIN_TH_TD", 2, true, [](const double* x) { return fromHalf(x[0], 0, x[1], kPi / 2); }},
    {"RUSIN_TH_TD_PD", 3, true, [](const double* x) { return fromHalf(x[0], 0, x[1], x[2]); }},
    {"RUSIN_TH_PH_TD_PD", 4, false,
     [](const double* x) { return fromHalf(x[0], x[1], x[2], x[3]); }},
    {"SPHERICAL_TL_PL_TV_PV", 4, false,
     [](const double* x) {
         return Pair{directionFromAngles(x[2], x[3]), directionFromAngles(x[0], x[1])};
     }},
    {"ISOTROPIC_TV_TL_DPHI", 3, true,
     [](const double* x) {
         return Pair{directionFromAngles(x[0], 0), directionFromAngles(x[1], x[2])};
     }},
    {"ISOTROPIC_TV_PROJ_DPHI", 2, true,
     [](const double* x) {
         return Pair{fromProjected(x[0], x[1]), Vec3d(0, 0, 1)};
     }},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", 3, true,
     [](const double* x) {
         return Pair{fromProjected(x[1], x[2]), directionFromAngles(x[0], 0)};
     }},
    {"CARTESIAN", 6, false,
     [](const double* x) {
         return Pair{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
     }},
};

enum class Output { inverseSteradian, withCosine, rgb, xyz };
const std::map<std::string, Output> kOutputs = {
    {"INV_STERADIAN", Output::inverseSteradian},
    {"INV_STERADIAN_COSINE_FACTOR", Output::withCosine},
    {"RGB_COLOR", Output::rgb},
    {"XYZ_COLOR", Output::xyz},
};

struct AltaLayout {
    const Parameterisation* input = nullptr;
    Output output = Output::inverseSteradian;
    size_t values = 1;  ///< 1 or 3
};

using Header = std::map<std::string, std::vector<std::string>>;

Header readHeader(std::string_view text)
{
    Header header;
    LineReader lines(text);
    std::string_view line;
    std::vector<std::string_view> words;
    while (lines.next(line)) {
        if (trimmed(line).empty()) continue;
        if (line.front() != '#') break;
        splitWords(line.substr(1), words);
        if (!words.empty())
            header[std::string(words[0])] =
                std::vector<std::string>(words.begin() + 1, words.end());
    }
    return header;
}

std::string firstOf(const InputFile& file, const Header& header, const std::string& key)
{
    const auto found = header.find(key);
    if (found == header.end() || found->second.empty())
        throw inputError(file, "found no #" + key + ", expected it: nothing is guessed");
    return found->second.front();
}

const Parameterisation& inputNamed(const InputFile& file, const std::string& name)
{
    std::string known;
    for (const Parameterisation& input : kInputs) {
        if (name == input.name) return input;
        known += std::string(known.empty() ? "" : ", ") + input.name;
    }
    throw inputError(file, "found #PARAM_IN " + inQuotes(name) + ", expected one of " + known);
}

Output outputNamed(const InputFile& file, const std::string& name)
{
    const auto found = kOutputs.find(name);
    if (found == kOutputs.end())
        throw inputError(file, "found #PARAM_OUT " + inQuotes(name) +
                                   ", expected INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR, "
                                   "RGB_COLOR or XYZ_COLOR");
    return found->second;
}

AltaLayout layoutOf(const InputFile& file, const Header& header)
{
    AltaLayout layout;
    layout.input = &inputNamed(file, firstOf(file, header, "PARAM_IN"));
    layout.output = outputNamed(file, firstOf(file, header, "PARAM_OUT"));
    firstOf(file, header, "DIM");
    const std::vector<std::string>& dimensions = header.at("DIM");
    long long x = 0, y = 0;
    const bool read =
        dimensions.size() == 2 && parseInteger(dimensions[0], x) && parseInteger(dimensions[1], y);
    const bool colour = layout.output == Output::rgb || layout.output == Output::xyz;
    if (!read || x != static_cast<long long>(layout.input->dimension) ||
        !(y == 3 || (y == 1 && !colour)))
        throw inputError(
            file, "found #DIM " + inQuotes(dimensions.front()) +
                      " .., expected two counts: " + std::to_string(layout.input->dimension) +
                      " for " + layout.input->name + (colour ? " and 3" : " and 1 or 3"));
    layout.values = static_cast<size_t>(y);
    return layout;
}

SampleRow rowOf(const AltaLayout& layout, const std::vector<double>& numbers)
{
    const Pair pair = layout.input->pair(numbers.data());
    const double* y = numbers.data() + layout.input->dimension;
    Vec3d f = layout.values == 3 ? Vec3d(y[0], y[1], y[2]) : Vec3d(y[0]);
    if (layout.output == Output::xyz) f = linearSrgbFromXyz(f);
    if (layout.output == Output::withCosine)
        f *= glm::length(pair.wo) / std::max(pair.wo.z, kHorizonCosine);
    return {pair.wo, pair.wi, f};
}

}  // namespace

bool isAlta(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    return readHeader(file.bytes()).count("DIM") != 0;
}

Source readAlta(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const AltaLayout layout = layoutOf(file, readHeader(file.bytes()));
    const size_t least = layout.input->dimension + layout.values;
    LineReader lines(file.bytes());
    Source source;
    std::string_view line;
    std::vector<std::string_view> words;
    std::vector<double> numbers;
    while (lines.nextData(line)) {
        splitNumbers(line, words);
        if (words.size() < least)
            throw lineError(file, lines.number(),
                            "found " + std::to_string(words.size()) +
                                " numbers, expected at least " + std::to_string(least));
        parseNumbers(file, lines.number(), words, numbers);
        addRow(rowOf(layout, numbers), source.samples, source.report);
    }
    source.isotropic = layout.input->isotropic;
    source.description = std::string("ALTA data, ") + layout.input->name +
                         (layout.values == 3 ? ", three channels" : ", one channel") + ", 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
