#include <fbrdf/peers/Peer.h>
#include <fbrdf/sources/OpenSource.h>

#include <fbrdf/peers/LinearMaps.h>
#include <fbrdf/peers/PublishedFits.h>
#ifdef FBRDF_HAVE_CERES
#include <fbrdf/peers/GgxFit.h>
#endif

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/Clock.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace fbrdf {
namespace {

constexpr size_t kFloatBytes = 4;

std::string pathIn(const PeerContext& context, const char* relative)
{
    return (std::filesystem::path(context.dataDir) / relative).string();
}

BrdfFunction shaderFunction(std::shared_ptr<const Material> material)
{
    return [material = std::move(material)](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(evaluate<float>(*material, Vec3f(wo), Vec3f(wi)));
    };
}

/// All but its seconds.
PeerFit fitOf(Material material)
{
    PeerFit fit;
    fit.material = std::make_shared<const Material>(std::move(material));
    fit.brdf = shaderFunction(fit.material);
    fit.bytes = materialBytes(*fit.material);
    fit.lookups = lookupsPerLight(fit.material->form);
    fit.note = describe(fit.material->form);
    return fit;
}

// What peers that have a choice choose by: a small standard sphere where there is a function, else
// the cube roots at samples. Smaller is better.
class Choice {
public:
    Choice(const Source& source, const PeerContext& context) : threads_(context.threads)
    {
        constexpr int kSize = 48;
        constexpr size_t kSamples = 4096;
        if (source.evaluate)
            reference_ = renderStandardSphere(source.evaluate, kSize, threads_);
        else
            samples_ = peerSamples(source, kSamples, context);
    }

    double error(const BrdfFunction& brdf) const
    {
        if (reference_)
            return -imageErrors(renderStandardSphere(brdf, reference_->size, threads_), *reference_)
                        .psnrLinear;
        return sampleErrors(samples_, evaluateAt(brdf, samples_, threads_), Vec3f(0.0f))
            .cubeRootRms;
    }

private:
    int threads_;
    std::optional<SphereImage> reference_;
    std::vector<Sample> samples_;
};

#ifdef FBRDF_HAVE_CERES
BrdfFunction functionOf(const GgxModel& model)
{
    return [model](const Vec3d& wo, const Vec3d& wi) { return evaluate(model, wo, wi); };
}

// Dielectrics want the cube root, metals the log: both are tried, the better is kept.
GgxModel bestGgx(const Source& source, const PeerContext& context, GgxFitOptions options)
{
    constexpr size_t kSamples = 8192;
    const std::vector<Sample> samples = peerSamples(source, kSamples, context);
    const GgxModel cube = fitGgx(samples, options);
    options.metric = GgxMetric::log1p;
    const GgxModel log = fitGgx(samples, options);
    const Choice choice(source, context);
    return choice.error(functionOf(log)) < choice.error(functionOf(cube)) ? log : cube;
}

std::optional<PeerFit> fitGgxLobes(const Source& source, const PeerContext& context, int lobes)
{
    const Clock clock;
    GgxFitOptions options;
    options.lobes = lobes;
    options.isotropic = source.isotropic;
    options.threads = context.threads;
    options.watch = context.watch;
    context.watch.say("fitting " + std::string(lobes == 1 ? "a GGX lobe" : "two GGX lobes"));
    const GgxModel model = bestGgx(source, context, options);
    PeerFit fit;
    fit.seconds = clock.seconds();
    fit.brdf = functionOf(model);
    const size_t perLobe = options.isotropic ? 5 : 6;  // scale r g b, f0, alpha or two of it
    fit.bytes = kFloatBytes * (3 + perLobe * model.lobes.size());
    fit.note = describe(model);
    return fit;
}

std::optional<PeerFit> fitGgxOne(const Source& source, const PeerContext& context)
{
    return fitGgxLobes(source, context, 1);
}

std::optional<PeerFit> fitGgxTwo(const Source& source, const PeerContext& context)
{
    return fitGgxLobes(source, context, 2);
}
#endif

std::optional<PeerFit> published(const std::string& table, const std::string& material,
                                 const std::string& model,
                                 const std::vector<std::pair<std::string, std::string>>& parameters)
{
    const ParameterRow row = publishedRow(table, material);
    if (row.empty()) return std::nullopt;
    PeerFit fit;
    fit.note = specFromRow(model, row, parameters);
    fit.brdf = makeModelSource(fit.note).evaluate;
    fit.bytes = kFloatBytes * row.size();
    return fit;
}

std::optional<PeerFit> publishedSgd(const Source& source, const PeerContext& context)
{
    return published(pathIn(context, "merl_fits/csv/bagher_sgd.csv"), source.name, "sgd",
                     {{"kd", "kd"},
                      {"ks", "albedo"},
                      {"alpha", "alpha"},
                      {"p", "p"},
                      {"f0", "eta0"},
                      {"f1", "eta1"},
                      {"K", "K"},
                      {"Lambda", "Lambda"},
                      {"c", "c"},
                      {"k", "k"},
                      {"theta0", "theta0"}});
}

std::optional<PeerFit> publishedAbc(const Source& source, const PeerContext& context)
{
    return published(pathIn(context, "merl_fits/csv/low_lowmicrofacet_E2.csv"), source.name, "abc",
                     {{"kd", "kd"}, {"A", "A"}, {"B", "B"}, {"C", "C"}, {"eta", "eta"}});
}

std::optional<PeerFit> publishedNpf(const Source& source, const PeerContext& context)
{
    // rhoD, rhoS and three tables of 90 bins: half, difference, and one angle of the light.
    constexpr size_t kColumns = 272;
    const std::string path = pathIn(context, "npf_merl/npf.bin");
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::vector<std::string> there = materialsOf(path);
    const std::string spec = path + "#" + source.name;
    if (std::find(there.begin(), there.end(), spec) == there.end()) return std::nullopt;
    PeerFit fit;
    fit.brdf = openSource(spec).evaluate;
    fit.bytes = kFloatBytes * 3 * kColumns;
    fit.lookups = 3;
    fit.note = "tables as published";
    return fit;
}

// A form of the fitter that others thought of first.
std::optional<PeerFit> madeForm(const Source& source, const PeerContext& context,
                                const std::string& form)
{
    if (!suitsForm(source, form)) return std::nullopt;
    FitOptions options;
    options.form = form;
    options.heldOut = false;
    options.threads = context.threads;
    options.watch = context.watch;
    FitResult result = fitMaterial(source, options);
    PeerFit fit = fitOf(std::move(result.material));
    fit.seconds = result.summary.seconds;
    return fit;
}

std::optional<PeerFit> resampledSvd(const Source& source, const PeerContext& context)
{
    return madeForm(source, context, "svd4");
}

std::optional<PeerFit> mapsOf2001(const Source& source, const PeerContext& context)
{
    constexpr size_t kSamples = 65536;  // more than ten a texel of the horizon's discs
    constexpr double kSmoothness = 1e-4;
    const Clock clock;
    FitOptions options;
    options.form = "pqp-2001";
    options.storage = Storage::float32;
    options.robust = false;
    options.smoothness = kSmoothness;
    options.heldOut = false;
    options.threads = context.threads;
    options.watch = context.watch;
    Source samples = source;
    samples.samples = peerSamples(source, kSamples, context);
    samples.stream = {};
    samples.evaluate = {};
    const Choice choice(source, context);
    PeerFit fit = fitOf(linearMaps(fitMaterial(samples, options).material, [&](const Material& m) {
        context.watch.say("scaling the maps of 2001");
        return choice.error(shaderFunction(std::make_shared<const Material>(m)));
    }));
    fit.seconds = clock.seconds();
    return fit;
}

std::optional<PeerFit> writtenDown(const Source& source, const PeerContext& context)
{
    return madeForm(source, context, "analytic");
}

const char* const kAny = "samples or a function";
const char* const kPublished =
    "a material of MERL by its name, and its parameters in FBRDF_DATA_DIR";

}  // namespace

std::string publishedDataDir()
{
    const char* folder = std::getenv("FBRDF_DATA_DIR");
    return folder && *folder ? folder : "../shared/data";
}

const std::vector<Peer>& peers()
{
    static const std::vector<Peer> all{
#ifdef FBRDF_HAVE_CERES
        {"ggx", "GGX + Lambert",
         "Walter et al. 2007; fitted here by least squares (Ceres) from several starts", kAny,
         fitGgxOne},
        {"ggx2", "two GGX lobes + Lambert", "the same with a second lobe", kAny, fitGgxTwo},
#endif
        {"sgd", "shifted gamma distribution", "Bagher et al. 2012; parameters as published",
         kPublished, publishedSgd},
        {"abc", "ABC microfacets", "Low et al. 2012; parameters as published", kPublished,
         publishedAbc},
        {"npf", "non-parametric factors", "Bagher et al. 2016; tables as published", kPublished,
         publishedNpf},
        {"svd", "singular values, 4 terms",
         "Kautz and McCool 1999: resampled on a regular grid, signed terms u(h) v(d)",
         "a function, or isotropic samples", resampledSvd},
        {"pqp-2001", "maps of 2001",
         "McCool, Ang, Ahmad 2001: p(wo) q(h) p(wi) in linear 8-bit maps", kAny, mapsOf2001},
        {"analytic", "factors written down",
         "after McCool 2002: Ward's and Ashikhmin and Shirley's models, no fit",
         "one of these models", writtenDown},
    };
    return all;
}

std::string peersLeftOut()
{
#ifdef FBRDF_HAVE_CERES
    return "";
#else
    return "ggx and ggx2, which need Ceres";
#endif
}

const Peer& findPeer(const std::string& name)
{
    std::string known;
    for (const Peer& peer : peers()) {
        if (peer.name == name) return peer;
        known += (known.empty() ? "" : ", ") + peer.name;
    }
    throw Error(ErrorKind::usage, "peers",
                Found("'" + name + "'")
                    .expected("some of " + known +
                              (peersLeftOut().empty() ? "" : "; without " + peersLeftOut())));
}

std::vector<Sample> peerSamples(const Source& source, size_t count, const PeerContext& context)
{
    if (source.evaluate)
        return samplesAt(source, uniformPairs(count, context.seed + 1), context.threads);
    std::vector<Sample> samples;
    forEachBlock(source, [&](const Sample* block, size_t size) {
        samples.insert(samples.end(), block, block + size);
    });
    const size_t stride = std::max<size_t>(1, samples.size() / count);
    std::vector<Sample> thinned;
    for (size_t i = 0; i < samples.size(); i += stride) thinned.push_back(samples[i]);
    return thinned;
}

}  // namespace fbrdf
