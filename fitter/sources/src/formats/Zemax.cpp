// Zemax.cpp - the BSDF Data Interchange format, "Zemax tabular BSDF" (Rykowski, Radiant Imaging
// 2008; Zemax knowledge base, "Zemax Tabular BSDF data file format").
// Text, '#' comments. Keywords Source, Symmetry, SpectralContent (Monochrome, XYZ), ScatterType
// (BRDF, BTDF); then SampleRotation, AngleOfIncidence, ScatterAzimuth, ScatterRadial, each with a
// count and on the next line that many angles in degrees; then the blocks Monochrome, or
// TristimulusX, Y and Z, each DataBegin .. DataEnd: for every sample rotation and angle of
// incidence a line "TIS x", then one line an azimuth with one value a radial angle, 1/sr without
// the cosine. 0 means not measured. Scatter angles are centred on the mirror direction: with the
// light at wi = (-sin I, 0, cos I), a scattered direction of azimuth A and radial angle R is (X, Y,
// Z) = (sin R cos A, sin R sin A, cos R) turned by I: wo = (-cos I X + sin I Z, Y, sin I X + cos I
// Z), so azimuth 0 points from the mirror direction to the normal. Both are turned by the sample's
// rotation about the normal. PlaneSymmetrical files give azimuths 0 to 180 of a pattern that
// mirrors in the plane of incidence. XYZ blocks, in any order, become linear sRGB under D65.
// Keywords are compared without case.
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>
#include "Formats.h"
#include "formats/KeywordText.h"
#include "SampleRow.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace fbrdf {
namespace {

struct ZemaxTable {
    std::vector<double> rotation, incidence, azimuth, radial;
    bool tristimulus = false, symmetrical = false;
    std::vector<std::vector<float>> blocks{3};  ///< X, Y, Z, or one; radial angle fastest

    size_t valueCount() const
    {
        return rotation.size() * incidence.size() * azimuth.size() * radial.size();
    }
};

class ZemaxReader {
public:
    explicit ZemaxReader(const InputFile& file) : file_(file), text_(file) {}

    ZemaxTable read()
    {
        std::string_view word;
        while (text_.next(word)) readKeyword(lowerCase(word));
        const size_t expected = table_.tristimulus ? 3 : 1;
        const auto found = static_cast<size_t>(
            std::count_if(table_.blocks.begin(), table_.blocks.end(),
                          [](const std::vector<float>& block) { return !block.empty(); }));
        if (found != expected)
            throw text_.fail(Found(std::to_string(found) + " blocks of data")
                                 .expected(std::to_string(expected)));
        table_.blocks.resize(expected);
        return std::move(table_);
    }

private:
    /// `key` is lower case, as keywords are compared without case.
    void readKeyword(const std::string& key)
    {
        if (key == "source")
            text_.word("a source");
        else if (key == "symmetry")
            table_.symmetrical = lowerCase(text_.word("a symmetry")) == "planesymmetrical";
        else if (key == "spectralcontent")
            table_.tristimulus = text_.oneOf("Monochrome", "XYZ") == 1;
        else if (key == "scattertype")
            requireReflection();
        else if (std::vector<double>* angles = anglesNamed(key))
            *angles = text_.angles();
        else if (key == "databegin")
            readBlock();
        else if (key == "monochrome")
            block_ = 0;
        else if (key.substr(0, 11) == "tristimulus")
            readComponent(key.substr(11));
        else
            throw text_.fail(Found(inQuotes(key)).expected("a keyword"));
    }
    /// The name of a block decides what it has, wherever it stands.
    void readComponent(std::string name)
    {
        if (name.empty()) name = lowerCase(text_.word("X, Y or Z"));
        const size_t component = std::string_view("xyz").find(name);
        if (name.size() != 1 || component == std::string_view::npos)
            throw text_.fail(Found("Tristimulus " + inQuotes(name)).expected("X, Y or Z"));
        block_ = component;
    }
    void requireReflection()
    {
        if (text_.oneOf("BRDF", "BTDF") == 1) throw text_.fail(Found("a BTDF").expected("a BRDF"));
    }
    std::vector<double>* anglesNamed(const std::string& key)
    {
        if (key == "samplerotation") return &table_.rotation;
        if (key == "angleofincidence") return &table_.incidence;
        if (key == "scatterazimuth") return &table_.azimuth;
        if (key == "scatterradial") return &table_.radial;
        return nullptr;
    }
    void readBlock()
    {
        if (table_.valueCount() == 0)
            throw text_.fail(Found("data").expected("all four lists of angles"));
        if (!block_)
            throw text_.fail(
                Found("data without a name").expected("Monochrome or TristimulusX, Y, Z"));
        // A value takes two characters at least, so a hostile count takes no memory.
        std::vector<float> values;
        values.reserve(std::min(table_.valueCount(), file_.size() / 2));
        for (;;) {
            const std::string_view text = text_.word("DataEnd");
            double value = 0.0;
            if (sameWord(text, "DataEnd")) break;
            if (sameWord(text, "TIS"))
                text_.number();
            else if (parseField(text, value))
                values.push_back(static_cast<float>(value));
            else
                throw text_.fail(Found(inQuotes(text)).expected("a number, TIS or DataEnd"));
        }
        if (values.size() != table_.valueCount())
            throw text_.fail(Found(std::to_string(values.size()) + " values")
                                 .expected(std::to_string(table_.valueCount())));
        std::vector<float>& block = table_.blocks[*block_];
        if (!block.empty()) throw text_.fail(Found("a block of data twice").expected("each once"));
        block = std::move(values);
        block_.reset();
    }

    const InputFile& file_;
    KeywordText text_;
    ZemaxTable table_;
    std::optional<size_t> block_;  ///< the one whose name was read last
};

Vec3d turned(const Vec3d& w, double degrees)
{
    const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
    return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

Vec3d scattered(double incidence, double azimuth, double radial)
{
    const Vec3d r = directionFromDegrees(radial, azimuth);
    const double c = std::cos(incidence * kDegree), s = std::sin(incidence * kDegree);
    return {-c * r.x + s * r.z, r.y, s * r.x + c * r.z};
}

Vec3d valueOf(const ZemaxTable& table, size_t index)
{
    const auto value = [&](size_t block) { return double(table.blocks[block][index]); };
    if (!table.tristimulus) return Vec3d(value(0));
    return linearSrgbFromXyz({value(0), value(1), value(2)});
}

bool isMissing(const ZemaxTable& table, size_t index)
{
    return std::all_of(table.blocks.begin(), table.blocks.end(),
                       [&](const std::vector<float>& block) { return block[index] == 0.0f; });
}

void readNode(const ZemaxTable& table, size_t index, std::vector<Sample>& samples,
              SampleReport& report)
{
    if (isMissing(table, index)) {
        addInvalidRow(report);
        return;
    }
    const size_t azimuths = table.azimuth.size(), radials = table.radial.size();
    const size_t light = index / radials / azimuths;
    const double incidence = table.incidence[light % table.incidence.size()];
    const double rotation = table.rotation[light / table.incidence.size()];
    const double azimuth = table.azimuth[index / radials % azimuths];
    const double radial = table.radial[index % radials];
    const Vec3d wi = turned(directionFromDegrees(-incidence, 0.0), rotation);
    const Vec3d wo = turned(scattered(incidence, azimuth, radial), rotation);
    // Radial angle 0 is one direction, given for every azimuth.
    const double weight = radial == 0.0 ? 1.0 / double(azimuths) : 1.0;
    addRow({wo, wi, valueOf(table, index), weight}, samples, report);
}

SampleStream streamOf(ZemaxTable read)
{
    const auto table = std::make_shared<const ZemaxTable>(std::move(read));
    SampleStream stream;
    stream.rows = table->valueCount();
    stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                          SampleReport& report) {
        for (size_t i = 0; i < count; ++i) readNode(*table, size_t(first) + i, samples, report);
    };
    return stream;
}

}  // namespace

bool isZemax(const InputFile& file)
{
    // Comments may be long, so the keywords are looked for and not the first lines.
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    for (int i = 0; i < 4 && lines.nextData(line); ++i) {
        splitWords(line, words);
        if (sameWord(words[0], "SpectralContent") || sameWord(words[0], "ScatterType")) return true;
    }
    return false;
}

Source readZemax(const FileRequest& request)
{
    const InputFile& file = *request.file;
    ZemaxTable table = ZemaxReader(file).read();
    Source source;
    source.isotropic = table.rotation.size() == 1;
    source.description = std::string("Zemax tabular BSDF, ") +
                         (table.tristimulus ? "XYZ to linear sRGB" : "one channel") + ", 1/sr" +
                         (table.symmetrical ? ", symmetrical in the plane of incidence" : "");
    source.assumptions.emplace_back("a value of 0 was not measured");
    source.assumptions.emplace_back(table.tristimulus ? "white of X, Y, Z is D65"
                                                      : "one channel as grey");
    if (source.isotropic) source.assumptions.emplace_back("isotropic, as there is one rotation");
    source.stream = streamOf(std::move(table));
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
