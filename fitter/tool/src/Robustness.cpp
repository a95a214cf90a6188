#include "Robustness.h"

#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/Disturb.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/OpenSource.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fbrdf::tool {
namespace {

constexpr size_t kFunctionSamples = 131072;
constexpr int kSphere = 256;
constexpr size_t kFewSamples = 1458;  // a tenth of the MERL grid along every axis

using Samples = std::vector<Sample>;

Samples noisy(const Samples& samples, uint64_t seed)
{
    return withNoise(samples, {}, seed);
}

Samples tenth(const Samples& samples, uint64_t seed)
{
    return randomPart(samples, samples.size() / 10, seed);
}

Samples few(const Samples& samples, uint64_t seed)
{
    return randomPart(samples, kFewSamples, seed);
}

// The source as it would be if only these samples were known.
Source measured(const Source& source, Samples samples)
{
    Source result;
    result.name = source.name;
    result.format = source.format;
    result.isotropic = source.isotropic;
    result.samples = std::move(samples);
    return result;
}

Samples samplesOf(const Source& source, int threads)
{
    if (!hasSamples(source)) return samplesAt(source, uniformPairs(kFunctionSamples, 1), threads);
    Samples samples;
    forEachBlock(source, [&](const Sample* block, size_t count) {
        samples.insert(samples.end(), block, block + count);
    });
    return samples;
}

double psnr(const Contender& form, const Source& source, const SphereImage& truth,
            const BenchOptions& options)
{
    const auto fit = fitContender(form, source, options);
    if (!fit)
        throw Error(ErrorKind::usage, "--forms",
                    Found(form.label).expected("forms that measurements are fitted with"));
    return imageErrors(renderStandardSphere(fit->brdf, kSphere, options.fit.threads), truth)
        .psnrLinear;
}

// The scores of every form, in the order in which forms first appear.
std::vector<std::pair<std::string, std::vector<const RobustScore*>>> byForm(
    const std::vector<RobustScore>& scores)
{
    std::vector<std::pair<std::string, std::vector<const RobustScore*>>> forms;
    for (const RobustScore& score : scores) {
        auto found = std::find_if(forms.begin(), forms.end(),
                                  [&](const auto& form) { return form.first == score.form; });
        if (found == forms.end()) found = forms.insert(forms.end(), {score.form, {}});
        found->second.push_back(&score);
    }
    return forms;
}

double meanLoss(const std::vector<const RobustScore*>& scores, size_t trouble)
{
    double sum = 0.0;
    for (const RobustScore* score : scores) sum += score->lost[trouble];
    return sum / static_cast<double>(scores.size());
}

std::vector<std::string> rowOf(const RobustScore& score)
{
    std::vector<std::string> row{score.material, score.form, fmt::format("{:.2f}", score.clean)};
    for (const double lost : score.lost) row.push_back(fmt::format("{:.2f}", lost));
    return row;
}

}  // namespace

const std::vector<Trouble>& troubles()
{
    static const std::vector<Trouble> all{
        {"noise", 4.0, noisy}, {"a tenth", 1.0, tenth}, {"1,458 samples", 3.0, few}};
    return all;
}

std::vector<RobustScore> robustness(const std::string& spec, const BenchOptions& options,
                                    Progress& progress)
{
    progress.phase("reading " + spec);
    const Source source = openSource(spec, options.source);
    if (!source.evaluate)
        throw Error(ErrorKind::input, spec,
                    Found("samples alone").expected("a function whose picture is known"));
    const SphereImage truth = renderStandardSphere(source.evaluate, kSphere, options.fit.threads);
    const Samples samples = samplesOf(source, options.fit.threads);
    std::vector<RobustScore> scores;
    for (const Contender& form : options.contenders) {
        progress.phase("fitting " + form.label + " to " + source.name);
        RobustScore score{source.name, form.label, 0.0, {}};
        score.clean = psnr(form, measured(source, samples), truth, options);
        for (const Trouble& trouble : troubles())
            score.lost.push_back(
                score.clean - psnr(form, measured(source, trouble.apply(samples, options.fit.seed)),
                                   truth, options));
        scores.push_back(std::move(score));
    }
    return scores;
}

bool allHold(const std::vector<RobustScore>& scores)
{
    for (const auto& [form, of] : byForm(scores))
        for (size_t t = 0; t < troubles().size(); ++t)
            if (meanLoss(of, t) > troubles()[t].mayLose) return false;
    return true;
}

std::string robustnessText(const std::vector<RobustScore>& scores)
{
    std::vector<std::vector<std::string>> rows{{"material", "form", "clean"}};
    for (const Trouble& t : troubles()) rows[0].push_back("lost: " + t.name);
    for (const RobustScore& score : scores) rows.push_back(rowOf(score));
    for (const auto& [form, of] : byForm(scores)) {
        rows.push_back({"mean", form, ""});
        for (size_t t = 0; t < troubles().size(); ++t)
            rows.back().push_back(
                fmt::format("{:.2f} ({:.0f})", meanLoss(of, t), troubles()[t].mayLose));
    }
    std::vector<Align> align(rows[0].size(), Align::right);
    align[0] = align[1] = Align::left;
    return "PSNR of the standard sphere in dB, and what worse data cost (in brackets: may cost)\n" +
           alignedTable(align, rows);
}

Json robustnessJson(const std::vector<RobustScore>& scores)
{
    Json each = Json::array(), means = Json::array();
    for (const RobustScore& score : scores) {
        Json lost = Json::object();
        for (size_t t = 0; t < troubles().size(); ++t)
            lost[troubles()[t].name] = jsonOf(score.lost[t]);
        each.push_back({{"material", score.material},
                        {"form", score.form},
                        {"clean", jsonOf(score.clean)},
                        {"lost", lost}});
    }
    for (const auto& [form, of] : byForm(scores)) {
        Json lost = Json::object();
        for (size_t t = 0; t < troubles().size(); ++t)
            lost[troubles()[t].name] = {{"mean", jsonOf(meanLoss(of, t))},
                                        {"may_lose", troubles()[t].mayLose}};
        means.push_back({{"form", form}, {"lost", lost}});
    }
    return {{"means", means}, {"materials", each}, {"holds", allHold(scores)}};
}

}  // namespace fbrdf::tool
