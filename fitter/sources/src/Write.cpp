#include <fbrdf/sources/Write.h>

#include "MerlGrid.h"
#include "SpreadPairs.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kSpreadPairs = 65536;
constexpr size_t kMaxNumber = 32;  // the longest float to_chars writes has 15 characters

void appendNumber(std::string& text, float value, char after)
{
    char buffer[kMaxNumber];
    const auto end = std::to_chars(buffer, buffer + kMaxNumber, value).ptr;
    text.append(buffer, end);
    text += after;
}

void appendRow(std::string& text, const Sample& s, bool weights)
{
    for (const Vec3f* v : {&s.wo, &s.wi, &s.f})
        for (int i = 0; i < 3; ++i)
            appendNumber(text, (*v)[i], v == &s.f && i == 2 && !weights ? '\n' : ',');
    if (weights) appendNumber(text, s.weight, '\n');
}

bool hasWeights(const Source& source)
{
    bool differs = false;
    forEachBlock(source, [&](const Sample* samples, size_t count) {
        for (size_t i = 0; i < count; ++i) differs |= samples[i].weight != 1.0f;
    });
    return differs;
}

/// Samples of a source that has only a function.
std::vector<Sample> evaluatedSamples(const Source& source)
{
    std::vector<Sample> samples;
    for (const DirectionPair<double>& pair : spreadPairs(kSpreadPairs))
        samples.push_back(
            {Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(source.evaluate(pair.wo, pair.wi))});
    return samples;
}

bool isMeasured(const Vec3d& f)
{
    return f.x >= 0.0 && f.y >= 0.0 && f.z >= 0.0 && std::isfinite(f.x + f.y + f.z);
}

/// f of a cell; a negative value where there is none.
using CellFunction = std::function<Vec3d(size_t cell)>;

CellFunction cellsOf(const Source& source, const MerlGrid& grid, const std::string& path)
{
    if (source.stream.geometry == grid.key())
        return [&source](size_t cell) {
            std::vector<Sample> sample;
            SampleReport ignored;
            source.stream.read(cell, 1, sample, ignored);
            return sample.empty() ? Vec3d(-1.0) : Vec3d(sample.front().f);
        };
    if (!source.evaluate)
        throw Error(ErrorKind::usage, path,
                    Found("a source of scattered samples")
                        .expected("one that can be evaluated anywhere: fit it first"));
    return [&source, &grid](size_t cell) {
        const DirectionPair<double> pair = grid.pair(cell);
        if (pair.wo.z <= 0.0 || pair.wi.z <= 0.0) return Vec3d(-1.0);
        return source.evaluate(pair.wo, pair.wi);
    };
}

}  // namespace

void writeCsv(const Source& source, const std::string& path)
{
    Source evaluated;
    if (!hasSamples(source)) evaluated.samples = evaluatedSamples(source);
    const Source& written = hasSamples(source) ? source : evaluated;
    const bool weights = hasWeights(written);
    OutputFile file(path);
    file.write(std::string("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b") + (weights ? ",weight\n" : "\n"));
    std::string text;
    forEachBlock(written, [&](const Sample* samples, size_t count) {
        text.clear();
        for (size_t i = 0; i < count; ++i) appendRow(text, samples[i], weights);
        file.write(text);
    });
    file.commit();
}

void writeMerl(const Source& source, const std::string& path)
{
    constexpr std::array<double, 3> kScale = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
    const MerlGrid grid;
    const CellFunction cell = cellsOf(source, grid, path);
    std::vector<double> planes(3 * grid.size());
    for (size_t i = 0; i < grid.size(); ++i) {
        const Vec3d f = cell(i);
        for (size_t c = 0; c < 3; ++c)
            planes[c * grid.size() + i] = isMeasured(f) ? f[int(c)] / kScale[c] : -1.0;
    }
    const std::array<int32_t, 3> counts = {90, 90, 180};
    OutputFile file(path);
    file.write({reinterpret_cast<const char*>(counts.data()), sizeof counts});
    file.write({reinterpret_cast<const char*>(planes.data()), planes.size() * sizeof(double)});
    file.commit();
}

}  // namespace fbrdf
