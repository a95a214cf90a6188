// Pab.cpp - measurements of pab's pgII gonio-photometer, as its program Mountain (Apian-Bennewitz),
// Radiance's pabopto2xyz and others write them: a text file for each direction of the light. A
// folder of them is one measurement, and so are several in one file, one after the other.
//   #sample_name "saw-tooth aluminium"
//   #incident_angle 82.5 180     or #intheta 82.5 and #inphi 180
//   #format: theta phi DSF       or BSDF, BRDF, BTDF; DSF includes the cosine of theta
//   84.968 125.790 0.009744      theta, phi and a value, or X Y Z after #colorimetry: CIE-XYZ
// Convention: degrees. theta is measured from the normal of the front, and beyond 90 lies on the
// back; phi turns counter-clockwise as seen from the front; #upphi, 0 where it is missing, is the
// azimuth of the sample's up, which becomes y. Both directions point away from the surface. Where
// the azimuths of the light lie within a quarter or a half turn, the sample is taken to be its own
// mirror image, as pabopto2bsdf does. Source: manual page and code of pabopto2bsdf (Ward 2021).
// Doubtful are the white of X, Y, Z, and that single values are photometric, which only the manual
// page says.
#include "Pab.h"

#include "Formats.h"
#include "NumberRows.h"
#include "Tristimulus.h"

#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr double kUpAzimuth = 90.0;

/// True for a line of a header; replaces `words` by its own, the first without its colon.
bool splitHeader(std::string_view line, std::vector<std::string_view>& words)
{
    words.clear();
    line = trimmed(line);
    if (line.empty() || line.front() != '#') return false;
    splitWords(line.substr(1), words);
    if (!words.empty() && words.front().back() == ':') words.front().remove_suffix(1);
    return true;
}

bool isFormatLine(const std::vector<std::string_view>& words)
{
    return words.size() == 4 && sameWord(words[0], "format") && sameWord(words[1], "theta") &&
           sameWord(words[2], "phi");
}

/// What a header says of the rows below it.
struct PabHeader {
    double theta = kUnset, phi = kUnset;  ///< of the light, degrees
    double up = 0.0;                      ///< azimuth of the sample's up, degrees
    bool hasFormat = false, includesCosine = false, isXyz = false;
};

enum class Side { front, back };

/// What FILE@CHOICE asks for: words between '/'.
struct PabChoice {
    std::string side, white;
};

PabChoice pabChoice(const std::string& path, const std::string& text)
{
    PabChoice choice;
    std::vector<std::string_view> words;
    if (!text.empty()) splitFields(text, '/', words);
    for (const std::string_view word : words) {
        const std::string name = lowerCase(word);
        const bool isSide = name == "front" || name == "back",
                   isWhite = name == "d65" || name == "e";
        std::string& part = isSide ? choice.side : choice.white;
        if (!(isSide || isWhite) || !part.empty())
            throw Error(ErrorKind::usage, path,
                        Found("the choice " + inQuotes(text))
                            .expected("front or back, and d65 or e, each once"));
        part = name;
    }
    return choice;
}

/// One row: degrees, azimuths against up, counter-clockwise as seen from the front.
struct PabRow {
    double thetaIn, phiIn, thetaOut, phiOut;
    Vec3d f;  ///< BSDF; X, Y, Z or one value three times
};

Side sideOf(double theta)
{
    return theta <= 90.0 ? Side::front : Side::back;
}

Vec3d directionOn(Side side, double theta, double phi)
{
    // Seen from the back, with up where it was, azimuths turn the other way round.
    return side == Side::front ? directionFromDegrees(theta, kUpAzimuth + phi)
                               : directionFromDegrees(180.0 - theta, kUpAzimuth - phi);
}

/// The rows of any number of files.
class PabRows {
public:
    void read(const InputFile& file);
    Source source(const std::string& path, const PabChoice& choice) const;

private:
    void readHeader(const InputFile& file, size_t line, const std::vector<std::string_view>& words);
    void addNumbers(const InputFile& file, size_t line, const std::vector<double>& numbers);
    double numberAt(const InputFile& file, size_t line, const std::vector<std::string_view>& words,
                    size_t index) const;
    Side chosenSide(const PabChoice& choice) const;
    bool hasReflectionOf(Side side) const;
    void toRgb(const PabChoice& choice, Source& source) const;

    PabHeader header_;
    bool inRows_ = false;  ///< the next line of a header begins another
    bool isXyz_ = false, isGrey_ = false;
    std::string name_;
    std::vector<PabRow> rows_;
};

double PabRows::numberAt(const InputFile& file, size_t line,
                         const std::vector<std::string_view>& words, size_t index) const
{
    double value = 0.0;
    if (index >= words.size() || !parseLocalNumber(words[index], value) || !std::isfinite(value))
        throw lineError(file, line,
                        Found(index < words.size() ? inQuotes(words[index]) : "nothing")
                            .expected("a number of degrees after #" + std::string(words.front())));
    return value;
}

void PabRows::readHeader(const InputFile& file, size_t line,
                         const std::vector<std::string_view>& words)
{
    if (words.empty()) return;
    const auto is = [&](std::string_view name) { return sameWord(words.front(), name); };
    const bool known = is("format") || is("incident_angle") || is("intheta") || is("inphi") ||
                       is("upphi") || is("colorimetry");
    if (known && inRows_) {
        header_ = {};
        inRows_ = false;
    }
    if (is("incident_angle")) {
        header_.theta = numberAt(file, line, words, 1);
        header_.phi = numberAt(file, line, words, 2);
    } else if (is("intheta")) {
        header_.theta = numberAt(file, line, words, 1);
    } else if (is("inphi")) {
        header_.phi = numberAt(file, line, words, 1);
    } else if (is("upphi")) {
        header_.up = numberAt(file, line, words, 1);
    } else if (is("format")) {
        header_.hasFormat = true;
        header_.includesCosine = sameWord(words.back(), "DSF");
        const bool isBsdf = sameWord(words.back(), "BSDF") || sameWord(words.back(), "BRDF") ||
                            sameWord(words.back(), "BTDF");
        if (!isFormatLine(words) || !(header_.includesCosine || isBsdf))
            throw lineError(file, line,
                            Found("another #format").expected("theta phi and DSF, BSDF or BRDF"));
    } else if (is("colorimetry")) {
        const std::string_view value = words.size() == 2 ? words[1] : std::string_view();
        header_.isXyz = sameWord(value, "CIE-XYZ");
        if (!header_.isXyz && !sameWord(value, "CIE-Y"))
            throw lineError(
                file, line,
                Found("the colorimetry " + inQuotes(value)).expected("CIE-Y or CIE-XYZ"));
    } else if (is("sample_name") && words.size() > 1) {
        const char* first = words[1].data();
        const char* last = words.back().data() + words.back().size();
        name_ = trimmed(std::string_view(first, static_cast<size_t>(last - first)));
        name_.erase(std::remove(name_.begin(), name_.end(), '"'), name_.end());
    }
}

void PabRows::addNumbers(const InputFile& file, size_t line, const std::vector<double>& numbers)
{
    const size_t expected = header_.isXyz ? 5 : 3;
    if (numbers.size() != expected)
        throw lineError(file, line,
                        Found(std::to_string(numbers.size()) + " numbers")
                            .expected(header_.isXyz ? "theta, phi, X, Y, Z" : "theta, phi, value"));
    if (!header_.hasFormat)
        throw lineError(file, line, Found("a row without #format above it").expected("one"));
    if (std::isnan(header_.theta) || std::isnan(header_.phi))
        throw lineError(file, line,
                        Found("a row without the direction of the light above it")
                            .expected("#incident_angle, or #intheta and #inphi"));
    (header_.isXyz ? isXyz_ : isGrey_) = true;
    Vec3d f = header_.isXyz ? Vec3d(numbers[2], numbers[3], numbers[4]) : Vec3d(numbers[2]);
    if (header_.includesCosine) f /= std::abs(std::cos(numbers[0] * kDegree));
    rows_.push_back(
        {header_.theta, header_.phi - header_.up, numbers[0], numbers[1] - header_.up, f});
    inRows_ = true;
}

void PabRows::read(const InputFile& file)
{
    header_ = {};
    inRows_ = false;
    rows_.reserve(rows_.size() + mostRows(file, 3));
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    std::vector<double> numbers;
    while (lines.next(line)) {
        if (splitHeader(line, words)) {
            readHeader(file, lines.number(), words);
        } else if (!trimmed(line).empty()) {
            splitNumbers(line, words);
            parseNumbers(file, lines.number(), words, numbers);
            addNumbers(file, lines.number(), numbers);
        }
    }
    if (isXyz_ && isGrey_)
        throw inputError(
            file,
            Found("X, Y, Z in one part and single values in another").expected("one colorimetry"));
}

bool PabRows::hasReflectionOf(Side side) const
{
    return std::any_of(rows_.begin(), rows_.end(), [&](const PabRow& row) {
        return sideOf(row.thetaIn) == side && sideOf(row.thetaOut) == side;
    });
}

Side PabRows::chosenSide(const PabChoice& choice) const
{
    if (!choice.side.empty()) return choice.side == "front" ? Side::front : Side::back;
    return !hasReflectionOf(Side::front) && hasReflectionOf(Side::back) ? Side::back : Side::front;
}

// Samples hold X, Y, Z until their sums are known.
void PabRows::toRgb(const PabChoice& choice, Source& source) const
{
    Vec3d sums(0.0);
    for (const Sample& sample : source.samples) sums += Vec3d(sample.f);
    const XyzWhite white = whiteOfXyz(choice.white, sums, source.assumptions);
    for (Sample& sample : source.samples)
        sample.f = Vec3f(linearSrgbFromXyz(Vec3d(sample.f), white));
}

/// The signs that the coordinates of the light have, those of an angle near 0 to the axis left out.
struct Cover {
    bool left = false, right = false, below = false, above = false;
};

Cover coverOf(const std::vector<Sample>& samples)
{
    const float least = std::sin(static_cast<float>(kDegree));
    Cover cover;
    for (const Sample& sample : samples) {
        const float across = std::hypot(sample.wi.x, sample.wi.y);
        if (across < least) continue;  // from above
        cover.left |= sample.wi.x < -least * across;
        cover.right |= sample.wi.x > least * across;
        cover.below |= sample.wi.y < -least * across;
        cover.above |= sample.wi.y > least * across;
    }
    return cover;
}

/// True where the light has one azimuth in all samples but those with light from above.
bool haveOneAzimuth(const std::vector<Sample>& samples)
{
    constexpr float kEqual = 1e-4f;
    const Sample* first = nullptr;
    for (const Sample& sample : samples) {
        if (std::hypot(sample.wi.x, sample.wi.y) < kEqual) continue;
        if (!first) first = &sample;
        const Vec3f a = glm::normalize(Vec3f(sample.wi.x, sample.wi.y, 0.0f)),
                    b = glm::normalize(Vec3f(first->wi.x, first->wi.y, 0.0f));
        if (glm::length(a - b) > kEqual) return false;
    }
    return true;
}

void addMirrored(const Vec3d& signs, Source& source)
{
    const size_t count = source.samples.size();
    source.samples.reserve(2 * count);
    for (size_t i = 0; i < count; ++i) {
        const Sample sample = source.samples[i];
        addUnitRow({signs * Vec3d(sample.wo), signs * Vec3d(sample.wi), Vec3d(sample.f)},
                   source.samples, source.report);
    }
}

void completeAzimuths(Source& source)
{
    if (haveOneAzimuth(source.samples)) {
        source.isotropic = true;
        source.assumptions.emplace_back("isotropic, as the light has one azimuth");
        return;
    }
    const Cover cover = coverOf(source.samples);
    const bool inX = cover.left != cover.right, inY = cover.below != cover.above;
    if (inX) addMirrored({-1.0, 1.0, 1.0}, source);
    if (inY) addMirrored({1.0, -1.0, 1.0}, source);
    if (inX || inY)
        source.assumptions.push_back(std::string("its own mirror image, as the light has the ") +
                                     "azimuths of " + (inX && inY ? "a quarter" : "half") +
                                     " of a turn");
}

Source PabRows::source(const std::string& path, const PabChoice& choice) const
{
    const Side side = chosenSide(choice);
    const char* name = side == Side::front ? "front" : "back";
    Source source;
    source.format = "pab";
    source.name = name_;
    source.samples.reserve(rows_.size());
    size_t left = 0;
    for (const PabRow& row : rows_) {
        if (sideOf(row.thetaIn) != side || sideOf(row.thetaOut) != side) ++left;
        addRow({directionOn(side, row.thetaOut, row.phiOut),
                directionOn(side, row.thetaIn, row.phiIn), row.f},
               source.samples, source.report);
    }
    if (left > 0)
        source.assumptions.push_back(std::string("the reflection of the ") + name + "; " +
                                     std::to_string(left) + (left == 1 ? " row" : " rows") +
                                     " of transmission or of the other side not read");
    if (isXyz_)
        toRgb(choice, source);
    else
        source.assumptions.emplace_back("one channel as grey");
    requireSamples(source, path);
    completeAzimuths(source);
    source.description =
        std::string("pgII gonio-photometer, ") + (isXyz_ ? "CIE XYZ" : "one channel") + ", 1/sr";
    return source;
}

/// Regular files of the folder by name, whose first line begins with '#' as all of pab's do.
std::vector<std::string> markedFiles(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (!entry->is_regular_file(error)) continue;
        std::ifstream file(entry->path(), std::ios::binary);
        char start[4] = "";
        file.read(start, sizeof start);
        const std::string_view read(start, static_cast<size_t>(file.gcount()));
        if (trimmed(withoutByteOrderMark(read)).substr(0, 1) == "#")
            paths.push_back(entry->path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace

bool isPab(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    bool hasFormat = false, hasLight = false;
    while (lines.next(line)) {
        if (trimmed(line).empty()) continue;
        if (!splitHeader(line, words)) break;
        if (words.empty()) continue;
        hasFormat |= isFormatLine(words);
        hasLight |= sameWord(words.front(), "incident_angle") || sameWord(words.front(), "intheta");
    }
    return hasFormat && hasLight;
}

Source readPab(const FileRequest& request)
{
    const PabChoice choice = pabChoice(request.file->path(), request.choice);
    PabRows rows;
    rows.read(*request.file);
    return rows.source(request.file->path(), choice);
}

bool isPabFolder(const std::string& path)
{
    const std::vector<std::string> paths = markedFiles(path);
    return std::any_of(paths.begin(), paths.end(),
                       [](const std::string& file) { return isPab(InputFile(file)); });
}

Source readPabFolder(const std::string& path, const std::string& choice)
{
    const PabChoice chosen = pabChoice(path, choice);
    PabRows rows;
    size_t files = 0;
    for (const std::string& name : markedFiles(path)) {
        const InputFile file(name);
        if (!isPab(file)) continue;
        rows.read(file);
        ++files;
    }
    Source source = rows.source(path, chosen);
    source.description += ", " + std::to_string(files) + (files == 1 ? " file" : " files");
    return source;
}

}  // namespace fbrdf
