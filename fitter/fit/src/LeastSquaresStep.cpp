// Steps by factored systems. Rows are added up once for all smoothness strengths and folds.
#include "LeastSquaresRows.h"

#include <fbrdf/brdf/Error.h>

namespace fbrdf {
namespace {

// Numbers of a system that is factored; 64 MB. Larger ones go to conjugate gradients.
constexpr size_t kMostFactored = size_t{8} << 20;
// What the sums of R, G and B may take side by side; else they are made one after the other.
constexpr size_t kMostSideBySide = size_t{256} << 20;

}  // namespace

/// One channel: a system and its right-hand side without each fold, and the whole last.
struct LeastSquares::ChannelSystems {
    size_t channel;
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

// Group 0: the rows in no fold of `folds`; then those of each fold.
template <class Entry>
void LeastSquares::addRows(const State& x, const StepOptions& options, const Pass& pass,
                           const std::vector<int>& folds,
                           std::vector<std::vector<NormalSums>>& parts) const
{
    const Vec3f scale = options.robust ? tukeyScale(x, options) : Vec3f(1.0f);
    const Texels texels(*this, x);
    const BorderedShape shape = shapeOf(layout_);
    forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        NormalRowBuffer<Entry> buffer(static_cast<size_t>(maker_.width()) + form_.terms.size());
        forEachRow(block, scratch, texels, options, scale, [&](const Row& row, int fold) {
            const auto found = std::find(folds.begin(), folds.end(), fold);
            const auto index = static_cast<size_t>(found - folds.begin());
            NormalSums& group = parts[part][found == folds.end() ? 0 : 1 + index];
            if (group.empty()) group = NormalSums(shape, pass.matrices);
            forEachNormalRow(row, pass, buffer,
                             [&group](const NormalRow<Entry>& normal) { group.add(normal); });
        });
    });
}

// The sums of each group.
std::vector<NormalSums> LeastSquares::sums(const State& x, const StepOptions& options,
                                           const Pass& pass, const std::vector<int>& folds) const
{
    std::vector<std::vector<NormalSums>> parts(kParts, std::vector<NormalSums>(folds.size() + 1));
    withEntries(pass, [&](auto one) { addRows<decltype(one)>(x, options, pass, folds, parts); });
    const BorderedShape shape = shapeOf(layout_);
    std::vector<NormalSums> groups(folds.size() + 1, NormalSums(shape, pass.matrices));
    for (size_t g = 0; g < groups.size(); ++g) {
        for (auto& part : parts) {
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

std::vector<LeastSquares::ChannelSystems> LeastSquares::systems(const State& x,
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
    std::vector<ChannelSystems> channels(pass.channels);
    for (size_t l = 0; l < pass.channels; ++l)
        channels[l] = {pass.first + l, {}, std::vector<std::vector<double>>(systemCount)};
    const size_t matrices = known ? 0 : pass.matrices == 1 ? 1 : pass.channels;
    std::vector<std::shared_ptr<const SmoothSystem>> made(matrices * systemCount);
    parallelTasks(made.size(), threads_, [&](size_t i) {
        made[i] = std::make_shared<const SmoothSystem>(
            totals[i % systemCount].matrix(i / systemCount), smoothness_);
    });
    for (size_t l = 0; l < pass.channels; ++l)
        for (size_t k = 0; k < systemCount; ++k) {
            channels[l].right[k] = totals[k].right(l);
            channels[l].systems.push_back(
                known ? std::shared_ptr<const SmoothSystem>(known, known->systems[k].get())
                      : made[(matrices == 1 ? 0 : l) * systemCount + k]);
        }
    return channels;
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

std::vector<LeastSquares::ChannelSystems> LeastSquares::allSystems(
    const State& x, const StepOptions& options, const std::vector<int>& folds) const
{
    std::vector<ChannelSystems> all;
    for (const Pass& pass : passes(options, folds.size() + 1))
        for (ChannelSystems& channel : systems(x, options, pass, folds))
            all.push_back(std::move(channel));
    return all;
}

void LeastSquares::takeStep(State& x, const ChannelSystems& channel, size_t which, double strength,
                            double damping) const
{
    double* column = x.data() + channel.channel * unknowns();
    const std::vector<double> step =
        channel.systems[which]->step(channel.right[which], column, strength, damping, form_.name);
    for (size_t u = 0; u < step.size(); ++u) column[u] += bounded(step[u]);
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
    const auto channels = allSystems(next, options, {});
    parallelTasks(channels.size(), threads_, [&](size_t i) {
        takeStep(next, channels[i], 0, options.smoothness, options.damping);
    });
    repeatGrey(next);
    return next;
}

LeastSquares::Choice LeastSquares::stepWithBest(const State& x, const StepOptions& options,
                                                const std::vector<double>& strengths,
                                                const std::vector<int>& folds) const
{
    const auto channels = allSystems(x, options, folds);
    std::vector<States> states(folds.size(), States(strengths.size(), x));
    const size_t trials = folds.size() * strengths.size();
    parallelTasks(trials * channels.size(), threads_, [&](size_t i) {
        const size_t k = i % trials / strengths.size(), s = i % strengths.size();
        takeStep(states[k][s], channels[i / trials], k, strengths[s], options.damping);
    });
    for (States& fold : states)
        for (State& state : fold) repeatGrey(state);
    const std::vector<double> errors = foldErrors(states, folds);
    const size_t best = smoothestNearLeast(errors, strengths);
    Choice choice{x, strengths[best]};
    parallelTasks(channels.size(), threads_, [&](size_t i) {
        takeStep(choice.x, channels[i], folds.size(), choice.smoothness, options.damping);
    });
    repeatGrey(choice.x);
    return choice;
}

}  // namespace fbrdf
