#include "bench/SamplingBench.h"

#include "Output.h"
#include "Reflectance.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/environment/LobeFit.h>
#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

Material materialOf(const std::string& name, const Contender& form, const BenchOptions& options)
{
    FitOptions fit = options.fit;
    fit.form = form.name;
    fit.maxBytes = form.maxBytes;
    fit.heldOut = false;
    return fitMaterial(openSource(name, options.source), fit).material;
}

SamplingScore sampledScore(const std::string& source, const Contender& form,
                           const BenchOptions& options)
{
    const auto material = std::make_shared<const Material>(materialOf(source, form, options));
    const int threads = options.fit.threads;
    LobeFitOptions lobeFit;
    lobeFit.threads = threads;
    const LobeTable lobes = fitLobes(*material, lobeFit);
    const BrdfFunction f = shaderFunction(material);
    const ReflectedLight light(f, isIsotropic(f), threads);
    SamplingScore score;
    score.source = source;
    score.form = describe(material->form);
    score.deviation =
        light.deviation([&](const Vec3d& wo, const Vec3d& wi) { return lobePdf(lobes, wo, wi); });
    score.ggx = bestGgxSampling(light);
    return score;
}

std::string ratioText(double ours, double theirs)
{
    return fmt::format("{:.2f}", theirs * theirs / (ours * ours));
}

size_t countOf(const std::vector<SamplingScore>& scores, bool (SamplingScore::*is)() const)
{
    return static_cast<size_t>(std::count_if(scores.begin(), scores.end(),
                                             [is](const SamplingScore& s) { return (s.*is)(); }));
}

}  // namespace

std::vector<SamplingScore> scoreSampling(const std::vector<std::string>& sources,
                                         const Contender& form, const BenchOptions& options,
                                         Progress& progress)
{
    std::vector<SamplingScore> scores;
    for (const std::string& source : sources) {
        progress.phase("sampling " + source);
        try {
            scores.push_back(sampledScore(source, form, options));
        } catch (const Error& error) {
            // A material that cannot be read or fitted must not lose the results of the others.
            SamplingScore failed;
            failed.source = source;
            failed.error = oneLine(error.what());
            scores.push_back(failed);
        }
    }
    return scores;
}

std::string samplingText(const std::vector<SamplingScore>& scores)
{
    std::vector<std::vector<std::string>> rows{
        {"material", "lobes", "diffuse + GGX", "ratio", "free shares", "ratio", "alpha", "share"}};
    for (const SamplingScore& score : scores) {
        if (!score.error.empty()) {
            rows.push_back({score.source, score.error});
            continue;
        }
        const GgxSampling& ggx = score.ggx.sampling;
        rows.push_back({score.source, fmt::format("{:.3f}", score.deviation),
                        fmt::format("{:.3f}", score.ggx.deviation),
                        ratioText(score.deviation, score.ggx.deviation),
                        fmt::format("{:.3f}", score.ggx.deviationOfFreeShares),
                        ratioText(score.deviation, score.ggx.deviationOfFreeShares),
                        ggx.alphaX == ggx.alphaY
                            ? fmt::format("{:.3g}", ggx.alphaX)
                            : fmt::format("{:.3g} x {:.3g}", ggx.alphaX, ggx.alphaY),
                        fmt::format("{:.2f}", ggx.highlight)});
    }
    return "relative standard deviation of one direction; ratio: variance over that of our "
           "lobes\n" +
           alignedTable({Align::left, Align::right, Align::right, Align::right, Align::right,
                         Align::right, Align::right, Align::right},
                        rows, 2) +
           fmt::format("lower than with a share for each view on {} of {}\nlower on {} of {}\n",
                       countOf(scores, &SamplingScore::isLowerThanFree), scores.size(),
                       countOf(scores, &SamplingScore::isLower), scores.size());
}

Json samplingJson(const std::vector<SamplingScore>& scores)
{
    Json json = {{"materials", Json::array()},
                 {"lower", countOf(scores, &SamplingScore::isLower)},
                 {"lower_than_free_shares", countOf(scores, &SamplingScore::isLowerThanFree)}};
    for (const SamplingScore& score : scores) {
        Json entry = {{"source", score.source}};
        if (score.error.empty()) {
            const GgxSampling& ggx = score.ggx.sampling;
            entry.update({{"form", score.form},
                          {"deviation", score.deviation},
                          {"ggx_deviation", score.ggx.deviation},
                          {"ggx_deviation_free_shares", score.ggx.deviationOfFreeShares},
                          {"ggx",
                           {{"alpha_x", ggx.alphaX},
                            {"alpha_y", ggx.alphaY},
                            {"highlight", ggx.highlight}}}});
        } else {
            entry["error"] = score.error;
        }
        json["materials"].push_back(entry);
    }
    return json;
}

}  // namespace fbrdf::tool
