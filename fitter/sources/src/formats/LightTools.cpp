// LightTools.cpp - the BSDF of measurements in LightTools (Synopsys): text, '#' comments.
//   Symmetry PlaneSymmetrical      or Asymmetrical
//   SpectralContent Monochrome     or XYZ
//   ScatterAzimuth 4  0 90 180 270 counts, and as many angles in degrees
//   ScatterRadial 3  0 30 60
//   DataBegin
//   AOI 30  POI 0  Side Front  Wavelength 550  ScatterType BRDF
//   TIS 0.5  0.1 0.1 0.1 ..        the values of each azimuth in turn, 1/sr without the cosine
//   DataEnd
// There is a block from AOI to the values for each angle of incidence, side, wavelength and type,
// and with XYZ for each component, TristimulusValue TrisX, TrisY or TrisZ. Keywords are compared
// without case. Scatter angles are zenith angle and azimuth about the normal. The light comes from
// azimuth 90; an AOI above 90 is measured from the other side. FILE@back takes the back, FILE@550
// one of several wavelengths. Layout and azimuth are from the reader of libbsdf (Kimura 2015,
// LightToolsBsdfReader); no such file was at hand. Doubtful are the zero of POI, so that files with
// several are refused, and what AOI above 90 means, where libbsdf takes 0.
#include "Formats.h"
#include "formats/KeywordText.h"
#include "SampleRow.h"
#include "Tristimulus.h"
#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/sources/Fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fbrdf {
namespace {

constexpr double kLightAzimuth = 90.0;
constexpr size_t kNoComponent = 3;

/// What stands above the values of a block.
struct LightToolsBlock {
    std::optional<double> incidence, plane;  ///< degrees
    double wavelength = 0.0;
    bool isBack = false, isTransmission = false;
    size_t component = kNoComponent;  ///< of X, Y, Z
    std::vector<float> values;        ///< azimuth x radial angle, radial angle fastest
};

struct LightToolsFile {
    std::vector<double> azimuth, radial;
    bool isXyz = false, isSymmetrical = false;
    std::vector<LightToolsBlock> blocks;  ///< of reflection
    size_t transmissions = 0;

    size_t valueCount() const { return azimuth.size() * radial.size(); }
};

class LightToolsReader {
public:
    explicit LightToolsReader(const InputFile& input) : input_(input), text_(input) {}

    LightToolsFile read()
    {
        std::string key;
        do {
            key = lowerCase(text_.word("DataBegin"));
            readOfHead(key);
        } while (key != "databegin");
        if (file_.valueCount() == 0)
            throw text_.fail(Found("data").expected("ScatterAzimuth and ScatterRadial above"));
        while ((key = lowerCase(text_.word("DataEnd"))) != "dataend") readOfBlock(key);
        return std::move(file_);
    }

private:
    void readOfHead(const std::string& key)
    {
        if (key == "symmetry")
            file_.isSymmetrical = sameWord(text_.word("a symmetry"), "PlaneSymmetrical");
        else if (key == "spectralcontent")
            file_.isXyz = text_.oneOf("Monochrome", "XYZ") == 1;
        else if (key == "scatterazimuth")
            file_.azimuth = text_.angles();
        else if (key == "scatterradial")
            file_.radial = text_.angles();
        else if (key != "databegin")
            throw text_.fail(Found(inQuotes(key)).expected("a keyword or DataBegin"));
    }

    void readOfBlock(const std::string& key)
    {
        if (key == "aoi")
            readIncidence();
        else if (key == "poi")
            block_.plane = text_.number();
        else if (key == "side")
            block_.isBack = text_.oneOf("Front", "Back") == 1;
        else if (key == "wavelength")
            block_.wavelength = text_.number();
        else if (key == "scattertype")
            block_.isTransmission = text_.oneOf("BRDF", "BTDF") == 1;
        else if (key == "tristimulusvalue")
            readComponent();
        else if (key == "tis")
            readValues();
        else
            throw text_.fail(Found(inQuotes(key)).expected("a keyword of a block or DataEnd"));
    }

    void readIncidence()
    {
        const double angle = text_.number();
        if (!(angle >= 0.0 && angle <= 180.0))
            throw text_.fail(Found("AOI " + numberText(angle)).expected("0 to 180 degrees"));
        block_.incidence = std::min(angle, 180.0 - angle);
    }

    void readComponent()
    {
        constexpr std::array<const char*, 3> kNames = {"TrisX", "TrisY", "TrisZ"};
        const std::string_view name = text_.word("TrisX, TrisY or TrisZ");
        block_.component =
            size_t(std::find_if(kNames.begin(), kNames.end(),
                                [&](const char* known) { return sameWord(known, name); }) -
                   kNames.begin());
        if (block_.component == kNames.size())
            throw text_.fail(Found(inQuotes(name)).expected("TrisX, TrisY or TrisZ"));
    }

    void readValues()
    {
        text_.number();
        if (!block_.incidence) throw text_.fail(Found("values").expected("an AOI above them"));
        if (file_.isXyz != (block_.component != kNoComponent))
            throw text_.fail(
                Found(file_.isXyz ? "values without TristimulusValue" : "a TristimulusValue")
                    .expected(file_.isXyz ? "TrisX, TrisY or TrisZ, as the content is XYZ"
                                          : "none, as the content is Monochrome"));
        // A value takes two characters at least, so a hostile count takes no memory.
        block_.values.reserve(std::min(file_.valueCount(), input_.size() / 2));
        while (block_.values.size() < file_.valueCount()) block_.values.push_back(text_.value());
        if (block_.isTransmission)
            ++file_.transmissions;
        else
            file_.blocks.push_back(std::move(block_));
        block_ = {};
    }

    const InputFile& input_;
    KeywordText text_;
    LightToolsFile file_;
    LightToolsBlock block_;
};

/// What FILE@CHOICE asks for: a side, a wavelength, or both with '/' between.
struct LightToolsChoice {
    std::string side, wavelength;
};

LightToolsChoice lightToolsChoice(const FileRequest& request)
{
    LightToolsChoice choice;
    std::vector<std::string_view> words;
    if (!request.choice.empty()) splitFields(request.choice, '/', words);
    for (const std::string_view word : words) {
        const std::string name = lowerCase(word);
        std::string& part = name == "front" || name == "back" ? choice.side : choice.wavelength;
        if (name.empty() || !part.empty())
            throw Error(ErrorKind::usage, request.file->path(),
                        Found("the choice " + inQuotes(request.choice))
                            .expected("front or back, and a wavelength, each once"));
        part = name;
    }
    return choice;
}

/// The blocks of one side, by incidences and by bands.
struct LightToolsTable {
    LightToolsFile file;
    std::vector<double> incidence;              ///< degrees
    std::vector<double> wavelength;             ///< of the bands; empty for X, Y, Z
    std::vector<const LightToolsBlock*> block;  ///< incidence x band, band fastest
    std::optional<BandColour> colour;           ///< none where no wavelength is told
    XyzWhite white = XyzWhite::d65;

    size_t bands() const { return wavelength.empty() ? 3 : wavelength.size(); }
    Vec3d valueOf(size_t incidenceIndex, size_t index, std::vector<double>& values) const
    {
        values.clear();
        for (size_t b = 0; b < bands(); ++b)
            values.push_back(double(block[incidenceIndex * bands() + b]->values[index]));
        if (file.isXyz) return linearSrgbFromXyz({values[0], values[1], values[2]}, white);
        return colour ? (*colour)(values.data()) : Vec3d(values[0]);
    }
};

size_t placeOf(double value, std::vector<double>& values)
{
    const auto found = std::find(values.begin(), values.end(), value);
    if (found == values.end()) values.push_back(value);
    return size_t(std::find(values.begin(), values.end(), value) - values.begin());
}

/// The side that was chosen, or the one that the file has, the front before the back.
bool takesBack(const LightToolsFile& file, const LightToolsChoice& choice)
{
    if (!choice.side.empty()) return choice.side == "back";
    return std::all_of(file.blocks.begin(), file.blocks.end(),
                       [](const LightToolsBlock& block) { return block.isBack; });
}

void requireOnePlane(const InputFile& input, const std::vector<const LightToolsBlock*>& blocks)
{
    for (const LightToolsBlock* block : blocks)
        if (block->plane.value_or(0.0) != blocks.front()->plane.value_or(0.0))
            throw inputError(input,
                             Found("several planes of incidence (POI)").expected("one of them"));
}

void arrangeBlocks(const InputFile& input, bool back, LightToolsTable& table)
{
    std::vector<const LightToolsBlock*> chosen;
    for (const LightToolsBlock& block : table.file.blocks)
        if (block.isBack == back) chosen.push_back(&block);
    if (chosen.empty())
        throw inputError(input,
                         Found(std::string("no reflection of the ") + (back ? "back" : "front"))
                             .expected("a block with ScatterType BRDF"));
    requireOnePlane(input, chosen);
    for (const LightToolsBlock* block : chosen) {
        placeOf(*block->incidence, table.incidence);
        if (!table.file.isXyz) placeOf(block->wavelength, table.wavelength);
    }
    table.block.assign(table.incidence.size() * table.bands(), nullptr);
    for (const LightToolsBlock* block : chosen) {
        const size_t band =
            table.file.isXyz ? block->component : placeOf(block->wavelength, table.wavelength);
        const size_t place = placeOf(*block->incidence, table.incidence) * table.bands() + band;
        if (table.block[place])
            throw inputError(input, Found("AOI " + numberText(*block->incidence) + " twice")
                                        .expected("a block for each side and wavelength"));
        table.block[place] = block;
    }
    if (std::count(table.block.begin(), table.block.end(), nullptr) > 0)
        throw inputError(input, Found(std::to_string(chosen.size()) + " blocks")
                                    .expected(std::to_string(table.block.size()) + ", " +
                                              std::to_string(table.bands()) + " for each AOI"));
}

/// 1 / number of times that the table gives a direction: the normal for every azimuth, the seam
/// twice.
double weightOf(const LightToolsFile& file, size_t azimuth, size_t radial)
{
    if (file.radial[radial] == 0.0) return 1.0 / double(file.azimuth.size());
    const auto [least, most] = std::minmax_element(file.azimuth.begin(), file.azimuth.end());
    const bool isSeam = file.azimuth[azimuth] == *least || file.azimuth[azimuth] == *most;
    return isSeam && *most - *least == 360.0 ? 0.5 : 1.0;
}

SampleStream streamOfTable(std::shared_ptr<const LightToolsTable> table)
{
    SampleStream stream;
    stream.rows = table->incidence.size() * table->file.valueCount();
    stream.read = [table = std::move(table)](uint64_t first, size_t count,
                                             std::vector<Sample>& samples, SampleReport& report) {
        const LightToolsFile& file = table->file;
        std::vector<double> values;
        for (size_t row = size_t(first); row < size_t(first) + count; ++row) {
            const size_t index = row % file.valueCount(), light = row / file.valueCount();
            const size_t azimuth = index / file.radial.size(), radial = index % file.radial.size();
            addRow({directionFromDegrees(file.radial[radial], file.azimuth[azimuth]),
                    directionFromDegrees(table->incidence[light], kLightAzimuth),
                    table->valueOf(light, index, values), weightOf(file, azimuth, radial)},
                   samples, report);
        }
    };
    return stream;
}

Vec3d sumsOfXyz(const LightToolsTable& table)
{
    Vec3d sums(0.0);
    for (size_t i = 0; i < table.block.size(); ++i)
        for (const float value : table.block[i]->values)
            if (std::isfinite(value)) sums[int(i % 3)] += double(value);
    return sums;
}

void chooseColour(const FileRequest& request, const std::string& choice, LightToolsTable& table)
{
    const bool isNamed = !table.file.isXyz && table.wavelength != std::vector<double>{0.0};
    if (isNamed)
        table.colour.emplace(FileRequest{request.file, choice, request.options}, table.wavelength);
    else if (!choice.empty())
        throw Error(ErrorKind::usage, request.file->path(),
                    Found("the choice " + inQuotes(choice))
                        .expected("front or back: the file has no wavelengths"));
}

std::string contentOf(const LightToolsTable& table)
{
    if (table.file.isXyz) return "XYZ to linear sRGB";
    return table.colour ? table.colour->description() : "one channel";
}

void noteAssumptions(const LightToolsTable& table, bool back, Source& source)
{
    if (table.colour) source.assumptions = table.colour->assumptions();
    source.assumptions.emplace_back("isotropic, as there is one plane of incidence");
    if (!table.file.isXyz && !table.colour) source.assumptions.emplace_back("one channel as grey");
    const size_t left = table.file.transmissions + table.file.blocks.size() - table.block.size();
    if (left > 0)
        source.assumptions.push_back(std::string("the reflection of the ") +
                                     (back ? "back" : "front") + "; " + std::to_string(left) +
                                     (left == 1 ? " block" : " blocks") +
                                     " of transmission or of the other side not read");
}

}  // namespace

bool isLightTools(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    constexpr int kLines = 16;  // of a head before its first list of angles
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    bool hasAngles = false;
    for (int i = 0; i < kLines && !hasAngles && lines.nextData(line); ++i) {
        splitWords(line, words);
        hasAngles = sameWord(words[0], "ScatterAzimuth") || sameWord(words[0], "ScatterRadial");
        if (sameWord(words[0], "SampleRotation")) return false;  // Zemax
    }
    while (hasAngles && lines.nextData(line)) {
        splitWords(line, words);
        if (sameWord(words[0], "AOI")) return true;
        if (sameWord(words[0], "SampleRotation")) return false;
    }
    return false;
}

Source readLightTools(const FileRequest& request)
{
    const InputFile& input = *request.file;
    const LightToolsChoice choice = lightToolsChoice(request);
    const auto table = std::make_shared<LightToolsTable>();
    table->file = LightToolsReader(input).read();
    const bool back = takesBack(table->file, choice);
    arrangeBlocks(input, back, *table);
    Source source;
    chooseColour(request, choice.wavelength, *table);
    noteAssumptions(*table, back, source);
    if (table->file.isXyz) table->white = whiteOfXyz("", sumsOfXyz(*table), source.assumptions);
    source.isotropic = true;
    source.description =
        "LightTools BSDF, " + contentOf(*table) + ", 1/sr" +
        (table->file.isSymmetrical ? ", symmetrical in the plane of incidence" : "");
    source.stream = streamOfTable(table);
    requireSamples(source, input.path());
    return source;
}

}  // namespace fbrdf
