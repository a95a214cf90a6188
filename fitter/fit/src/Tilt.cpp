#include "Tilt.h"

#include "forms/NamedForms.h"
#include "Quantize.h"
#include "solve/Solve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kLeast = 0.05 * kDegree;      // no highlight is narrow enough to show less
constexpr double kMost = 3.0 * kDegree;        // more is no accident of mounting
constexpr double kMostAStep = 0.5 * kDegree;   // a step is right only while highlights overlap
constexpr double kDifference = 0.1 * kDegree;  // of derivatives: less than a highlight is wide
constexpr double kWorthwhile = 0.8;            // of the cost without a tilt
constexpr int kMostSteps = 6;

double lengthOf(const Tilt& tilt)
{
    return std::hypot(tilt.x, tilt.y);
}

bool areOnBothSides(const std::vector<Sample>& samples)
{
    constexpr float kBeside = 0.01f;  // of the plane of incidence
    constexpr size_t kFewest = 50, kShare = 20;
    size_t left = 0, right = 0;
    for (const Sample& s : samples) {
        const float side = s.wi.x * s.wo.y - s.wi.y * s.wo.x;
        if (side > kBeside) ++left;
        if (side < -kBeside) ++right;
    }
    return std::min(left, right) >= std::max(kFewest, samples.size() / kShare);
}

// An isotropic form fitted without robust weights, to which a highlight that lies somewhere else is
// an outlier.
Material isotropicFit(const std::vector<Sample>& samples, const DataStatistics& statistics,
                      const FitOptions& options)
{
    const Form form = makeFormFor("hdio", samples.size(), 0, Storage::float32);
    const LeastSquares problem(form, datasetInMemory(samples), statistics, options.seed,
                               options.threads);
    return quantize(form, problem.layout(), solve(problem, {}).x, Storage::float32);
}

using Values = std::vector<Vec3f>;

/// log2 g at each sample under five tilts: the middle one, and those beside it along x and y.
struct Neighbourhood {
    Values middle, afterX, beforeX, afterY, beforeY;

    Neighbourhood(const Material& material, const std::vector<Sample>& samples, const Tilt& tilt,
                  int threads)
    {
        const auto at = [&](double x, double y) {
            std::vector<Sample> moved;
            for (const Sample& s : samples)
                moved.push_back(straightened(s, {tilt.x + x, tilt.y + y}));
            Values values = evaluateAt(material, moved, threads);
            for (Vec3f& v : values) v = glm::log2(v);  // -infinity below the horizon
            return values;
        };
        middle = at(0, 0);
        afterX = at(kDifference, 0);
        beforeX = at(-kDifference, 0);
        afterY = at(0, kDifference);
        beforeY = at(0, -kDifference);
    }
};

/// Sums over samples of the least squares in the two numbers of a tilt.
struct TiltEquations {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0, squares = 0, weight = 0;

    void add(double w, double residual, double byX, double byY)
    {
        if (!std::isfinite(residual) || !std::isfinite(byX) || !std::isfinite(byY)) return;
        xx += w * byX * byX;
        xy += w * byX * byY;
        yy += w * byY * byY;
        x += w * byX * residual;
        y += w * byY * residual;
        squares += w * residual * residual;
        weight += w;
    }
    double cost() const { return weight > 0.0 ? squares / weight : 0.0; }
    /// No longer than kMostAStep; none where the samples do not decide it.
    Tilt step() const
    {
        const double determinant = xx * yy - xy * xy;
        if (!(determinant > 1e-6 * xx * yy)) return {};
        const Tilt full{(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
        const double shorter = std::min(1.0, kMostAStep / std::max(lengthOf(full), 1e-12));
        return {shorter * full.x, shorter * full.y};
    }
};

// Gauss-Newton about a fit to the samples as a tilt has them.
TiltEquations equationsAt(const std::vector<Sample>& samples, const Tilt& tilt,
                          const DataStatistics& statistics, const FitOptions& options)
{
    const Material material = isotropicFit(straightened(samples, tilt), statistics, options);
    const Neighbourhood g(material, samples, tilt, options.threads);
    const auto slope = [](const Values& after, const Values& before, size_t i, int c) {
        return static_cast<double>(after[i][c] - before[i][c]) / (2.0 * kDifference);
    };
    TiltEquations sums;
    for (size_t i = 0; i < samples.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const Observed o =
                observe(samples[i].f[c], samples[i].wi.z, statistics, c, samples[i].weight);
            if (o.censored) continue;
            sums.add(static_cast<double>(o.weight),
                     static_cast<double>(std::log2(o.value) - g.middle[i][c]),
                     slope(g.afterX, g.beforeX, i, c), slope(g.afterY, g.beforeY, i, c));
        }
    return sums;
}

}  // namespace

std::optional<Tilt> tiltOf(const std::vector<Sample>& samples, const DataStatistics& statistics,
                           const FitOptions& options)
{
    if (!areOnBothSides(samples)) return std::nullopt;
    TiltEquations best = equationsAt(samples, {}, statistics, options);
    const double untilted = best.cost();
    Tilt tilt;
    for (int i = 0; i < kMostSteps; ++i) {
        const Tilt step = best.step(), next{tilt.x + step.x, tilt.y + step.y};
        if (lengthOf(step) < 0.2 * kLeast || lengthOf(next) > kMost) break;
        const TiltEquations equations = equationsAt(samples, next, statistics, options);
        if (!(equations.cost() < best.cost())) break;
        tilt = next;
        best = equations;
    }
    if (lengthOf(tilt) < kLeast || best.cost() > kWorthwhile * untilted) return std::nullopt;
    return tilt;
}

// Rodrigues' turn about (y, -x, 0) / |(x, y)|, which takes the tilted normal to n.
Sample straightened(Sample sample, const Tilt& tilt)
{
    const double sine = lengthOf(tilt);
    if (sine == 0.0) return sample;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const Vec3d axis(tilt.y / sine, -tilt.x / sine, 0.0);
    for (Vec3f* v : {&sample.wo, &sample.wi}) {
        const Vec3d w(*v);
        *v = Vec3f(glm::normalize(cosine * w + sine * glm::cross(axis, w) +
                                  (1.0 - cosine) * glm::dot(axis, w) * axis));
    }
    return sample;
}

std::vector<Sample> straightened(const std::vector<Sample>& samples, const Tilt& tilt)
{
    // Values were divided by the cosine about the wrong normal.
    const auto isNear = [](float cosine, float other) {
        return cosine > 0.5f * other && cosine < 2.0f * other;
    };
    std::vector<Sample> result;
    for (const Sample& s : samples) {
        const Sample turned = straightened(s, tilt);
        if (isNear(turned.wo.z, s.wo.z) && isNear(turned.wi.z, s.wi.z)) result.push_back(turned);
    }
    return result;
}

}  // namespace fbrdf
