#include <fbrdf/peers/GgxSampling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr double kNarrowest = 1e-3;
constexpr int kWidths = 33;  // of the first search, from kNarrowest to 1
constexpr int kGolden = 16;  // steps of a search in one variable: to 5e-4 of its range
constexpr int kRounds = 3;   // over both widths
// Neither kind of direction may be missing: the other alone reaches not everywhere, or reaches it
// too seldom.
constexpr double kLeastShare = 1e-3;

/// The density of GGX alone: D G1 / (4 cos theta_o) (Heitz 2018, Eq. 17).
double ggxDensity(double alphaX, double alphaY, const Vec3d& wo, const Vec3d& wi)
{
    const Vec3d h = glm::normalize(wo + wi);
    const double x = h.x / alphaX, y = h.y / alphaY, e = x * x + y * y + h.z * h.z;
    const double d = 1.0 / (kPi * alphaX * alphaY * e * e);
    const double vx = alphaX * wo.x, vy = alphaY * wo.y;
    const double g1 = 2.0 / (1.0 + std::sqrt(1.0 + (vx * vx + vy * vy) / (wo.z * wo.z)));
    return d * g1 / (4.0 * wo.z);
}

/// The place in [low, high] of the least value of a function that has one minimum there.
template <class F>
double leastPlace(double low, double high, const F& value)
{
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double a = high - ratio * (high - low), b = low + ratio * (high - low);
    double atA = value(a), atB = value(b);
    for (int i = 0; i < kGolden; ++i)
        if (atA < atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - ratio * (high - low);
            atA = value(a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + ratio * (high - low);
            atB = value(b);
        }
    return 0.5 * (low + high);
}

/// Mean squares at two widths: at the best share, and with the best share of each view.
struct Trial {
    double share = 0.0, square = 0.0, freeSquare = 0.0;
};

class Trials {
public:
    explicit Trials(const ReflectedLight& light) : light_(light)
    {
        for (const ReflectedLight::View& view : light.views()) {
            densities_.emplace_back(view.nodes.size());
        }
    }

    Trial at(double alphaX, double alphaY)
    {
        for (size_t v = 0; v < densities_.size(); ++v) {
            const ReflectedLight::View& view = light_.views()[v];
            for (size_t i = 0; i < view.nodes.size(); ++i)
                densities_[v][i] = ggxDensity(alphaX, alphaY, view.wo, view.nodes[i].wi);
        }
        // The sum is convex in the share.
        Trial trial;
        trial.share = leastPlace(kLeastShare, 1.0 - kLeastShare, [&](double s) { return all(s); });
        trial.square = all(trial.share);
        for (size_t v = 0; v < densities_.size(); ++v)
            trial.freeSquare += of(
                v, leastPlace(kLeastShare, 1.0 - kLeastShare, [&](double s) { return of(v, s); }));
        return trial;
    }

private:
    double of(size_t v, double share) const
    {
        const ReflectedLight::View& view = light_.views()[v];
        double sum = 0.0;
        for (size_t i = 0; i < view.nodes.size(); ++i) {
            const ReflectedLight::Node& node = view.nodes[i];
            sum += node.solidAngle * node.square /
                   (share * densities_[v][i] + (1.0 - share) * node.wi.z / kPi);
        }
        return view.weight * sum;
    }
    double all(double share) const
    {
        double sum = 0.0;
        for (size_t v = 0; v < densities_.size(); ++v) sum += of(v, share);
        return sum;
    }

    const ReflectedLight& light_;
    std::vector<std::vector<double>> densities_;  ///< of GGX, at each node of each view
};

}  // namespace

double GgxSampling::density(const Vec3d& wo, const Vec3d& wi) const
{
    return highlight * ggxDensity(alphaX, alphaY, wo, wi) + (1.0 - highlight) * wi.z / kPi;
}

GgxSamplingFit bestGgxSampling(const ReflectedLight& light)
{
    Trials trials(light);
    double logX = 0.0, least = std::numeric_limits<double>::infinity(), leastFree = least;
    const double step = std::log(kNarrowest) / (kWidths - 1);
    // The deviation has several minima over the width: all are tried before one is refined.
    for (int i = 0; i < kWidths; ++i) {
        const Trial trial = trials.at(std::exp(i * step), std::exp(i * step));
        leastFree = std::min(leastFree, trial.freeSquare);
        if (trial.square < least) {
            least = trial.square;
            logX = i * step;
        }
    }
    double logY = logX;
    const auto squareAt = [&](double x, double y) {
        const Trial trial = trials.at(std::exp(x), std::exp(y));
        leastFree = std::min(leastFree, trial.freeSquare);
        return trial.square;
    };
    if (light.isIsotropic()) {
        logX = logY = leastPlace(logX + step, std::min(0.0, logX - step),
                                 [&](double x) { return squareAt(x, x); });
    } else {
        for (int round = 0; round < kRounds; ++round) {
            logX =
                leastPlace(std::log(kNarrowest), 0.0, [&](double x) { return squareAt(x, logY); });
            logY =
                leastPlace(std::log(kNarrowest), 0.0, [&](double y) { return squareAt(logX, y); });
        }
    }
    const Trial best = trials.at(std::exp(logX), std::exp(logY));
    GgxSamplingFit fit;
    fit.sampling = {std::exp(logX), std::exp(logY), best.share};
    fit.deviation = light.deviationOf(best.square);
    fit.deviationOfFreeShares = light.deviationOf(std::min(leastFree, best.freeSquare));
    return fit;
}

}  // namespace fbrdf
