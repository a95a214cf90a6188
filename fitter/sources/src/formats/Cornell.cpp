// Cornell.cpp - spectral gonioreflectometer text of Cornell's Program of Computer Graphics, as
// distributed with pbrt-v2 ("irregularly sampled isotropic BRDF").
// Free-form numbers, '#' comments: the number of wavelengths, the wavelengths in nm, then records
// theta_i phi_i theta_o phi_o and one value a wavelength. Angles are radians, both directions point
// away from the surface (the mirror of phi_i = 0 is at phi_o = +-pi); values are in 1/sr without
// the cosine. Knowledge from pbrt-v2, src/materials/measured.cpp and the comments of the files.
// The spectra become linear sRGB (Spectrum.h).
#include "Formats.h"
#include "SampleRow.h"
#include "Text.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr long long kMostWavelengths = 4096;
constexpr size_t kAngleColumns = 4;

/// The number of wavelengths when the text starts with one, else 0.
long long wavelengthCount(WordReader& words)
{
    std::string_view word;
    long long count = 0;
    const bool whole = words.next(word) && parseInteger(word, count);
    return whole && count >= 1 && count <= kMostWavelengths ? count : 0;
}

/// False at the end of the text.
bool nextNumber(const InputFile& file, WordReader& words, double& value)
{
    std::string_view word;
    if (!words.next(word)) return false;
    if (!parseNumber(word, value))
        throw lineError(file, words.line(), "found " + quoted(word) + ", expected a number");
    return true;
}

std::vector<double> readWavelengths(const InputFile& file, WordReader& words)
{
    const long long count = wavelengthCount(words);
    if (count == 0)
        throw lineError(file, words.line(),
                        "found no number of wavelengths, expected a whole number from 1 to " +
                            std::to_string(kMostWavelengths));
    std::vector<double> wavelengths;
    double wavelength = 0.0;
    while (wavelengths.size() < size_t(count) && nextNumber(file, words, wavelength))
        wavelengths.push_back(wavelength);
    if (wavelengths.size() < size_t(count))
        throw lineError(file, words.line(),
                        "found " + std::to_string(wavelengths.size()) + " wavelengths, expected " +
                            std::to_string(count));
    return wavelengths;
}

/// False at the end of the text; a record that is cut short is an error.
bool readRecord(const InputFile& file, WordReader& words, std::vector<double>& record)
{
    size_t got = 0;
    while (got < record.size() && nextNumber(file, words, record[got])) ++got;
    if (got != 0 && got != record.size())
        throw lineError(file, words.line(),
                        "found a last record of " + std::to_string(got) + " numbers, expected " +
                            std::to_string(record.size()));
    return got != 0;
}

}  // namespace

bool isCornell(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    WordReader words(file.bytes());
    const long long count = wavelengthCount(words);
    double last = 0.0;
    for (long long i = 0; i < std::min(count, 3LL); ++i) {
        std::string_view word;
        double wavelength = 0.0;
        if (!words.next(word) || !parseNumber(word, wavelength)) return false;
        if (!(wavelength > last) || wavelength < 100.0 || wavelength > 1e5) return false;
        last = wavelength;
    }
    return count > 0;
}

Source readCornell(const FileRequest& request)
{
    const InputFile& file = *request.file;
    WordReader words(file.bytes());
    const std::vector<double> wavelengths = readWavelengths(file, words);
    const SpectrumToRgb toRgb(wavelengths);
    Source source;
    std::vector<double> record(kAngleColumns + wavelengths.size());
    while (readRecord(file, words, record)) {
        const Vec3d rgb = toRgb(record.data() + kAngleColumns);
        const size_t before = source.samples.size();
        addRow({directionFromAngles(record[2], record[3]),
                directionFromAngles(record[0], record[1]), rgb},
               source.samples, source.report);
        const bool kept = source.samples.size() > before;
        source.report.outOfGamut += kept && std::min({rgb.x, rgb.y, rgb.z}) < 0.0;
    }
    source.isotropic = true;
    source.description = "Cornell gonioreflectometer, " + std::to_string(wavelengths.size()) +
                         " wavelengths to linear sRGB (D65, CIE 1931), 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
