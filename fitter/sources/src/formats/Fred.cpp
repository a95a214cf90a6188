// Fred.cpp - tabulated BSDF text of the optics program FRED (Photon Engineering).
// "type bsdf_data", then an optional "format angles=deg bsdf=value scale=1"; blocks of one line
// "theta_i phi_i" and lines "theta_s phi_s value". Degrees; values are the BSDF in 1/sr without the
// cosine, times `scale`. phi_i is the azimuth of the light's PROPAGATION, so the source is at
// phi_i + 180; phi_s is that of the scattered light, away from the surface. From FRED's help on the
// tabulated data scatter model and the files of the University of Arizona LOFT group, whose
// highlights confirm the azimuths.
#include "Formats.h"

#include <fbrdf/base/Found.h>
#include "NumberRows.h"

namespace fbrdf {
namespace {

constexpr std::string_view kType = "bsdf_data";

/// scale=X of a format line. Throws for angles or values in another form than this reader knows.
double scaleOf(const InputFile& file, size_t line, const std::vector<std::string_view>& words)
{
    double scale = 1.0;
    for (size_t i = 1; i < words.size(); ++i) {
        const std::string word = lowerCase(words[i]);
        const bool known = word == "angles=deg" || word == "bsdf=value";
        const bool scales =
            word.substr(0, 6) == "scale=" && parseNumber(std::string_view(word).substr(6), scale);
        if (!known && !scales)
            throw lineError(
                file, line,
                Found(inQuotes(words[i])).expected("angles=deg, bsdf=value or scale=NUMBER"));
    }
    return scale;
}

class FredReader {
public:
    explicit FredReader(const InputFile& file) : file_(file) {}

    void readLine(size_t line, const std::vector<std::string_view>& words, Source& source)
    {
        const std::string first = lowerCase(words[0]);
        if (first == "type") return;
        if (first == "format") {
            scale_ = scaleOf(file_, line, words);
            return;
        }
        if (words.size() != 2 && words.size() != 3)
            throw lineError(file_, line,
                            Found(std::to_string(words.size()) + " numbers")
                                .expected("2 (incident) or 3 (scattered)"));
        parseNumbers(file_, line, words, numbers_);
        if (words.size() == 2)
            setIncident(numbers_[0], numbers_[1]);
        else
            addScattered(line, numbers_.data(), source);
    }

private:
    void setIncident(double theta, double phi)
    {
        wi_ = directionFromDegrees(theta, phi + 180.0);
        hasIncident_ = true;
    }
    void addScattered(size_t line, const double* v, Source& source)
    {
        if (!hasIncident_)
            throw lineError(file_, line,
                            Found("a scattered direction").expected("an incident first"));
        addRow({directionFromDegrees(v[0], v[1]), wi_, Vec3d(v[2] * scale_)}, source.samples,
               source.report);
    }

    const InputFile& file_;
    Vec3d wi_{0.0, 0.0, 1.0};
    bool hasIncident_ = false;
    double scale_ = 1.0;
    std::vector<double> numbers_;
};

}  // namespace

bool isFred(const InputFile& file)
{
    LineReader lines(file.bytes().substr(0, 4096));
    std::string_view line;
    std::vector<std::string_view> words;
    if (!looksLikeText(file.bytes()) || !lines.nextData(line)) return false;
    splitWords(line, words);
    return words.size() == 2 && lowerCase(words[0]) == "type" && lowerCase(words[1]) == kType;
}

Source readFred(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    FredReader reader(file);
    Source source;
    std::string_view line;
    std::vector<std::string_view> words;
    source.samples.reserve(mostRows(file, 3));
    while (lines.nextData(line)) {
        splitNumbers(line, words);
        reader.readLine(lines.number(), words, source);
    }
    source.assumptions.emplace_back("one channel as grey");
    source.description = "FRED tabulated BSDF, one channel, 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
