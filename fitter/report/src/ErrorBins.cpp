#include "ErrorBins.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr size_t kBinCount = static_cast<size_t>(kErrorBins) * kErrorBins;

size_t binOf(const Sample& sample)
{
    const HalfDifference angles = halfDifferenceFromPair({Vec3d(sample.wo), Vec3d(sample.wi)});
    const double h = std::sqrt(angles.theta_h / (0.5 * kPi)), d = angles.theta_d / (0.5 * kPi);
    const auto index = [](double u) {
        return static_cast<size_t>(std::clamp(static_cast<int>(u * kErrorBins), 0, kErrorBins - 1));
    };
    return index(d) * kErrorBins + index(h);
}

double logError(double f, double g)
{
    const double error = std::abs(std::log(g / f));
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

double medianOf(std::vector<double>& values)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

double edgeOfThetaH(int i)
{
    return 90.0 * i * i / (kErrorBins * kErrorBins);
}

double edgeOfThetaD(int i)
{
    return 90.0 * i / kErrorBins;
}

ErrorBins errorBins(const ComparisonSet& set, const Vec3f& noiseFloor)
{
    ErrorBins result;
    result.bins.resize(kBinCount);
    std::vector<std::vector<double>> logs(kBinCount);
    double total = 0.0;
    for (size_t i = 0; i < set.samples.size(); ++i) {
        const size_t bin = binOf(set.samples[i]);
        const double cosine = static_cast<double>(set.samples[i].wi.z);
        ++result.bins[bin].samples;
        for (int c = 0; c < 3; ++c) {
            const double f = std::max(0.0, static_cast<double>(set.samples[i].f[c]));
            const double g = static_cast<double>(set.fitted[i][c]);
            if (f > static_cast<double>(noiseFloor[c])) logs[bin].push_back(logError(f, g));
            const double square = cosine * cosine * (g - f) * (g - f);
            result.bins[bin].share += square;
            total += square;
        }
    }
    for (size_t bin = 0; bin < kBinCount; ++bin) {
        result.bins[bin].median = medianOf(logs[bin]);
        if (total > 0.0) result.bins[bin].share /= total;
    }
    return result;
}

}  // namespace fbrdf
