// The covariance of radiance at the nodes is factored by Cholesky's method, the largest pivot
// first: what remains after kRank pivots is a ten-thousandth of its trace.
#include "LobeDictionary.h"

#include "RadialCovariance.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/LobeTable.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

constexpr int kRings = 84, kNodesInRing = 20;
constexpr size_t kRank = 320;
// Pivots are taken where reflectance is high: near the mirror direction, where nodes are dense and
// their solid angles small. Without that, narrow lobes would hardly count.
constexpr double kImportance = -0.3;
constexpr double kLevelStep = 0.25, kTiltStep = 0.125, kLowestTilt = -1.5, kHighestTilt = 2.0;
// Axes farther from the mirror direction were never chosen (radians).
constexpr double kFarthestOutwards = 1.3, kFarthestInwards = 1.6;

MirrorQuadrature makeQuadrature()
{
    MirrorQuadrature result;
    for (int i = 0; i < kRings; ++i) {
        // Radius pi u^3: half of the nodes lie within 23 degrees, and a ring of a lobe of half a
        // degree is resolved.
        const double u = (i + 0.5) / kRings, g = kPi * u * u * u;
        for (int j = 0; j < kNodesInRing; ++j) {
            const double a = (j + 0.5) / kNodesInRing * kPi;
            result.nodes.emplace_back(std::sin(g) * std::cos(a), std::sin(g) * std::sin(a),
                                      std::cos(g));
            result.weights.push_back(std::sin(g) * 3.0 * kPi * u * u / kRings * 2.0 * kPi /
                                     kNodesInRing);
        }
    }
    const double sum = std::accumulate(result.weights.begin(), result.weights.end(), 0.0);
    for (double& weight : result.weights) weight *= 4.0 * kPi / sum;
    return result;
}

/// Of radiance at two nodes, each the mean of both sides of the plane of incidence.
double covarianceOf(const Vec3d& a, const Vec3d& b)
{
    const double inPlane = a.x * b.x + a.z * b.z, across = a.y * b.y;
    return 0.5 * (radianceCovariance(inPlane + across) + radianceCovariance(inPlane - across));
}

}  // namespace

double dot(const Projected& a, const Projected& b)
{
    // Several sums, which a compiler keeps in one register.
    std::array<float, 8> sums{};
    double total = 0.0;
    size_t i = 0;
    for (; i + sums.size() <= a.size(); i += sums.size())
        for (size_t k = 0; k < sums.size(); ++k) sums[k] += a[i + k] * b[i + k];
    for (; i < a.size(); ++i) total += double(a[i]) * double(b[i]);
    for (const float sum : sums) total += double(sum);
    return total;
}

Vec3d fromMirrorFrame(const Vec3d& direction, double theta)
{
    const double s = std::sin(theta), c = std::cos(theta);
    return {direction.x * c - direction.z * s, direction.y, direction.x * s + direction.z * c};
}

LobeDictionary::LobeDictionary(int threads) : quadrature_(makeQuadrature())
{
    factorCovariance();
    const int levels = static_cast<int>(std::lround(kCosineLevel / kLevelStep)) + 1;
    const int tilts = static_cast<int>(std::lround((kHighestTilt - kLowestTilt) / kTiltStep)) + 1;
    for (int l = 0; l < levels; ++l)
        for (int t = 0; t < tilts; ++t) {
            const double level = l * kLevelStep, tilt = kLowestTilt + t * kTiltStep;
            const double angle = tilt * lobeWidth(level);
            if (angle <= -kFarthestOutwards || angle >= kFarthestInwards) continue;
            levels_.push_back(static_cast<float>(level));
            tilts_.push_back(static_cast<float>(tilt));
        }
    projected_.resize(size());
    parallelTasks(size(), threads, [&](size_t atom) {
        projected_[atom] = lobe(double(levels_[atom]), double(tilts_[atom]));
    });
    products_.resize(size() * size());
    parallelTasks(size(), threads, [&](size_t a) {
        for (size_t b = 0; b < size(); ++b)
            products_[a * size() + b] = static_cast<float>(dot(projected_[a], projected_[b]));
    });
}

void LobeDictionary::factorCovariance()
{
    const MirrorQuadrature& at = quadrature_;
    const size_t count = at.nodes.size();
    rank_ = std::min(kRank, count);
    std::vector<std::vector<float>> columns;  // of the root
    std::vector<double> left(count);
    std::vector<double> importance(count);
    for (size_t i = 0; i < count; ++i) importance[i] = std::pow(at.weights[i], kImportance);
    for (size_t i = 0; i < count; ++i) left[i] = covarianceOf(at.nodes[i], at.nodes[i]);
    std::vector<double> known(count);
    while (columns.size() < rank_) {
        size_t pivot = 0;
        for (size_t i = 1; i < count; ++i)
            if (left[i] * importance[i] > left[pivot] * importance[pivot]) pivot = i;
        known.assign(count, 0.0);
        for (const std::vector<float>& column : columns) {
            const auto ofPivot = double(column[pivot]);
            for (size_t i = 0; i < count; ++i) known[i] += double(column[i]) * ofPivot;
        }
        const double scale = 1.0 / std::sqrt(left[pivot]);
        std::vector<float>& column = columns.emplace_back(count);
        for (size_t i = 0; i < count; ++i) {
            const double covariance = covarianceOf(at.nodes[i], at.nodes[pivot]);
            column[i] = static_cast<float>((covariance - known[i]) * scale);
        }
        column[pivot] = static_cast<float>(1.0 / scale);
        for (size_t i = 0; i < count; ++i)
            left[i] = std::max(0.0, left[i] - double(column[i]) * double(column[i]));
        left[pivot] = 0.0;
    }
    root_.resize(count * rank_);
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < rank_; ++k)
            root_[i * rank_ + k] = columns[k][i] * static_cast<float>(at.weights[i]);
}

Projected LobeDictionary::project(const std::vector<double>& values) const
{
    Projected result(rank_, 0.0f);
    for (size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<float>(values[i]);
        if (value == 0.0f) continue;
        const float* const row = &root_[i * rank_];
        for (size_t k = 0; k < rank_; ++k) result[k] += value * row[k];
    }
    return result;
}

Projected LobeDictionary::lobe(double level, double tilt) const
{
    return project(lobeValues(level, tilt));
}

std::vector<double> LobeDictionary::lobeValues(double level, double tilt) const
{
    const MirrorQuadrature& at = quadrature_;
    const double angle = tilt * lobeWidth(level), s = std::sin(angle), c = std::cos(angle);
    std::vector<double> values(at.nodes.size());
    double sum = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] = lobeValue(at.nodes[i].x * s + at.nodes[i].z * c, level);
        sum += values[i] * at.weights[i];
    }
    for (double& value : values) value /= sum;
    return values;
}

Projected LobeDictionary::cosine(double theta) const
{
    const MirrorQuadrature& at = quadrature_;
    std::vector<double> values(at.nodes.size());
    double sum = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] = std::max(0.0, fromMirrorFrame(at.nodes[i], theta).z);
        sum += values[i] * at.weights[i];
    }
    for (double& value : values) value /= sum;
    return project(values);
}

}  // namespace fbrdf
