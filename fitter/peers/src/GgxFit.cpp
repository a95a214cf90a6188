#include <fbrdf/peers/GgxFit.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Parallel.h>

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Parameters as the solver sees them, free of bounds: logs of what is positive, the logit of f0.
//   log kd[3], then for each lobe: log scale[3], logit f0, log alpha, log (alphaY / alphaX) / 2
constexpr int kDiffuse = 3, kPerLobe = 6, kLogRatio = 5;
constexpr int kMaxLobes = 2;
constexpr double kLogScale = 10.0;     // of log1p: where a picture of a few lights begins to clip
constexpr size_t kStartSamples = 768;  // that all starts are tried on
constexpr int kStartSteps = 40, kFinalSteps = 60;
constexpr double kUnusable = std::numeric_limits<double>::infinity();
constexpr double kSmallest = 1e-6;  // of a colour at the start: its log must be finite

struct Geometry {
    Vec3d wo, wi, h;
    double sineSquared, schlick;
};

Geometry geometryOf(const Vec3d& wo, const Vec3d& wi)
{
    const Vec3d h = glm::normalize(wo + wi);
    return {wo, wi, h, h.x * h.x + h.y * h.y, std::pow(1.0 - std::min(1.0, glm::dot(wi, h)), 5.0)};
}

template <class T>
T lambda(const T& ax, const T& ay, const Vec3d& w)
{
    using std::sqrt;
    const T x = ax * w.x, y = ay * w.y;
    return 0.5 * (sqrt(1.0 + (x * x + y * y) / (w.z * w.z)) - 1.0);
}

/// D G2 / (4 cos cos) of one lobe.
template <class T>
T reflection(const T& ax, const T& ay, const Geometry& g)
{
    const T x = g.h.x / ax, y = g.h.y / ay;
    const T e = x * x + y * y + g.h.z * g.h.z;
    const T d = 1.0 / (kPi * ax * ay * e * e);
    return d / ((1.0 + lambda(ax, ay, g.wo) + lambda(ax, ay, g.wi)) * (4.0 * g.wo.z * g.wi.z));
}

/// The three channels of f at unbounded parameters.
template <class T>
std::array<T, 3> valueAt(const T* p, int lobes, const Geometry& g)
{
    using std::exp;
    std::array<T, 3> f;
    for (size_t c = 0; c < 3; ++c) f[c] = exp(p[c]) / kPi;
    for (int l = 0; l < lobes; ++l) {
        const T* q = p + kDiffuse + l * kPerLobe;
        const T f0 = 1.0 / (1.0 + exp(-q[3]));
        const T shape = (f0 + (1.0 - f0) * g.schlick) *
                        reflection(T(exp(q[4] - q[kLogRatio])), T(exp(q[4] + q[kLogRatio])), g);
        for (size_t c = 0; c < 3; ++c) f[c] += exp(q[c]) * shape;
    }
    return f;
}

template <class T>
T compressed(const T& x, GgxMetric metric)
{
    using std::cbrt;
    using std::log;
    return metric == GgxMetric::log1p ? T(log(1.0 + kLogScale * x)) : T(cbrt(x));
}

/// One sample's residuals.
template <int Lobes>
struct Residual {
    Geometry geometry;
    std::array<double, 3> target;  // phi(c f)
    double weight;
    GgxMetric metric;

    template <class T>
    bool operator()(const T* p, T* residual) const
    {
        const std::array<T, 3> f = valueAt(p, Lobes, geometry);
        for (size_t c = 0; c < 3; ++c)
            residual[c] = weight * (compressed(T(f[c] * geometry.wi.z), metric) - target[c]);
        return true;
    }
};

using Parameters = std::vector<double>;

struct Bounds {
    double lower, upper;
};

// A parameter without effect (the f0 of a lobe of scale 0) would run off, and so would the width of
// a mirror, which samples do not determine.
Bounds boundsOf(int parameter)
{
    if (parameter < kDiffuse) return {-20.0, 5.0};
    switch ((parameter - kDiffuse) % kPerLobe) {
        case 3: return {-8.0, 8.0};
        case 4: return {std::log(1e-3), std::log(2.0)};
        case kLogRatio: return {-3.0, 3.0};
        default: return {-20.0, 10.0};
    }
}

template <int Lobes>
Residual<Lobes> residualOf(const Sample& sample, GgxMetric metric)
{
    Residual<Lobes> residual{geometryOf(Vec3d(sample.wo), Vec3d(sample.wi)),
                             {},
                             std::sqrt(static_cast<double>(sample.weight)),
                             metric};
    for (int c = 0; c < 3; ++c)
        residual.target[static_cast<size_t>(c)] = compressed(
            residual.geometry.wi.z * std::max(0.0, static_cast<double>(sample.f[c])), metric);
    return residual;
}

/// Descends from `p` on every `stride`-th sample; returns the cost per sample.
template <int Lobes>
double descend(const std::vector<Sample>& samples, size_t stride, int steps,
               const GgxFitOptions& options, Parameters& p)
{
    constexpr int kSize = kDiffuse + Lobes * kPerLobe;
    ceres::Problem problem;
    size_t used = 0;
    for (size_t i = 0; i < samples.size(); i += stride, ++used)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<Residual<Lobes>, 3, kSize>(
                new Residual<Lobes>(residualOf<Lobes>(samples[i], options.metric))),
            nullptr, p.data());
    if (options.isotropic) {
        std::vector<int> fixed;
        for (int l = 0; l < Lobes; ++l) fixed.push_back(kDiffuse + l * kPerLobe + kLogRatio);
        problem.SetManifold(p.data(), new ceres::SubsetManifold(kSize, fixed));
    }
    for (int i = 0; i < kSize; ++i) {
        const Bounds bounds = boundsOf(i);
        problem.SetParameterLowerBound(p.data(), i, bounds.lower);
        problem.SetParameterUpperBound(p.data(), i, bounds.upper);
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    solver.max_num_iterations = steps;
    solver.num_threads = threadCount(options.threads);
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    return summary.IsSolutionUsable() ? summary.final_cost / static_cast<double>(used) : kUnusable;
}

// Value of each channel below which a tenth of the samples lie: what a Lambertian explains.
Vec3d lowValue(const std::vector<Sample>& samples)
{
    Vec3d low(0.0);
    for (int c = 0; c < 3; ++c) {
        std::vector<float> values;
        for (const Sample& s : samples) values.push_back(s.f[c]);
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 10);
        std::nth_element(values.begin(), at, values.end());
        low[c] = std::max(kSmallest, static_cast<double>(*at));
    }
    return low;
}

Parameters startAt(const std::vector<double>& alphas, double f0, const Vec3d& low)
{
    Parameters p;
    for (int c = 0; c < 3; ++c) p.push_back(std::log(kPi * low[c]));
    for (const double alpha : alphas) {
        p.insert(p.end(), {0.0, 0.0, 0.0});
        p.push_back(std::log(f0 / (1.0 - f0)));
        p.push_back(std::log(alpha));
        p.push_back(0.0);
    }
    return p;
}

std::vector<std::vector<double>> startRoughness(int lobes)
{
    if (lobes == 1) return {{0.02}, {0.06}, {0.15}, {0.4}};
    return {{0.01, 0.1}, {0.03, 0.2}, {0.08, 0.4}, {0.2, 0.8}};
}

GgxModel modelOf(const Parameters& p, int lobes)
{
    const auto colour = [&](size_t first) {
        return Vec3d(std::exp(p[first]), std::exp(p[first + 1]), std::exp(p[first + 2]));
    };
    GgxModel model;
    model.kd = colour(0);
    for (int l = 0; l < lobes; ++l) {
        const auto first = static_cast<size_t>(kDiffuse + l * kPerLobe);
        const double ratio = p[first + kLogRatio];
        model.lobes.push_back({colour(first), 1.0 / (1.0 + std::exp(-p[first + 3])),
                               std::exp(p[first + 4] - ratio), std::exp(p[first + 4] + ratio)});
    }
    return model;
}

template <int Lobes>
GgxModel fitLobes(const std::vector<Sample>& samples, const GgxFitOptions& options)
{
    const Vec3d low = lowValue(samples);
    const size_t stride = std::max<size_t>(1, samples.size() / kStartSamples);
    Parameters best;
    double bestCost = kUnusable;
    for (const double f0 : {0.05, 0.7})
        for (const auto& alphas : startRoughness(Lobes)) {
            options.watch.check();
            Parameters p = startAt(alphas, f0, low);
            const double cost = descend<Lobes>(samples, stride, kStartSteps, options, p);
            if (cost < bestCost) {
                bestCost = cost;
                best = p;
            }
        }
    if (best.empty())
        throw Error(ErrorKind::fit, "ggx", Found("no start that descends").expected("one"));
    descend<Lobes>(samples, 1, kFinalSteps, options, best);
    return modelOf(best, Lobes);
}

}  // namespace

GgxModel fitGgx(const std::vector<Sample>& samples, const GgxFitOptions& options)
{
    if (samples.empty())
        throw Error(ErrorKind::fit, "ggx", Found("no samples").expected("at least one"));
    if (options.lobes < 1 || options.lobes > kMaxLobes)
        throw Error(ErrorKind::usage, "lobes",
                    Found(std::to_string(options.lobes)).expected("1 or 2"));
    return options.lobes == 1 ? fitLobes<1>(samples, options) : fitLobes<2>(samples, options);
}

Vec3d evaluate(const GgxModel& model, const Vec3d& wo, const Vec3d& wi)
{
    if (!(wo.z > 0.0 && wi.z > 0.0)) return Vec3d(0.0);
    const Geometry g = geometryOf(wo, wi);
    Vec3d f = model.kd / kPi;
    for (const GgxLobe& lobe : model.lobes)
        f += lobe.scale *
             ((lobe.f0 + (1.0 - lobe.f0) * g.schlick) * reflection(lobe.alphaX, lobe.alphaY, g));
    return f;
}

std::string describe(const GgxModel& model)
{
    const auto colour = [](const Vec3d& v) {
        return numberText(v.x, 3) + "/" + numberText(v.y, 3) + "/" + numberText(v.z, 3);
    };
    std::string all = "kd " + colour(model.kd);
    for (const GgxLobe& lobe : model.lobes) {
        all += ", alpha " + numberText(lobe.alphaX, 3) + " x " + numberText(lobe.alphaY, 3) +
               " f0 " + numberText(lobe.f0, 3) + " scale " + colour(lobe.scale);
    }
    return all;
}

}  // namespace fbrdf
