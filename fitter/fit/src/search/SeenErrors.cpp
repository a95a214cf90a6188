#include "search/SeenErrors.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Errors below a thousandth are not seen: a form that has none is no better.
constexpr double kUnseen = 1e-3;
constexpr double kBlackest = static_cast<double>(std::numeric_limits<float>::min());

double logOf(double value)
{
    return std::log(std::max(value, kBlackest));
}

double logOfError(double error)
{
    return std::isfinite(error) ? std::log(error + kUnseen)
                                : std::log(std::numeric_limits<double>::max());
}

/// Weighted squares of the differences in hue.
struct HueError {
    double squares = 0.0, weight = 0.0;

    void add(const Sample& sample, const Vec3f& fitted, const Vec3f& floor)
    {
        const double brightest =
            static_cast<double>(std::max({sample.f.x, sample.f.y, sample.f.z}) * sample.wi.z);
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < a; ++b) {
                if (!(sample.f[a] > floor[a]) || !(sample.f[b] > floor[b])) continue;
                const auto of = [](const Vec3f& v, int c) {
                    return logOf(static_cast<double>(v[c]));
                };
                const double apart =
                    of(fitted, a) - of(fitted, b) - of(sample.f, a) + of(sample.f, b);
                squares += brightest * brightest * apart * apart;
                weight += brightest * brightest;
            }
    }
    double rms() const { return weight > 0.0 ? std::sqrt(squares / weight) : 0.0; }
};

double orNothing(double error)
{
    return std::isnan(error) ? 0.0 : error;  // no sample has such an error
}

}  // namespace

SeenErrors seenErrors(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
                      const Vec3f& floor)
{
    FBRDF_ASSERT(samples.size(), ==, fitted.size());
    const SampleErrors errors = sampleErrors(samples, fitted, floor);
    HueError hue;
    for (size_t i = 0; i < samples.size(); ++i) hue.add(samples[i], fitted[i], floor);
    return {orNothing(errors.logMedian), std::hypot(orNothing(errors.cosRms), hue.rms()),
            orNothing(errors.cubeRootRms)};
}

double markOf(const SeenErrors& errors)
{
    return (logOfError(errors.body) + logOfError(errors.peak) + logOfError(errors.both)) / 3.0;
}

double markOf(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
              const Vec3f& floor, Metric metric)
{
    if (metric == Metric::log) return markOf(seenErrors(samples, fitted, floor));
    const SampleErrors errors = sampleErrors(samples, fitted, floor);
    return logOfError(
        orNothing(metric == Metric::cubeRoot ? errors.cubeRootRms : errors.nbrdfLoss));
}

double withPicture(double mark, double deltaE)
{
    constexpr double kJustSeen = 0.01;
    return 0.75 * mark + 0.25 * logOfError(kJustSeen * deltaE);
}

double mostAbove(const SampleErrors& a, const SampleErrors& b)
{
    constexpr double kNothing = 1e-4;
    double most = 0.0;
    for (const auto error :
         {&SampleErrors::logMedian, &SampleErrors::cosRms, &SampleErrors::cubeRootRms})
        most = std::max(most, (a.*error + kNothing) / (b.*error + kNothing));
    return most;
}

}  // namespace fbrdf
