// Which of both axes the normals bend along, and how far, is found with a few knots; then each knot
// gets the level and the weights that are best for it.
#include "BentFit.h"

#include "LobeWeights.h"
#include "RadialCovariance.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/plan/Lobes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr int kBentThetas = 12, kBentAzimuths = 7;
constexpr int kBentRings = 64, kBentNodesInRing = 48;
constexpr double kFirstSpread = 0.04, kSpreadStep = 0.04;
constexpr int kSpreads = 12;
constexpr int kThetaStride = 3, kAzimuthStride = 2;  // of the knots that decide on the spread

struct BentTarget {
    Vec3d wo;
    std::vector<Vec3d> directions;  ///< where f is not 0
    std::vector<Vec3d> light;       ///< f cos theta_i times the solid angle of the node
    Vec3d albedo{0.0};
};

/// The mean of f over the reflections of both directions at the axes of the frame.
Vec3d foldedReflectance(const Reflectance& f, const Vec3d& wo, const Vec3d& wi)
{
    Vec3d sum(0.0);
    for (const double x : {1.0, -1.0})
        for (const double y : {1.0, -1.0})
            sum += f(Vec3d(x * wo.x, y * wo.y, wo.z), Vec3d(x * wi.x, y * wi.y, wi.z));
    return 0.25 * sum;
}

BentTarget bentTarget(const Reflectance& f, double theta, double phi)
{
    BentTarget target;
    const double s = std::sin(theta), c = std::cos(theta);
    target.wo = {s * std::cos(phi), s * std::sin(phi), c};
    const Vec3d mirror(-target.wo.x, -target.wo.y, c), across(-std::sin(phi), std::cos(phi), 0.0);
    const Vec3d inwards = glm::cross(across, mirror);
    for (int i = 0; i < kBentRings; ++i) {
        const double u = (i + 0.5) / kBentRings, g = kPi * u * u * u;
        const double solidAngle =
            std::sin(g) * 3.0 * kPi * u * u / kBentRings * 2.0 * kPi / kBentNodesInRing;
        for (int j = 0; j < kBentNodesInRing; ++j) {
            const double a = (j + 0.5) / kBentNodesInRing * 2.0 * kPi;
            const Vec3d wi =
                mirror * std::cos(g) + (inwards * std::cos(a) + across * std::sin(a)) * std::sin(g);
            if (!(wi.z > 0.0)) continue;
            const Vec3d value = foldedReflectance(f, target.wo, wi) * (wi.z * solidAngle);
            if (!(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)))
                throw Error(ErrorKind::fit, "lobes",
                            Found("a reflectance that is no number at theta_o = " +
                                  numberText(theta / kDegree) + " degrees")
                                .expected("finite values"));
            target.directions.push_back(wi);
            target.light.push_back(glm::max(value, 0.0));
            target.albedo += target.light.back();
        }
    }
    return target;
}

struct BentChoice {
    float spread = 0.0f;
    bool across = false;
};

class BentFit {
public:
    BentFit(const Reflectance& f, const LobeFitOptions& options)
        : normals_(static_cast<size_t>(options.normals)), threads_(options.threads)
    {
        targets_.resize(kBentThetas * kBentAzimuths);
        parallelTasks(targets_.size(), threads_, [&](size_t i) {
            const int theta = static_cast<int>(i) % kBentThetas;
            const int azimuth = static_cast<int>(i) / kBentThetas;
            targets_[i] = bentTarget(f, lobeKnotAngle(theta, kBentThetas),
                                     0.5 * kPi * azimuth / (kBentAzimuths - 1));
        });
        for (size_t i = 0; i < targets_.size(); ++i)
            if (isDeciding(i)) deciding_.push_back(i);
    }

    LobeTable run() const
    {
        const BentChoice choice = bestChoice();
        LobeTable table;
        table.axes = LobeAxes::bent;
        table.lobes = static_cast<int>(normals_);
        table.thetas = kBentThetas;
        table.azimuths = kBentAzimuths;
        table.spread = choice.spread;
        table.acrossTangent = choice.across;
        table.knots.resize(targets_.size());
        parallelTasks(targets_.size(), threads_, [&](size_t i) {
            table.knots[i] = knotAt(targets_[i], axesOf(targets_[i], choice));
        });
        table.error = errorOf(table, choice);
        std::vector<double> fewerErrors;
        for (int lobes = 1; keptLobes(table, lobes) < table.lobes; ++lobes)
            fewerErrors.push_back(errorOf(widened(withFewerLobes(table, lobes)), choice));
        table.fewerErrors = fewerErrors;
        return table;
    }

private:
    using Problems = std::array<WeightProblem, 3>;

    /// The table of the middle lobes, with the others at nothing.
    LobeTable widened(LobeTable table) const
    {
        const auto kept = static_cast<size_t>(table.lobes), first = (normals_ - kept) / 2;
        for (LobeKnot& knot : table.knots) {
            const auto middle = knot.lobes;
            knot.lobes = {};
            for (size_t k = 0; k < normals_; ++k) knot.lobes[k].level = middle[0].level;
            for (size_t k = 0; k < kept; ++k) knot.lobes[first + k] = middle[k];
        }
        return table;
    }

    static bool isDeciding(size_t i)
    {
        return static_cast<int>(i) % kBentThetas % kThetaStride == 1 &&
               static_cast<int>(i) / kBentThetas % kAzimuthStride == 0;
    }
    /// As many pixels of a sphere see it; normal incidence counts a little.
    static double weightOf(const BentTarget& target)
    {
        return std::hypot(target.wo.x, target.wo.y) * target.wo.z + 0.02;
    }

    std::vector<Vec3d> axesOf(const BentTarget& target, const BentChoice& choice) const
    {
        LobeTable table;
        table.axes = LobeAxes::bent;
        table.lobes = static_cast<int>(normals_);
        table.thetas = 2;
        table.spread = choice.spread;
        table.acrossTangent = choice.across;
        table.knots.resize(2);
        const LobeSum<double> sum = lobesAt(table, target.wo);
        return {sum.axis.begin(), sum.axis.begin() + static_cast<long>(normals_)};
    }

    BentChoice bestChoice() const
    {
        std::vector<BentChoice> choices;
        for (int i = 0; i < kSpreads; ++i)
            for (const bool across : {false, true})
                choices.push_back({static_cast<float>(kFirstSpread + kSpreadStep * i), across});
        if (normals_ == 1) choices = {{}};
        std::vector<double> costs(choices.size(), 0.0);
        parallelTasks(choices.size(), threads_, [&](size_t k) {
            for (const size_t i : deciding_) {
                double cost = 0.0;
                bestLevel(targets_[i], axesOf(targets_[i], choices[k]), cost);
                costs[k] += weightOf(targets_[i]) * cost;
            }
        });
        const auto best = std::min_element(costs.begin(), costs.end()) - costs.begin();
        return choices[static_cast<size_t>(best)];
    }

    size_t bestLevel(const BentTarget& target, const std::vector<Vec3d>& axes, double& least) const
    {
        least = std::numeric_limits<double>::infinity();
        size_t best = 0;
        for (size_t level = 0; level < covariance_.levels(); ++level) {
            double cost = 0.0;
            for (const WeightProblem& problem : problemsOf(target, axes, level))
                cost += objective(problem, roughWeights(problem));
            if (cost >= least) continue;
            least = cost;
            best = level;
        }
        return best;
    }

    Problems problemsOf(const BentTarget& target, const std::vector<Vec3d>& axes,
                        size_t level) const
    {
        Problems problems;
        const size_t cosine = covariance_.levels() - 1;
        WeightProblem& first = problems[0];
        first.count = static_cast<int>(axes.size()) + 1;
        first.gram[0][0] = covariance_.withLobe(cosine, 1.0);
        for (size_t j = 0; j < axes.size(); ++j) {
            first.gram[0][j + 1] = first.gram[j + 1][0] = covariance_.withCosine(level, axes[j].z);
            for (size_t k = 0; k < axes.size(); ++k)
                first.gram[j + 1][k + 1] = covariance_.withLobe(level, glm::dot(axes[j], axes[k]));
        }
        problems[1] = problems[2] = first;
        for (size_t i = 0; i < target.directions.size(); ++i) {
            const Vec3d& wi = target.directions[i];
            for (size_t j = 0; j <= axes.size(); ++j) {
                const double with =
                    j == 0 ? covariance_.withDirection(cosine, wi.z)
                           : covariance_.withDirection(level, glm::dot(axes[j - 1], wi));
                for (size_t c = 0; c < 3; ++c)
                    problems[c].right[j] += with * target.light[i][static_cast<int>(c)];
            }
        }
        return problems;
    }

    LobeKnot knotAt(const BentTarget& target, const std::vector<Vec3d>& axes) const
    {
        double cost = 0.0;
        const size_t level = bestLevel(target, axes, cost);
        const Problems problems = problemsOf(target, axes, level);
        LobeKnot knot;
        for (size_t k = 0; k < axes.size(); ++k)
            knot.lobes[k].level =
                static_cast<float>(static_cast<double>(level) * RadialCovariance::kStep);
        for (size_t c = 0; c < 3; ++c) {
            const int channel = static_cast<int>(c);
            const Weights weights = weightsOfSum(problems[c], target.albedo[channel]);
            knot.cosine[channel] = static_cast<float>(weights[0]);
            for (size_t k = 0; k < axes.size(); ++k)
                knot.lobes[k].weight[channel] = static_cast<float>(weights[k + 1]);
        }
        return knot;
    }

    /// Of the deciding knots.
    double errorOf(const LobeTable& table, const BentChoice& choice) const
    {
        std::vector<double> errors(deciding_.size()), energies(deciding_.size());
        parallelTasks(deciding_.size(), threads_, [&](size_t k) {
            const size_t i = deciding_[k];
            const BentTarget& target = targets_[i];
            const LobeKnot& knot = table.knots[i];
            const auto level = static_cast<size_t>(
                std::lround(double(knot.lobes[0].level) / RadialCovariance::kStep));
            const Problems problems = problemsOf(target, axesOf(target, choice), level);
            energies[k] = weightOf(target) * energyOf(target);
            errors[k] = energies[k];
            for (size_t c = 0; c < 3; ++c) {
                const int channel = static_cast<int>(c);
                Weights weights{double(knot.cosine[channel])};
                for (size_t j = 0; j < normals_; ++j)
                    weights[j + 1] = double(knot.lobes[j].weight[channel]);
                errors[k] += weightOf(target) * objective(problems[c], weights);
            }
        });
        double error = 0.0, energy = 0.0;
        for (size_t k = 0; k < errors.size(); ++k) {
            error += std::max(0.0, errors[k]);
            energy += energies[k];
        }
        return energy > 0.0 ? std::sqrt(error / energy) : 0.0;
    }

    static double energyOf(const BentTarget& target)
    {
        double sum = 0.0;
        for (size_t i = 0; i < target.light.size(); ++i) {
            if (target.light[i] == Vec3d(0.0)) continue;
            for (size_t j = 0; j <= i; ++j)
                sum += (i == j ? 1.0 : 2.0) * glm::dot(target.light[i], target.light[j]) *
                       radianceCovariance(glm::dot(target.directions[i], target.directions[j]));
        }
        return sum;
    }

    RadialCovariance covariance_;
    size_t normals_;
    int threads_;
    std::vector<BentTarget> targets_;
    std::vector<size_t> deciding_;
};

}  // namespace

LobeTable fitBentLobes(const Reflectance& f, const LobeFitOptions& options)
{
    return BentFit(f, options).run();
}

}  // namespace fbrdf
