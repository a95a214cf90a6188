#include "forms/DirectForms.h"

#include "data/Symmetry.h"
#include "forms/NamedForms.h"
#include "Quantize.h"
#include "TexelWeights.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/AnalyticFactors.h>
#include <fbrdf/fit/Svd.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace fbrdf {
namespace {

constexpr char kAnalytic[] = "analytic", kSvd[] = "svd";
constexpr int kUsualTerms = 4;     // terms of svd without a number or a budget
constexpr int kAnalyticSize = 64;  // of q
constexpr int kSmallestSize = 8;   // to which a small budget shrinks q, and few samples u
constexpr size_t kSamplesPerCell = 2;
constexpr size_t kTestPairs = 65536;  // docs/method.md, section Errors: the uniform test set

// The N of "svdN"; 0 for "svd" alone; nothing for other names.
std::optional<int> svdTerms(const std::string& name)
{
    const std::string prefix = kSvd;
    if (name.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
    const std::string digits = name.substr(prefix.size());
    if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    if (digits.empty()) return 0;
    const int terms = digits.size() > 3 ? kMaxSvdTerms + 1 : std::stoi(digits);
    if (terms < 1 || terms > kMaxSvdTerms)
        throw Error(ErrorKind::usage, "form",
                    Found(name).expected("svd1 to svd" + std::to_string(kMaxSvdTerms)));
    return terms;
}

bool fits(const Form& form, const FitOptions& options, Storage storage)
{
    return options.maxBytes == 0 || formBytes(form, storage) <= options.maxBytes;
}

// The knots of u. Scattered samples get as many as they can decide, with kSamplesPerCell for each
// cell of the grid.
int svdSizeFor(const Source& source, const FitContext& context)
{
    if (context.options.resolution > 0) return context.options.resolution;
    if (source.evaluate) return kSvdSize;
    int size = kSvdSize;
    while (size > kSmallestSize &&
           formTexels(formSvdGrid(size)) * kSamplesPerCell > context.dataset.rows)
        size -= size / 4;
    return size;
}

// The form with the number of terms in its name or, without one, as many as fit the budget.
Form svdFormFor(const Source& source, const FitContext& context)
{
    const FitOptions& options = context.options;
    const int size = svdSizeFor(source, context);
    const bool isotropic = isIsotropicSource(source);
    const Form one = formSvd(1, size, isotropic);
    const size_t bytes = formBytes(one, Storage::signedHalf);
    int terms = svdTerms(options.form).value();
    if (terms == 0 && options.maxBytes == 0) terms = kUsualTerms;
    if (terms == 0)
        terms = static_cast<int>(std::min<size_t>(
            options.maxBytes / bytes,
            static_cast<size_t>(std::min({kMaxSvdTerms, texelCount(one.tables[0].domain),
                                          texelCount(one.tables[1].domain)}))));
    const Form form = formSvd(std::max(1, terms), size, isotropic);
    if (!fits(form, options, Storage::signedHalf))
        throw Error(
            ErrorKind::usage, "max-bytes",
            Found(std::to_string(options.maxBytes))
                .expected("at least " + std::to_string(formBytes(form, Storage::signedHalf)) +
                          " for " + form.name));
    return form;
}

// Scattered samples between the knots of the grid: a table fitted to them, smooth where they leave
// holes.
BrdfFunction resamplingOf(const Source& source, const FitContext& context, int excludedFold)
{
    if (!isIsotropicSource(source))
        throw Error(
            ErrorKind::usage, "form",
            Found(std::string(kSvd) + " for scattered samples not known to be isotropic")
                .expected(
                    "a function, such as a model, a table or a material: its grid would have four "
                    "dimensions"));
    const Form form = formSvdGrid(svdSizeFor(source, context));
    const LeastSquares problem(form, context.dataset, context.statistics, context.options.seed,
                               context.options.threads, problemOptions(context));
    SolveOptions options = solveOptions(context);
    options.excludedFold = excludedFold;
    const auto table = std::make_shared<const Material>(
        quantize(form, problem.layout(), solve(problem, options).x, Storage::float32));
    return [table](const Vec3d& wo, const Vec3d& wi) { return evaluate<double>(*table, wo, wi); };
}

Material svdOf(const Source& source, const FitContext& context, const Form& form, int excludedFold)
{
    const BrdfFunction brdf =
        source.evaluate ? source.evaluate : resamplingOf(source, context, excludedFold);
    return svdMaterial(brdf, form, context.options.threads);
}

bool hasFactors(const Source& source)
{
    return source.format == "model" && hasAnalyticFactors(source.name);
}

// Writes the factors with the largest q that fits the budget.
Material analyticOf(const Source& source, const FitOptions& options)
{
    if (!hasFactors(source))
        throw Error(ErrorKind::usage, "form",
                    Found(std::string(kAnalytic) + " for " + source.name)
                        .expected("a model whose structure gives the factors: ward, "
                                  "ashikhmin-shirley, or a preset "
                                  "of them"));
    const int largest = options.resolution > 0 ? options.resolution : kAnalyticSize;
    for (int size = largest;; size -= size / 4) {
        Material material = *analyticFactors(source.name, size, options.storage);
        const size_t bytes = materialBytes(material);
        if (options.maxBytes == 0 || bytes <= options.maxBytes) return material;
        if (size <= kSmallestSize || options.resolution > 0)
            throw Error(ErrorKind::usage, "max-bytes",
                        Found(std::to_string(options.maxBytes))
                            .expected("at least " + std::to_string(bytes) + " for " + kAnalytic));
    }
}

}  // namespace

bool isDirectForm(const std::string& name)
{
    return name == kAnalytic || svdTerms(name).has_value();
}

bool suitsForm(const Source& source, const std::string& form)
{
    if (form == kAnalytic) return hasFactors(source);
    return !svdTerms(form) || source.evaluate || isIsotropicSource(source);
}

void checkDirectOptions(const FitOptions& options)
{
    const bool analytic = options.form == kAnalytic;
    if (options.metric != Metric::log)
        throw Error(ErrorKind::usage, "metric",
                    Found(metricName(options.metric))
                        .expected(analytic ? "none: the factors are written down"
                                           : "none: singular values minimise the absolute error"));
    if (options.sharedShape)
        throw Error(ErrorKind::usage, "shared",
                    Found("it beside form " + options.form).expected("maps of three channels"));
    if (analytic && options.storage == Storage::linear8)
        throw Error(ErrorKind::usage, "storage",
                    Found("linear8 for the form analytic").expected("log8, half or float"));
    const int least = 4, most = 256;
    if (options.resolution != 0 && (options.resolution < least || options.resolution > most))
        throw Error(ErrorKind::usage, "resolution",
                    Found(std::to_string(options.resolution))
                        .expected(std::to_string(least) + " to " + std::to_string(most)));
}

Fitted fitDirectForm(const Source& source, const FitContext& context)
{
    if (context.options.form == kAnalytic)
        return {analyticOf(source, context.options), 0.0, {}, {}, {}, {}};
    Fitted fitted{
        svdOf(source, context, svdFormFor(source, context), kNoFold), 0.0, {}, {}, {}, {}};
    // Which texels the samples look up does not depend on how the texels were found.
    const LeastSquares problem(fitted.material.form, context.dataset, context.statistics,
                               context.options.seed, context.options.threads,
                               problemOptions(context));
    markUnsupported(fitted.material, problem.layout(), texelWeights(problem));
    return fitted;
}

SampleErrors directHeldOutErrors(const Source& source, const FitContext& context,
                                 const Fitted& fitted)
{
    std::vector<Sample> held;
    std::vector<Vec3f> values;
    if (source.evaluate) {
        held = samplesAt(source, uniformPairs(kTestPairs), context.options.threads);
        values = evaluateAt(fitted.material, held, context.options.threads);
    }
    for (int fold = 0; !source.evaluate && fold < context.folds; ++fold) {
        const Material material = svdOf(source, context, fitted.material.form, fold);
        const auto part = probeOf(context, FoldChoice::onlyOf(fold));
        const auto found = evaluateAt(material, part, context.options.threads);
        held.insert(held.end(), part.begin(), part.end());
        values.insert(values.end(), found.begin(), found.end());
    }
    return sampleErrors(held, values, context.statistics.floor);
}

}  // namespace fbrdf
