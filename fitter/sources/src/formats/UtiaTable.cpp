#include "formats/UtiaTable.h"

#include "SampleRow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace fbrdf {
namespace {

constexpr size_t kThetas = 6, kPhis = 48;
constexpr double kThetaStep = 15.0, kPhiStep = 7.5;

/// Four neighbours of a direction in one axis pair of the table, and their weights.
struct Neighbours {
    std::array<size_t, 4> index{};
    std::array<double, 4> weight{};
};

Neighbours neighboursOf(const Vec3d& w, UtiaBeyond beyond)
{
    const double theta = std::acos(std::clamp(w.z, -1.0, 1.0)) * (180.0 / kPi) / kThetaStep;
    const double phi = std::atan2(w.y, w.x) * (180.0 / kPi) / kPhiStep;
    const double t = beyond == UtiaBeyond::kept ? std::min(theta, double(kThetas - 1)) : theta;
    const size_t low = std::min(static_cast<size_t>(t), kThetas - 2);
    const double turn = phi - std::floor(phi / double(kPhis)) * double(kPhis);
    const size_t first = static_cast<size_t>(turn) % kPhis, second = (first + 1) % kPhis;
    const double a = t - double(low), b = turn - std::floor(turn);
    return {{low * kPhis + first, low * kPhis + second, (low + 1) * kPhis + first,
             (low + 1) * kPhis + second},
            {(1 - a) * (1 - b), (1 - a) * b, a * (1 - b), a * b}};
}

Vec3d evaluateUtia(const std::vector<Vec3f>& cells, UtiaBeyond beyond, const Vec3d& wo,
                   const Vec3d& wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    const Neighbours light = neighboursOf(wi, beyond), view = neighboursOf(wo, beyond);
    Vec3d f(0.0);
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < 4; ++j)
            f += light.weight[i] * view.weight[j] *
                 Vec3d(cells[light.index[i] * kUtiaSide + view.index[j]]);
    for (int c = 0; c < 3; ++c) f[c] = std::isfinite(f[c]) ? std::max(f[c], 0.0) : 0.0;
    return f;
}

Vec3d directionOf(size_t index)
{
    return directionFromDegrees(double(index / kPhis) * kThetaStep,
                                double(index % kPhis) * kPhiStep);
}

SampleRow rowOf(const std::vector<Vec3f>& cells, size_t cell)
{
    const size_t light = cell / kUtiaSide, view = cell % kUtiaSide;
    const double weight =
        (light < kPhis ? 1.0 / double(kPhis) : 1.0) * (view < kPhis ? 1.0 / double(kPhis) : 1.0);
    return {directionOf(view), directionOf(light), Vec3d(cells[cell]), weight};
}

}  // namespace

Source makeUtiaSource(std::vector<Vec3f> cells, UtiaBeyond beyond)
{
    const auto table = std::make_shared<const std::vector<Vec3f>>(std::move(cells));
    Source source;
    source.description = "UTIA table, anisotropic, linear RGB, 1/sr";
    source.assumptions.emplace_back(beyond == UtiaBeyond::kept
                                        ? "beyond 75 degrees f is that at 75"
                                        : "beyond 75 degrees f goes on linearly");
    source.evaluate = [table, beyond](const Vec3d& wo, const Vec3d& wi) {
        return evaluateUtia(*table, beyond, wo, wi);
    };
    source.stream.rows = kUtiaCells;
    source.stream.geometry = "utia";
    source.stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                                 SampleReport& report) {
        for (uint64_t cell = first; cell < first + count; ++cell)
            addRow(rowOf(*table, size_t(cell)), samples, report);
    };
    return source;
}

}  // namespace fbrdf
