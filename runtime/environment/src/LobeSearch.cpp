#include "LobeSearch.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr int kSearchSweeps = 3, kFirstRounds = 6, kWalkRounds = 3, kSweepRounds = 2;

class Search {
public:
    Search(const LobeDictionary& dictionary, const std::vector<LobeTarget>& targets, int lobes,
           double continuity)
        : dictionary_(dictionary),
          targets_(targets),
          lobes_(static_cast<size_t>(lobes)),
          continuity_(continuity),
          sets_(targets.size())
    {
        for (size_t atom = 0; atom < dictionary.size(); ++atom) {
            all_.push_back(atom);
            if (dictionary.tilt(atom) == 0.0f) untilted_.push_back(atom);
        }
    }

    std::vector<AtomSet> run(const LobeStart& start)
    {
        const size_t first = start.knot, count = targets_.size();
        if (start.fewer.empty()) {
            sets_[first] = improved(first, {}, {}, kFirstRounds);
            for (size_t i = first + 1; i < count; ++i)
                sets_[i] = improved(i, sets_[i - 1], {i - 1}, kWalkRounds);
            for (size_t i = first; i-- > 0;)
                sets_[i] = improved(i, projected(i, sets_[i + 1]), {i + 1}, kWalkRounds);
        } else {
            sets_[first] = improved(first, start.fewer[first], {}, kFirstRounds);
            for (size_t i = 0; i < count; ++i) {
                if (i == first) continue;
                sets_[i] = start.fewer[i];
                sets_[i].insert(sets_[i].end(),
                                sets_[first].begin() + static_cast<long>(sets_[i].size()),
                                sets_[first].end());
                sets_[i] = projected(i, sets_[i]);
            }
        }
        for (int sweep = 0; sweep < kSearchSweeps; ++sweep) {
            const auto before = sets_;
            for (size_t i = first; i < count; ++i) settle(i);
            for (size_t i = first; i-- > 0;) settle(i);
            if (before == sets_) break;
        }
        return sets_;
    }

private:
    const std::vector<size_t>& allowed(size_t knot) const { return knot == 0 ? untilted_ : all_; }

    /// The set with tilts that are allowed at the knot.
    AtomSet projected(size_t knot, AtomSet set) const
    {
        if (knot != 0) return set;
        for (size_t& atom : set)
            atom = *std::min_element(untilted_.begin(), untilted_.end(), [&](size_t a, size_t b) {
                return std::abs(dictionary_.level(a) - dictionary_.level(atom)) <
                       std::abs(dictionary_.level(b) - dictionary_.level(atom));
            });
        return set;
    }

    void settle(size_t knot)
    {
        std::vector<size_t> neighbours;
        if (knot > 0) neighbours.push_back(knot - 1);
        if (knot + 1 < targets_.size()) neighbours.push_back(knot + 1);
        sets_[knot] = improved(knot, sets_[knot], neighbours, kSweepRounds);
    }

    AtomSet improved(size_t knot, AtomSet set, const std::vector<size_t>& neighbours,
                     int rounds) const
    {
        while (set.size() < lobes_) {
            set.push_back(0);
            set.back() = best(knot, set, set.size() - 1, {});
        }
        for (int round = 0; round < rounds; ++round) {
            const AtomSet before = set;
            for (size_t k = 0; k < lobes_; ++k) set[k] = best(knot, set, k, neighbours);
            if (before == set) break;
        }
        return set;
    }

    /// The atom that stands best in place k of the set.
    size_t best(size_t knot, const AtomSet& set, size_t k,
                const std::vector<size_t>& neighbours) const
    {
        std::array<WeightProblem, 3> problems = problemsOf(knot, set);
        double least = std::numeric_limits<double>::infinity();
        size_t chosen = set[k];
        for (const size_t atom : allowed(knot)) {
            // The squared error is at least 0, and at least the penalty with it.
            double cost = penalty(atom, k, neighbours) * targets_[knot].energy;
            if (cost >= least) continue;
            put(problems, knot, set, k, atom);
            cost += targets_[knot].energy;
            for (const WeightProblem& problem : problems)
                cost += objective(problem, roughWeights(problem));
            if (cost >= least) continue;
            least = cost;
            chosen = atom;
        }
        return chosen;
    }

    double penalty(size_t atom, size_t k, const std::vector<size_t>& neighbours) const
    {
        double sum = 0.0;
        for (const size_t knot : neighbours) {
            const size_t other = sets_[knot][k];
            const auto level = double(dictionary_.level(atom) - dictionary_.level(other));
            const auto tilt = double(dictionary_.tilt(atom) - dictionary_.tilt(other));
            sum += level * level + tilt * tilt;
        }
        return continuity_ * sum;
    }

    std::array<WeightProblem, 3> problemsOf(size_t knot, const AtomSet& set) const
    {
        const LobeTarget& target = targets_[knot];
        std::array<WeightProblem, 3> problems;
        for (size_t c = 0; c < 3; ++c) {
            problems[c].count = static_cast<int>(set.size()) + 1;
            problems[c].gram[0][0] = target.cosineSquared;
            problems[c].right[0] = target.cosineProducts[c];
        }
        for (size_t k = 0; k < set.size(); ++k) put(problems, knot, set, k, set[k]);
        return problems;
    }

    void put(std::array<WeightProblem, 3>& problems, size_t knot, const AtomSet& set, size_t k,
             size_t atom) const
    {
        const LobeTarget& target = targets_[knot];
        for (size_t c = 0; c < 3; ++c) {
            auto& gram = problems[c].gram;
            gram[0][k + 1] = gram[k + 1][0] = target.atomCosine[atom];
            gram[k + 1][k + 1] = dictionary_.product(atom, atom);
            for (size_t other = 0; other < set.size(); ++other)
                if (other != k)
                    gram[other + 1][k + 1] = gram[k + 1][other + 1] =
                        dictionary_.product(atom, set[other]);
            problems[c].right[k + 1] = target.atomProducts[atom][c];
        }
    }

    const LobeDictionary& dictionary_;
    const std::vector<LobeTarget>& targets_;
    size_t lobes_;
    double continuity_;
    std::vector<AtomSet> sets_;
    std::vector<size_t> all_, untilted_;
};

/// True when both sides of the plane of incidence seem to reflect alike, as most materials do: half
/// of the calls then suffice.
bool seemsEven(const MirrorQuadrature& at, const Reflectance& f)
{
    constexpr double kTheta = 0.8;
    constexpr size_t kEvery = 37;
    const Vec3d wo(std::sin(kTheta), 0.0, std::cos(kTheta));
    for (size_t i = 0; i < at.nodes.size(); i += kEvery) {
        const Vec3d wi = fromMirrorFrame(at.nodes[i], kTheta);
        if (!(wi.z > 0.0)) continue;
        const Vec3d here = f(wo, wi), there = f(wo, Vec3d(wi.x, -wi.y, wi.z));
        if (!(glm::length(here - there) <= 1e-9 * glm::length(here))) return false;
    }
    return true;
}

/// f cos theta_i at the nodes, for each channel: the mean of both sides of the plane of incidence.
std::array<std::vector<double>, 3> reflected(const MirrorQuadrature& at, const Reflectance& f,
                                             double theta, bool isEven)
{
    std::array<std::vector<double>, 3> values;
    for (auto& channel : values) channel.assign(at.nodes.size(), 0.0);
    const Vec3d wo(std::sin(theta), 0.0, std::cos(theta));
    for (size_t i = 0; i < at.nodes.size(); ++i) {
        const Vec3d wi = fromMirrorFrame(at.nodes[i], theta);
        if (!(wi.z > 0.0)) continue;
        const Vec3d value =
            wi.z * (isEven ? f(wo, wi) : 0.5 * (f(wo, wi) + f(wo, Vec3d(wi.x, -wi.y, wi.z))));
        for (int c = 0; c < 3; ++c) {
            if (!std::isfinite(value[c]))
                throw Error(ErrorKind::fit, "lobes",
                            Found("a reflectance that is no number at theta_o = " +
                                  numberText(theta / kDegree) + " degrees")
                                .expected("finite values"));
            values[static_cast<size_t>(c)][i] = std::max(0.0, value[c]);
        }
    }
    return values;
}

LobeTarget targetAt(const LobeDictionary& dictionary, const Reflectance& f, double theta,
                    bool isEven)
{
    LobeTarget target;
    target.theta = theta;
    target.cosine = dictionary.cosine(theta);
    target.cosineSquared = dot(target.cosine, target.cosine);
    const MirrorQuadrature& at = dictionary.quadrature();
    const auto values = reflected(at, f, theta, isEven);
    for (size_t c = 0; c < 3; ++c) {
        double albedo = 0.0;
        for (size_t i = 0; i < at.nodes.size(); ++i) albedo += values[c][i] * at.weights[i];
        target.albedo[static_cast<int>(c)] = albedo;
        target.channels[c] = dictionary.project(values[c]);
        target.energy += dot(target.channels[c], target.channels[c]);
        target.cosineProducts[c] = dot(target.cosine, target.channels[c]);
    }
    for (size_t atom = 0; atom < dictionary.size(); ++atom) {
        const Projected& lobe = dictionary.projected(atom);
        target.atomCosine.push_back(dot(lobe, target.cosine));
        target.atomProducts.push_back({dot(lobe, target.channels[0]), dot(lobe, target.channels[1]),
                                       dot(lobe, target.channels[2])});
    }
    return target;
}

}  // namespace

std::vector<LobeTarget> lobeTargets(const LobeDictionary& dictionary, const Reflectance& f,
                                    const std::vector<double>& thetas, int threads)
{
    std::vector<LobeTarget> targets(thetas.size());
    const bool isEven = seemsEven(dictionary.quadrature(), f);
    parallelTasks(thetas.size(), threads,
                  [&](size_t i) { targets[i] = targetAt(dictionary, f, thetas[i], isEven); });
    return targets;
}

std::vector<AtomSet> searchLobes(const LobeDictionary& dictionary,
                                 const std::vector<LobeTarget>& targets, int lobes,
                                 const LobeStart& start)
{
    return Search(dictionary, targets, lobes, start.continuity).run(start);
}

LobeKnot knotOf(const LobeTarget& target, const std::vector<Projected>& lobes,
                const std::vector<Lobe>& at)
{
    LobeKnot knot;
    for (size_t k = 0; k < at.size(); ++k) knot.lobes[k] = at[k];
    WeightProblem problem;
    problem.count = static_cast<int>(lobes.size()) + 1;
    problem.gram[0][0] = target.cosineSquared;
    for (size_t k = 0; k < lobes.size(); ++k) {
        problem.gram[0][k + 1] = problem.gram[k + 1][0] = dot(lobes[k], target.cosine);
        for (size_t j = 0; j < lobes.size(); ++j)
            problem.gram[k + 1][j + 1] = dot(lobes[k], lobes[j]);
    }
    for (size_t c = 0; c < 3; ++c) {
        problem.right[0] = target.cosineProducts[c];
        for (size_t k = 0; k < lobes.size(); ++k)
            problem.right[k + 1] = dot(lobes[k], target.channels[c]);
        const Weights weights = weightsOfSum(problem, target.albedo[static_cast<int>(c)]);
        knot.cosine[static_cast<int>(c)] = static_cast<float>(weights[0]);
        for (size_t k = 0; k < lobes.size(); ++k)
            knot.lobes[k].weight[static_cast<int>(c)] = static_cast<float>(weights[k + 1]);
    }
    return knot;
}

}  // namespace fbrdf
