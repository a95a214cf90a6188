#include "bench/BenchFit.h"

#include "Arguments.h"
#include "Reflectance.h"
#include "SampleFacts.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/NoiseFloor.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/OpenSource.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <random>

namespace fbrdf::tool {
namespace {

constexpr int kSphere = 256;  // of the standard sphere
constexpr size_t kFolds = 5;

std::vector<std::string> split(const std::string& list)
{
    std::vector<std::string> words;
    for (size_t from = 0; from <= list.size();) {
        const size_t to = std::min(list.find(',', from), list.size());
        if (to > from) words.push_back(list.substr(from, to - from));
        from = to + 1;
    }
    return words;
}

Contender formFrom(const std::string& word)
{
    Contender form{word, true, word.substr(0, word.find(':')), 0};
    if (form.name.size() < word.size())
        form.maxBytes = static_cast<size_t>(integerFromText("--forms " + form.name,
                                                            word.substr(form.name.size() + 1), 1,
                                                            std::numeric_limits<uint64_t>::max()));
    FitOptions options;
    options.form = form.name;
    checkOptions(options);
    return form;
}

std::optional<PeerFit> fitForm(const Contender& contender, const Source& source,
                               const BenchOptions& options)
{
    if (!suitsForm(source, contender.name)) return std::nullopt;
    FitOptions fit = options.fit;
    fit.form = contender.name;
    fit.maxBytes = contender.maxBytes;
    fit.heldOut = false;
    const FitResult result = fitMaterial(source, fit);
    const auto material = std::make_shared<const Material>(result.material);
    return PeerFit{shaderFunction(material), materialBytes(*material),
                   lookupsPerLight(material->form), result.summary.seconds,
                   describe(material->form)};
}

/// What all contenders are judged by on one source.
struct Judge {
    Source source;
    std::vector<Sample> samples;           ///< fresh, or the source's own
    std::vector<size_t> fold;              ///< one a sample; empty for a function
    std::optional<SphereImage> reference;  ///< of a function
    Vec3f floor{0.0f};
};

// Tables that compute their rows when asked are read once, not once for each contender.
constexpr uint64_t kHeldRows = 3'000'000;

void holdSamples(Source& source)
{
    if (!source.stream || source.stream.rows > kHeldRows) return;
    source.stream([&](const Sample* samples, size_t count) {
        source.samples.insert(source.samples.end(), samples, samples + count);
    });
    source.stream = {};
}

// Every fold gets a fifth of the samples, whatever their order in the file.
std::vector<size_t> foldsOf(size_t samples, uint64_t seed)
{
    std::vector<size_t> fold(samples);
    for (size_t i = 0; i < samples; ++i) fold[i] = i % kFolds;
    std::shuffle(fold.begin(), fold.end(), std::mt19937_64(seed));
    return fold;
}

Judge judgeOf(const std::string& spec, const BenchOptions& options)
{
    Judge judge;
    judge.source = openSource(spec, options.source);
    const int threads = options.fit.threads;
    holdSamples(judge.source);
    if (judge.source.evaluate) {
        judge.samples = samplesAt(judge.source, uniformPairs(kUniformTestPairs), threads);
        judge.reference = renderStandardSphere(judge.source.evaluate, kSphere, threads);
        return judge;
    }
    uint64_t available = 0;
    judge.samples = thinnedSamples(judge.source, available);
    if (judge.samples.size() < kFolds)
        throw Error(ErrorKind::fit, spec,
                    fmt::format(Found("{} usable samples").expected("at least {}"),
                                judge.samples.size(), kFolds));
    judge.fold = foldsOf(judge.samples.size(), options.fit.seed);
    judge.floor = estimateNoiseFloor(judge.samples);
    return judge;
}

Source trainingSource(const Judge& judge, size_t fold)
{
    Source source = judge.source;
    source.stream = {};
    source.samples.clear();
    for (size_t i = 0; i < judge.samples.size(); ++i)
        if (judge.fold[i] != fold) source.samples.push_back(judge.samples[i]);
    return source;
}

Score scoreOf(const Contender& contender, const PeerFit& fit)
{
    return {contender, fit.bytes, fit.lookups, fit.seconds, {}, fit.note};
}

std::optional<Score> scoreFunction(const Contender& contender, const Judge& judge,
                                   const BenchOptions& options)
{
    const auto fit = fitContender(contender, judge.source, options);
    if (!fit) return std::nullopt;
    const int threads = options.fit.threads;
    Score score = scoreOf(contender, *fit);
    score.errors = errorMap(
        sampleErrors(judge.samples, evaluateAt(fit->brdf, judge.samples, threads), judge.floor));
    score.errors.merge(
        errorMap(imageErrors(renderStandardSphere(fit->brdf, kSphere, threads), *judge.reference)));
    return score;
}

std::optional<Score> scoreFolds(const Contender& contender, const Judge& judge,
                                const BenchOptions& options)
{
    std::optional<Score> score;
    std::vector<Sample> held;
    std::vector<Vec3f> fitted;
    double seconds = 0.0;
    for (size_t fold = 0; fold < kFolds; ++fold) {
        const auto fit = fitContender(contender, trainingSource(judge, fold), options);
        if (!fit) return std::nullopt;
        std::vector<Sample> part;
        for (size_t i = 0; i < judge.samples.size(); ++i)
            if (judge.fold[i] == fold) part.push_back(judge.samples[i]);
        const auto values = evaluateAt(fit->brdf, part, options.fit.threads);
        held.insert(held.end(), part.begin(), part.end());
        fitted.insert(fitted.end(), values.begin(), values.end());
        seconds += fit->seconds / kFolds;
        score = scoreOf(contender, *fit);
    }
    score->seconds = seconds;
    score->errors = errorMap(sampleErrors(held, fitted, judge.floor));
    return score;
}

std::vector<std::string> peerNames(const std::string& list)
{
    if (list == "none") return {};
    if (list != "all") return split(list);
    std::vector<std::string> names;
    for (const Peer& peer : peers()) names.push_back(peer.name);
    return names;
}

}  // namespace

std::vector<Contender> contendersFrom(const std::string& forms, const std::string& peerList)
{
    std::vector<Contender> contenders;
    for (const std::string& word : split(forms)) contenders.push_back(formFrom(word));
    for (const std::string& word : peerNames(peerList))
        contenders.push_back({word, false, findPeer(word).name, 0});
    if (contenders.empty())
        throw Error(ErrorKind::usage, "--forms",
                    Found("nothing to fit").expected("a form or a peer"));
    return contenders;
}

std::optional<PeerFit> fitContender(const Contender& contender, const Source& source,
                                    const BenchOptions& options)
{
    return contender.ours ? fitForm(contender, source, options)
                          : findPeer(contender.name).fit(source, options.peers);
}

MaterialScores scoreMaterial(const std::string& source, const BenchOptions& options,
                             Progress& progress)
{
    progress.phase("reading " + source);
    const Judge judge = judgeOf(source, options);
    MaterialScores result{source, judge.source.name, {}, {}};
    for (const Contender& contender : options.contenders) {
        progress.phase("fitting " + contender.label + " to " + judge.source.name);
        const auto score = judge.reference ? scoreFunction(contender, judge, options)
                                           : scoreFolds(contender, judge, options);
        if (score) result.scores.push_back(*score);
    }
    return result;
}

}  // namespace fbrdf::tool
