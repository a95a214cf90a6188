#include "solve/SystemSums.h"

namespace fbrdf {
namespace {

// What the sums of R, G and B may take side by side; larger ones are made one after the other.
constexpr size_t kMostSideBySide = size_t{256} << 20;

// Of large matrices fewer are made at the same time: to clear and to add up another takes longer
// than the sums in it.
size_t partsOf(const LeastSquares& problem)
{
    constexpr size_t kLargeMatrix = size_t{256} << 10;
    return shapeOf(problem.layout()).size() > kLargeMatrix ? kParts / 2 : kParts;
}

std::vector<ChannelPass> passes(const LeastSquares& problem, const StepOptions& options,
                                size_t groups)
{
    if (problem.layout().sharedShape()) return {{0, 1, 1}};
    if (!dependsOnState(problem, options)) return {{0, 3, 1}};
    if (problem.statistics().grey) return {{0, 1, 1}};
    const size_t sideBySide =
        partsOf(problem) * groups * shapeOf(problem.layout()).size() * kLanes * sizeof(double);
    if (sideBySide <= kMostSideBySide) return {{0, 3, kLanes}};
    return {{0, 1, 1}, {1, 1, 1}, {2, 1, 1}};
}

using Groups = std::vector<NormalSums>;  // of samples, as FoldGroups number them

Groups zeroGroups(const LeastSquares& problem, size_t matrices, size_t count)
{
    Groups groups;
    for (size_t g = 0; g < count; ++g)
        groups.emplace_back(shapeOf(problem.layout()), matrices, problem.workspace());
    return groups;
}

// The groups' sums over each part of the rows, in the order of the parts.
std::vector<Groups> sumsOfParts(const LeastSquares& problem, const RowOptions& with,
                                size_t groupCount)
{
    const size_t count = partsOf(problem);
    std::vector<Groups> parts(count);
    std::vector<NormalRows> rows(count);
    std::vector<std::vector<double>> kernelScratch(count);
    problem.forEachBlock(
        [&](size_t part, size_t block, RowStore::Scratch& scratch) {
            if (parts[part].empty())
                parts[part] = zeroGroups(problem, with.pass.matrices, groupCount);
            rows[part].make(problem, problem.store().block(block, scratch), with);
            addRows(rows[part].rows(), rows[part].entryLanes(), parts[part], kernelScratch[part]);
        },
        count);
    return parts;
}

// The sums of all parts, added up in their order into those of the first that has rows.
Groups sumOf(const LeastSquares& problem, std::vector<Groups> parts, size_t matrices, size_t count)
{
    Groups total;
    for (Groups& part : parts) {
        if (total.empty())
            total = std::move(part);
        else if (!part.empty())
            parallelTasks(count, problem.threads(), [&](size_t g) { total[g] += part[g]; });
        part.clear();
    }
    return total.empty() ? zeroGroups(problem, matrices, count) : std::move(total);
}

// The groups' sums over all rows of all processes.
Groups sums(const LeastSquares& problem, const RowOptions& with, size_t groupCount)
{
    Groups groups =
        sumOf(problem, sumsOfParts(problem, with, groupCount), with.pass.matrices, groupCount);
    for (NormalSums& group : groups) {
        problem.options().ranks.sum(group.matrixSums());
        problem.options().ranks.sum(group.rightSums());
    }
    return groups;
}

// Element k: group 0 and all others but 1 + k; the last: all groups.
Groups totalsOf(const LeastSquares& problem, Groups groups, size_t matrices)
{
    if (groups.size() == 1) return groups;
    Groups totals = zeroGroups(problem, matrices, groups.size());
    parallelTasks(totals.size(), problem.threads(), [&](size_t k) {
        for (size_t g = 0; g < groups.size(); ++g)
            if (g != k + 1) totals[k] += groups[g];
    });
    return totals;
}

// The key of systems with equal weights of all samples on a known grid, which other fits may meet
// again; empty for others.
std::string gridKey(const LeastSquares& problem, const StepOptions& options,
                    const ChannelPass& pass, const std::vector<int>& folds)
{
    if (problem.cacheKey().empty() || pass.channels != 3 || pass.matrices != 1) return {};
    std::string key = problem.cacheKey() + "|" + std::to_string(problem.seed()) + "|" +
                      std::to_string(options.excludedFold);
    for (const int fold : folds) key += "," + std::to_string(fold);
    return key;
}

// The systems of one pass. Its channels have either a matrix each or one for all, so that a matrix
// serves `together` of them: matrix m, which stands in lane m of the sums, serves the lanes
// [m together, (m + 1) together) of the right-hand sides.
std::vector<SharedSystems> systemsFrom(const LeastSquares& problem, const ChannelPass& pass,
                                       const Groups& totals,
                                       const std::shared_ptr<const GridSystems>& known)
{
    const size_t matrices = pass.matrices == kLanes ? pass.channels : 1,
                 together = pass.channels / matrices;
    std::vector<SharedSystems> shared(matrices);
    for (size_t m = 0; m < matrices; ++m)
        shared[m] = {pass.first + m * together, together,
                     std::vector<std::shared_ptr<const SmoothSystem>>(totals.size()),
                     std::vector<std::vector<double>>(totals.size())};
    // One task for every matrix m without every fold k.
    parallelTasks(matrices * totals.size(), problem.threads(), [&](size_t task) {
        const size_t k = task % totals.size(), m = task / totals.size();
        for (size_t lane = m * together; lane < (m + 1) * together; ++lane) {
            const auto right = totals[k].right(lane);
            shared[m].right[k].insert(shared[m].right[k].end(), right.begin(), right.end());
        }
        shared[m].systems[k] =
            known ? std::shared_ptr<const SmoothSystem>(known, known->systems[k].get())
                  : std::make_shared<const SmoothSystem>(totals[k].matrix(m, problem.workspace()),
                                                         problem.smoothness(), problem.workspace());
    });
    return shared;
}

std::vector<SharedSystems> systemsOfPass(const LeastSquares& problem, const StepOptions& options,
                                         RowOptions with, const std::vector<int>& folds)
{
    const ChannelPass pass = with.pass;
    const std::string key = gridKey(problem, options, pass, folds);
    FitCache* cache = problem.options().cache;
    auto known = key.empty() ? nullptr : cache->systems(key);
    if (known) with.pass.matrices = 0;
    const Groups totals =
        totalsOf(problem, sums(problem, with, folds.size() + 1), with.pass.matrices);
    if (!known && !key.empty()) {
        known = std::make_shared<const GridSystems>(problem.form(), totals);
        cache->keepSystems(key, known);
    }
    return systemsFrom(problem, pass, totals, known);
}

}  // namespace

std::vector<SharedSystems> systemsAt(const LeastSquares& problem, const State& x,
                                     const StepOptions& options, const Vec3f& scale,
                                     const std::vector<int>& folds)
{
    std::vector<SharedSystems> all;
    for (const ChannelPass& pass : passes(problem, options, folds.size() + 1)) {
        const RowOptions with{RowWeights(problem, options, scale), Texels(problem, x), pass,
                              groupsOf(folds, options.excludedFold)};
        for (SharedSystems& shared : systemsOfPass(problem, options, with, folds))
            all.push_back(std::move(shared));
    }
    return all;
}

}  // namespace fbrdf
