#include "solve/LeastSquaresRows.h"

#include <fbrdf/fit/FormKey.h>

#include <array>
#include <limits>

namespace fbrdf {
namespace {

constexpr float kMadToSigma = 1.4826f;
constexpr float kSmallestScale =
    0.12f;                           // log2: smaller residuals are the form's misfit, not outliers
constexpr size_t kScaleBlocks = 24;  // blocks that the scale of the residuals is taken from
constexpr float kLn2 = 0.69314718056f;

std::string keyOf(const Feed& feed, const Form& form, const LeastSquaresOptions& options,
                  int threads)
{
    if (!options.cache || options.sharedShape) return {};
    const std::string geometry = geometryOf(feed, threads);
    return geometry.empty() ? geometry : geometry + "|" + formKey(form);
}

std::shared_ptr<const RowGeometries> knownRows(const std::string& key,
                                               const LeastSquaresOptions& options)
{
    return key.empty() ? nullptr : options.cache->rows(key);
}

}  // namespace

Response responseInMetric(Metric metric, float c, float logF, float logG)
{
    const float f = c * std::exp2(logF), g = c * std::exp2(logG);
    const bool cube = metric == Metric::cubeRoot;
    const float phiF = cube ? std::cbrt(f) : std::log1p(f);
    const float phiG = cube ? std::cbrt(g) : std::log1p(g);
    const float slope = std::max(cube ? phiG * kLn2 / 3.0f : kLn2 * g / (1.0f + g), 1e-12f);
    return {(phiF - phiG) / slope, slope * slope};
}

LeastSquares::Texels::Texels(const LeastSquares& problem, const State& x)
    : values(problem.unknowns() * kLanes), levels(problem.form_.terms.size() * kLanes)
{
    const size_t n = problem.unknowns();
    const Layout& layout = problem.layout_;
    if (takeFlat(problem, x)) return;
    const size_t columnStep = layout.sharedShape() ? 0 : n;
    for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < 3; ++c)
            values[i * kLanes + c] = static_cast<float>(x[c * columnStep + i]);
    for (size_t t = 0; layout.sharedShape() && t < problem.form_.terms.size(); ++t)
        for (int c = 0; c < 3; ++c)
            levels[t * kLanes + static_cast<size_t>(c)] =
                static_cast<float>(x[static_cast<size_t>(layout.levelOf(t, c))]);
}

// Texels that are all equal say the same everywhere: weights of a factor sum to 1.
bool LeastSquares::Texels::takeFlat(const LeastSquares& problem, const State& x)
{
    const size_t n = problem.unknowns();
    if (problem.layout_.sharedShape() || problem.form_.terms.size() > 1) return false;
    for (size_t i = 0; i < x.size(); ++i)
        if (x[i] != x[i / n * n]) return false;
    values.clear();
    const auto factors = static_cast<float>(problem.form_.terms[0].factors.size());
    for (size_t c = 0; c < 3; ++c) levels[c] = factors * static_cast<float>(x[c * n]);
    return true;
}

void LeastSquares::predict(const RowGeometry& rows, size_t first, size_t count,
                           const Texels& texels, Predicted& predicted) const
{
    const auto width = static_cast<size_t>(maker_.width());
    const size_t terms = form_.terms.size();
    predicted.logG.resize(count * kLanes);
    predicted.share.resize(terms > 1 ? count * terms * kLanes : 0);
    if (texels.values.empty()) {
        for (size_t k = 0; k < predicted.logG.size(); ++k)
            predicted.logG[k] = texels.levels[k % kLanes];
        return;
    }
    KernelRows kernelRows{};
    kernelRows.count = static_cast<std::ptrdiff_t>(count);
    kernelRows.width = maker_.width();
    kernelRows.unknown = rows.unknown.data() + first * width;
    kernelRows.weight = rows.weight.data() + first * width;
    kernelRows.termEnd = maker_.termEnd().data();
    kernelRows.terms = static_cast<std::ptrdiff_t>(terms);
    rowKernels().predict(kernelRows, {texels.values.data(), texels.levels.data()},
                         predicted.logG.data(), predicted.share.data());
}

LeastSquares::LeastSquares(Form form, Feed feed, const DataTraits& traits, uint64_t seed,
                           int threads, const LeastSquaresOptions& options)
    : form_(std::move(form)),
      feed_(std::move(feed)),
      traits_(traits),
      options_(options),
      layout_(form_, options.sharedShape),
      maker_(form_, layout_),
      smoothness_(form_, layout_),
      seed_(seed),
      threads_(threads),
      cacheKey_(keyOf(feed_, form_, options, threads)),
      store_(std::make_unique<RowStore>(maker_, feed_, traits_, threads,
                                        knownRows(cacheKey_, options)))
{
    if (!cacheKey_.empty() && store_->geometry())
        options.cache->keepRows(cacheKey_, store_->geometry());
}

bool LeastSquares::dependsOnState(const StepOptions& options) const
{
    return !store_->sameWeights() || options.robust || form_.terms.size() > 1 ||
           options.metric != Metric::log;
}

LeastSquares LeastSquares::thinned(size_t rows, int excludedFold) const
{
    Feed thin =
        heldFeed(someSamples(feed_, FoldChoice::allBut(excludedFold), rows, seed_, threads_));
    thin.exact = feed_.exact;
    LeastSquaresOptions options = options_;
    options.ranks = {};  // small enough for each process to solve it by itself
    return LeastSquares(form_, std::move(thin), traits_, seed_, threads_, options);
}

bool LeastSquares::hasWholeNoise() const
{
    constexpr size_t kManyRows = 20000;
    return traits_.unclipped && feed_.rows >= kManyRows;
}

LeastSquares LeastSquares::withForm(const Form& form) const
{
    LeastSquaresOptions options = options_;
    options.solver = SystemSolver::automatic;
    return LeastSquares(form, feed_, traits_, seed_, threads_, options);
}

State LeastSquares::flatState() const
{
    const size_t n = unknowns();
    State x(columns() * n, 0.0);
    std::vector<size_t> lastTerm(form_.tables.size(), 0);
    for (size_t t = 0; t < form_.terms.size(); ++t)
        for (const Factor& factor : form_.terms[t].factors)
            lastTerm[static_cast<size_t>(factor.table)] = t;
    const auto levelOf = [this](size_t term) {
        return term + 1 == form_.terms.size() ? traits_.level : traits_.low;
    };
    if (layout_.sharedShape()) {
        for (size_t t = 0; t < form_.terms.size(); ++t)
            for (int c = 0; c < 3; ++c)
                x[static_cast<size_t>(layout_.levelOf(t, c))] = static_cast<double>(levelOf(t)[c]);
        return x;
    }
    for (size_t table = 0; table < form_.tables.size(); ++table) {
        const size_t t = lastTerm[table];
        const Vec3f level = levelOf(t) / static_cast<float>(form_.terms[t].factors.size());
        for (int i = 0; i < texelCount(form_.tables[table].domain); ++i)
            for (size_t c = 0; c < 3; ++c)
                x[c * n + static_cast<size_t>(layout_.unknownOf(table, i))] =
                    static_cast<double>(level[static_cast<int>(c)]);
    }
    return x;
}

// Scale s of the residuals from the median of their magnitudes, in units of the expected noise.
Vec3f LeastSquares::tukeyScale(const State& x, const StepOptions& options) const
{
    StepOptions plain = options;
    plain.robust = false;
    const Texels texels(*this, x);
    const size_t stride = std::max<size_t>(1, store_->blocks() / kScaleBlocks);
    const size_t count = (store_->blocks() + stride - 1) / stride;
    std::vector<std::array<std::vector<float>, 3>> magnitudes(count);
    parallelTasks(count, threads_, [&](size_t b) {
        RowStore::Scratch scratch;
        forEachRow(b * stride, scratch, texels, plain, Vec3f(1.0f), [&](const Row& row, int) {
            for (int c = 0; c < 3; ++c)
                if (row.sampleWeight[c] > 0.0f)
                    magnitudes[b][static_cast<size_t>(c)].push_back(std::abs(row.residual[c]) *
                                                                    std::sqrt(row.noiseWeight[c]));
        });
    });
    Vec3f scale;
    for (size_t c = 0; c < 3; ++c) {
        std::vector<float> all;
        for (const auto& part : magnitudes) all.insert(all.end(), part[c].begin(), part[c].end());
        scale[static_cast<int>(c)] = std::max(quantile(all, 0.5) * kMadToSigma, kSmallestScale);
    }
    return scale;
}

double LeastSquares::cost(const State& x, const StepOptions& options, const State& scaleAt) const
{
    StepOptions plain = options;
    plain.robust = false;
    const Vec3f scale = options.robust ? tukeyScale(scaleAt, options) : Vec3f(1.0f);
    const Texels texels(*this, x);
    std::vector<double> sums(2 * kParts, 0.0);
    forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        forEachRow(block, scratch, texels, plain, Vec3f(1.0f), [&](const Row& row, int) {
            for (int c = 0; c < 3; ++c) {
                const float r = row.residual[c];
                const float bounded =
                    options.robust ? biweightLoss(r * std::sqrt(row.noiseWeight[c]), scale[c])
                                   : 1.0f;
                sums[2 * part] += static_cast<double>(row.sampleWeight[c] * bounded) *
                                  static_cast<double>(r) * static_cast<double>(r);
                sums[2 * part + 1] += static_cast<double>(row.noiseWeight[c]);
            }
        });
    });
    options_.ranks.sum(sums);
    double sum = 0.0, weight = 0.0;
    for (size_t part = 0; part < kParts; ++part) {
        sum += sums[2 * part];
        weight += sums[2 * part + 1];
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

std::vector<double> LeastSquares::support() const
{
    constexpr size_t kStreamRows = 262144;
    if (!feed_.held) return thinned(kStreamRows, kNoFold).support();
    // Where every value counts, the pairs of directions tell.
    if (cacheKey_.empty() || !store_->sameWeights()) return countedSupport();
    auto known = options_.cache->support(cacheKey_);
    if (!known) {
        known = std::make_shared<const std::vector<double>>(countedSupport());
        options_.cache->keepSupport(cacheKey_, known);
    }
    return *known;
}

std::vector<double> LeastSquares::countedSupport() const
{
    const auto width = static_cast<size_t>(maker_.width());
    std::vector<std::vector<double>> parts(kParts, std::vector<double>(unknowns(), 0.0));
    forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        const RowStore::Block rows = store_->block(block, scratch);
        for (size_t i = 0; i < rows.geometry.count; ++i) {
            bool usable = false;
            for (int c = 0; c < 3; ++c)
                usable = usable || (rows.values.weight[i][c] > 0.0f &&
                                    (rows.values.censored[i] >> c & 1) == 0);
            for (size_t k = i * width; usable && k < (i + 1) * width; ++k)
                parts[part][static_cast<size_t>(rows.geometry.unknown[k])] +=
                    static_cast<double>(rows.geometry.weight[k]);
        }
    });
    std::vector<double> sum(unknowns(), 0.0);
    for (const auto& part : parts)
        for (size_t u = 0; u < sum.size(); ++u) sum[u] += part[u];
    options_.ranks.sum(sum);
    return sum;
}

// Calls visit(part, rows, i, fold's place in `folds`) for the samples of the folds. Of many samples
// some are visited: rows where they are kept, else whole blocks.
template <class Visit>
void LeastSquares::forEachLeftOut(const std::vector<int>& folds, const Visit& visit) const
{
    constexpr size_t kRows = 262144;
    // Hashes up to these are visited.
    const uint64_t all = std::numeric_limits<uint64_t>::max(),
                   some = all / std::max<uint64_t>(1, feed_.rows / kRows);
    const uint64_t lastRow = store_->geometry() ? some : all,
                   lastBlock = store_->geometry() ? all : some;
    forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        if (splitMix64(block ^ seed_) > lastBlock) return;
        const RowStore::Block rows = store_->block(block, scratch);
        for (size_t i = 0; i < rows.geometry.count; ++i) {
            const uint64_t number = rows.geometry.number(i);
            if (splitMix64(number ^ ~seed_) > lastRow) continue;
            const auto found = std::find(folds.begin(), folds.end(), foldOf(number, seed_));
            if (found == folds.end()) continue;
            visit(part, rows, i, static_cast<size_t>(found - folds.begin()));
        }
    });
}

// For every strength, the sum over folds of the weighted mean |log2 f - log2 g| of the samples left
// out.
std::vector<double> LeastSquares::foldErrors(const std::vector<States>& states,
                                             const std::vector<int>& folds) const
{
    std::vector<Texels> texels;  // of every fold and strength
    for (const States& fold : states)
        for (const State& state : fold) texels.emplace_back(*this, state);
    const size_t strengths = states[0].size(), numbers = 2 * texels.size();
    std::vector<double> sums(kParts * numbers, 0.0);
    std::vector<Predicted> predicted(kParts);
    forEachLeftOut(folds, [&](size_t part, const RowStore::Block& rows, size_t i, size_t fold) {
        for (size_t k = fold * strengths; k < (fold + 1) * strengths; ++k) {
            predict(rows.geometry, i, 1, texels[k], predicted[part]);
            const Row row = rowAt(rows, i, predicted[part].logG.data(), {}, Vec3f(1.0f));
            double* sum = &sums[part * numbers + 2 * k];
            for (int c = 0; c < 3; ++c) {
                const auto weight = static_cast<double>(row.sampleWeight[c]);
                sum[0] += weight * std::abs(static_cast<double>(row.residual[c]));
                sum[1] += weight;
            }
        }
    });
    options_.ranks.sum(sums);
    std::vector<double> errors(strengths, 0.0);
    for (size_t k = 0; k < texels.size(); ++k) {
        double sum = 0.0, weight = 0.0;
        for (size_t part = 0; part < kParts; ++part) {
            sum += sums[part * numbers + 2 * k];
            weight += sums[part * numbers + 2 * k + 1];
        }
        const double error = weight > 0.0 ? sum / weight : 0.0;
        errors[k % strengths] +=
            std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
    }
    return errors;
}

}  // namespace fbrdf
