// Cornell.cpp - spectral gonioreflectometer text of Cornell's Program of Computer Graphics, as
// distributed with pbrt-v2 ("irregularly sampled isotropic BRDF").
// Free-form numbers, '#' comments: the number of wavelengths, the wavelengths in nm, then records
// theta_i phi_i theta_o phi_o and one value a wavelength. Angles are radians, both directions point
// away from the surface (the mirror of phi_i = 0 is at phi_o = +-pi); values are in 1/sr without
// the cosine. Knowledge from pbrt-v2, src/materials/measured.cpp and the comments of the files.
// The spectra become linear sRGB; FILE@550 or FILE@0.55 takes one wavelength. Files of the same
// layout in other units are told by size: wavelengths by Wavelengths.h, angles by NumberRows.h.
#include "Formats.h"
#include "NumberRows.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr long long kMostWavelengths = 4096;
constexpr size_t kAngleNumbers = 4;

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
    if (!parseField(word, value))
        throw lineError(file, words.line(), Found(inQuotes(word)).expected("a number"));
    return true;
}

std::vector<double> readWavelengths(const InputFile& file, WordReader& words)
{
    const long long count = wavelengthCount(words);
    if (count == 0)
        throw lineError(
            file, words.line(),
            Found("no number of wavelengths")
                .expected("a whole number from 1 to " + std::to_string(kMostWavelengths)));
    std::vector<double> wavelengths;
    double wavelength = 0.0;
    while (wavelengths.size() < size_t(count) && nextNumber(file, words, wavelength))
        wavelengths.push_back(wavelength);
    if (wavelengths.size() < size_t(count))
        throw lineError(file, words.line(),
                        Found(std::to_string(wavelengths.size()) + " wavelengths")
                            .expected(std::to_string(count)));
    return wavelengths;
}

/// False at the end of the text; a record that is cut short is an error.
bool readRecord(const InputFile& file, WordReader& words, std::vector<double>& record)
{
    size_t got = 0;
    while (got < record.size() && nextNumber(file, words, record[got])) ++got;
    if (got != 0 && got != record.size())
        throw lineError(file, words.line(),
                        Found("a last record of " + std::to_string(got) + " numbers")
                            .expected(std::to_string(record.size())));
    return got != 0;
}

/// True where the number of wavelengths stands in a line of its own, as it does in every file that
/// people write; rows of other formats have several numbers.
bool startsWithCountAlone(const InputFile& file)
{
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    if (!lines.nextData(line)) return false;
    splitWords(line.substr(0, line.find('#')), words);
    return words.size() == 1;
}

}  // namespace

bool isCornell(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    WordReader words(file.bytes());
    const long long count = wavelengthCount(words);
    std::vector<double> first;
    for (long long i = 0; i < std::min(count, 3LL); ++i) {
        std::string_view word;
        double wavelength = 0.0;
        if (!words.next(word) || !parseLocalNumber(word, wavelength)) return false;
        if (!first.empty() && !(wavelength > first.back())) return false;
        first.push_back(wavelength);
    }
    const std::optional<double> unit = nanometresInUnitOf(first);
    return unit && (*unit == 1.0 || startsWithCountAlone(file));
}

Source readCornell(const FileRequest& request)
{
    const InputFile& file = *request.file;
    WordReader words(file.bytes());
    const BandColour colour(request, readWavelengths(file, words));
    AngleRows rows;
    std::vector<double> record(kAngleNumbers + colour.bands());
    rows.reserve(file.size() / (2 * record.size()) + 1);
    while (readRecord(file, words, record))
        rows.add(record[0], record[1], record[2], record[3], colour(record.data() + kAngleNumbers));
    Source source;
    rows.addTo(source);
    if (colour.isSpectral()) source.report.outOfGamut = source.report.negative;
    source.isotropic = true;
    source.description = "Cornell gonioreflectometer, " + colour.description() + ", 1/sr";
    source.assumptions = colour.assumptions();
    source.assumptions.push_back(rows.assumption());
    source.assumptions.emplace_back("isotropic, as such measurements are");
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
