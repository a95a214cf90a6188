// Steps by factored systems. Rows are added up once for all smoothness strengths and folds.
#include "solve/LeastSquaresRows.h"

#include <fbrdf/base/Error.h>

namespace fbrdf {
namespace {

// Numbers of a system that is factored; 64 MB. Larger ones go to conjugate gradients.
constexpr size_t kMostFactored = size_t{8} << 20;
// What the sums of R, G and B may take side by side; else they are made one after the other.
constexpr size_t kMostSideBySide = size_t{256} << 20;

}  // namespace

/// Channels with one matrix: a system and right-hand sides (unknowns x channels) without each fold,
/// and the whole last.
struct LeastSquares::SharedSystems {
    size_t first, channels;
    std::vector<std::shared_ptr<const SmoothSystem>> systems;
    std::vector<std::vector<double>> right;
};

bool LeastSquares::isLarge() const
{
    if (options_.solver != SystemSolver::automatic)
        return options_.solver == SystemSolver::conjugateGradients;
    return shapeOf(layout_).size() > kMostFactored;
}

std::vector<LeastSquares::Pass> LeastSquares::passes(const StepOptions& options,
                                                     size_t groups) const
{
    if (layout_.sharedShape()) return {{0, 1, 1}};
    if (!dependsOnState(options)) return {{0, 3, 1}};
    if (traits_.grey) return {{0, 1, 1}};
    const size_t sideBySide = kParts * groups * shapeOf(layout_).size() * kLanes * sizeof(double);
    if (sideBySide <= kMostSideBySide) return {{0, 3, kLanes}};
    return {{0, 1, 1}, {1, 1, 1}, {2, 1, 1}};
}

// The sums of each group.
std::vector<NormalSums> LeastSquares::sums(const State& x, const StepOptions& options,
                                           const Pass& pass, const std::vector<int>& folds) const
{
    const RowOptions with{options, options.robust ? tukeyScale(x, options) : Vec3f(1.0f),
                          Texels(*this, x), pass, groupsOf(folds, options.excludedFold)};
    std::vector<std::vector<NormalSums>> parts(kParts);
    std::vector<NormalRows> rows(kParts);
    std::vector<std::vector<double>> kernelScratch(kParts);
    forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        if (parts[part].empty())
            parts[part].assign(folds.size() + 1, NormalSums(shapeOf(layout_), pass.matrices));
        makeNormalRows(store_->block(block, scratch), with, rows[part]);
        addRows(rows[part].rows, rows[part].entryLanes, parts[part], kernelScratch[part]);
    });
    const BorderedShape shape = shapeOf(layout_);
    std::vector<NormalSums> groups(folds.size() + 1, NormalSums(shape, pass.matrices));
    for (size_t g = 0; g < groups.size(); ++g) {
        for (auto& part : parts) {
            if (part.empty()) continue;
            groups[g] += part[g];
            part[g] = NormalSums();
        }
        options_.ranks.sum(groups[g].matrixSums());
        options_.ranks.sum(groups[g].rightSums());
    }
    return groups;
}

namespace {

// The strongest of the strengths that are as good as the best: what the held-out samples cannot
// tell apart, 8 bits hold the better the smoother it is (Breiman et al. 1984: the
// one-standard-error rule, with a share in place of the standard error).
size_t smoothestNearLeast(const std::vector<double>& errors, const std::vector<double>& strengths)
{
    constexpr double kAsGood = 1.02;
    size_t best =
        static_cast<size_t>(std::min_element(errors.begin(), errors.end()) - errors.begin());
    const double most = errors[best] * kAsGood;
    for (size_t s = 0; s < errors.size(); ++s)
        if (errors[s] <= most && strengths[s] > strengths[best]) best = s;
    return best;
}

// Group 0 and all others but 1 + left; with left == number of folds, all.
NormalSums without(const std::vector<NormalSums>& groups, size_t left)
{
    NormalSums total = groups[0];
    for (size_t g = 1; g < groups.size(); ++g)
        if (g != left + 1) total += groups[g];
    return total;
}

}  // namespace

std::vector<LeastSquares::SharedSystems> LeastSquares::systems(const State& x,
                                                               const StepOptions& options,
                                                               const Pass& pass,
                                                               const std::vector<int>& folds) const
{
    const std::string key = gridKey(options, pass, folds);
    auto known = key.empty() ? nullptr : options_.cache->systems(key);
    Pass needed = pass;
    if (known) needed.matrices = 0;
    const std::vector<NormalSums> groups = sums(x, options, needed, folds);
    const size_t systemCount = folds.size() + 1;
    std::vector<NormalSums> totals(systemCount);
    parallelTasks(systemCount, threads_, [&](size_t k) { totals[k] = without(groups, k); });
    if (!known && !key.empty()) {
        known = std::make_shared<const GridSystems>(form_, totals);
        options_.cache->keepSystems(key, known);
    }
    const size_t matrices = pass.matrices == kLanes ? pass.channels : 1,
                 together = pass.channels / matrices;
    std::vector<SharedSystems> shared(matrices);
    for (size_t m = 0; m < matrices; ++m)
        shared[m] = {pass.first + m * together, together,
                     std::vector<std::shared_ptr<const SmoothSystem>>(systemCount),
                     std::vector<std::vector<double>>(systemCount)};
    parallelTasks(matrices * systemCount, threads_, [&](size_t i) {
        const size_t k = i % systemCount, m = i / systemCount;
        for (size_t l = m * together; l < (m + 1) * together; ++l) {
            const auto right = totals[k].right(l);
            shared[m].right[k].insert(shared[m].right[k].end(), right.begin(), right.end());
        }
        shared[m].systems[k] =
            known ? std::shared_ptr<const SmoothSystem>(known, known->systems[k].get())
                  : std::make_shared<const SmoothSystem>(totals[k].matrix(m), smoothness_);
    });
    return shared;
}

// Of systems with equal weights of all samples on a known grid, which other fits may meet again;
// empty for others.
std::string LeastSquares::gridKey(const StepOptions& options, const Pass& pass,
                                  const std::vector<int>& folds) const
{
    if (cacheKey_.empty() || pass.channels != 3 || pass.matrices != 1) return {};
    std::string key =
        cacheKey_ + "|" + std::to_string(seed_) + "|" + std::to_string(options.excludedFold);
    for (const int fold : folds) key += "," + std::to_string(fold);
    return key;
}

std::vector<LeastSquares::SharedSystems> LeastSquares::allSystems(
    const State& x, const StepOptions& options, const std::vector<int>& folds) const
{
    std::vector<SharedSystems> all;
    for (const Pass& pass : passes(options, folds.size() + 1))
        for (SharedSystems& shared : systems(x, options, pass, folds))
            all.push_back(std::move(shared));
    return all;
}

void LeastSquares::takeStep(State& x, const SharedSystems& shared, size_t which, double strength,
                            double damping) const
{
    double* columns = x.data() + shared.first * unknowns();
    const std::vector<double> step = shared.systems[which]->step(
        shared.right[which], columns, shared.channels, strength, damping, form_.name);
    for (size_t u = 0; u < step.size(); ++u) columns[u] += bounded(step[u]);
}

void LeastSquares::repeatGrey(State& x) const
{
    if (!traits_.grey || layout_.sharedShape()) return;
    for (size_t i = unknowns(); i < x.size(); ++i) x[i] = x[i - unknowns()];
}

State LeastSquares::step(const State& x, const StepOptions& options) const
{
    if (isLarge()) return conjugateGradientStep(x, options);
    // Where nothing depends on the state, the one that costs least will do.
    State next = dependsOnState(options) || options.damping > 0.0 ? x : flatState();
    const auto all = allSystems(next, options, {});
    parallelTasks(all.size(), threads_, [&](size_t i) {
        takeStep(next, all[i], 0, options.smoothness, options.damping);
    });
    repeatGrey(next);
    return next;
}

LeastSquares::Choice LeastSquares::stepWithBest(const State& x, const StepOptions& options,
                                                const std::vector<double>& strengths,
                                                const std::vector<int>& folds) const
{
    const auto all = allSystems(x, options, folds);
    std::vector<States> states(folds.size(), States(strengths.size(), x));
    const size_t trials = folds.size() * strengths.size();
    parallelTasks(trials * all.size(), threads_, [&](size_t i) {
        const size_t k = i % trials / strengths.size(), s = i % strengths.size();
        takeStep(states[k][s], all[i / trials], k, strengths[s], options.damping);
    });
    for (States& fold : states)
        for (State& state : fold) repeatGrey(state);
    const std::vector<double> errors = foldErrors(states, folds);
    const size_t best = smoothestNearLeast(errors, strengths);
    Choice choice{x, strengths[best]};
    parallelTasks(all.size(), threads_, [&](size_t i) {
        takeStep(choice.x, all[i], folds.size(), choice.smoothness, options.damping);
    });
    repeatGrey(choice.x);
    return choice;
}

}  // namespace fbrdf
