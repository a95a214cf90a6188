#include "PolarPanels.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

// Views of the plane in degrees: even steps, and fine ones where highlights and retro-reflection
// are.
std::vector<double> viewAngles(double theta_i)
{
    std::vector<double> angles;
    for (double a = -89.0; a <= 89.0; a += 1.0) angles.push_back(a);
    for (const double peak : {-theta_i, theta_i})
        for (double a = peak - 5.0; a <= peak + 5.0; a += 0.2)
            if (std::abs(a) < 89.5) angles.push_back(a);
    std::sort(angles.begin(), angles.end());
    return angles;
}

template <class Brdf>
std::vector<PolarPoint> curve(double theta_i, double azimuth, const Brdf& brdf)
{
    const Vec3d wi = directionFromAngles(theta_i * kDegree, azimuth * kDegree);
    std::vector<PolarPoint> points;
    for (const double theta_o : viewAngles(theta_i)) {
        // Positive angles point away from the light: azimuth + 180 degrees.
        const Vec3d wo = directionFromAngles(-theta_o * kDegree, azimuth * kDegree);
        points.push_back({theta_o, brdf(wo, wi)});
    }
    return points;
}

std::vector<PolarPoint> fittedCurve(double theta_i, double azimuth, const Material& material)
{
    return curve(theta_i, azimuth, [&](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(material, wo, wi);
    });
}

// A sample near a plane of incidence that contains the normal.
struct InPlane {
    double theta_i, theta_o;  ///< degrees, theta_o signed as in PolarPoint
    bool across;              ///< the light is nearer to the plane of s than to that of t
    double offAzimuth;        ///< of the plane from t or s, degrees
    Vec3d f;
    bool isNear;
};

InPlane inPlane(const Sample& sample)
{
    const Vec3d wi(sample.wi), wo(sample.wo);
    const double sideways = std::hypot(wi.x, wi.y);
    // Light along the normal has no azimuth. The plane is then that of the view, with +x on its
    // positive side.
    const Vec3d leader = sideways > 1e-3 ? wi : (wo.x > 0.0 ? -wo : wo);
    const double length = std::hypot(leader.x, leader.y);
    const double x = length > 1e-9 ? leader.x / length : 1.0,
                 y = length > 1e-9 ? leader.y / length : 0.0;
    const double along = wo.x * x + wo.y * y, across = wo.y * x - wo.x * y;
    InPlane result{};
    result.theta_i = std::acos(std::min(1.0, wi.z)) / kDegree;
    result.theta_o = std::atan2(-along, wo.z) / kDegree;
    result.across = std::abs(y) > std::abs(x);
    result.offAzimuth = std::asin(std::min(std::abs(x), std::abs(y))) / kDegree;
    result.f = Vec3d(sample.f);
    result.isNear = std::abs(across) < std::sin(kPlaneTolerance * kDegree);
    return result;
}

std::vector<InPlane> samplesInPlane(const ComparisonSet& set)
{
    std::vector<InPlane> result;
    for (const Sample& s : set.samples) {
        const InPlane sample = inPlane(s);
        if (sample.isNear) result.push_back(sample);
    }
    return result;
}

bool isAt(const InPlane& sample, double theta_i)
{
    return std::abs(sample.theta_i - theta_i) <= kIncidenceTolerance;
}

// The incidences, at least 10 degrees apart, near which most samples are; at most four, sorted.
std::vector<double> richestIncidences(const std::vector<InPlane>& samples)
{
    constexpr size_t kPanels = 4;
    constexpr double kApart = 10.0;
    constexpr size_t kFewest = 3;
    std::vector<std::pair<size_t, double>> candidates;
    for (double theta_i = 0.0; theta_i < 90.0; theta_i += 1.0) {
        const auto count = std::count_if(samples.begin(), samples.end(),
                                         [&](const InPlane& s) { return isAt(s, theta_i); });
        candidates.emplace_back(static_cast<size_t>(count), theta_i);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<double> chosen;
    for (const auto& [count, theta_i] : candidates) {
        const bool isFar = std::all_of(chosen.begin(), chosen.end(), [at = theta_i](double other) {
            return std::abs(other - at) >= kApart;
        });
        if (count >= kFewest && isFar && chosen.size() < kPanels) chosen.push_back(theta_i);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

PolarPanel scatteredPanel(const std::vector<InPlane>& samples, double near, double azimuth,
                          const Material& material)
{
    std::vector<PolarPoint> points;
    double sum = 0.0;
    for (const InPlane& s : samples) {
        if (!isAt(s, near)) continue;
        points.push_back({s.theta_o, s.f});
        sum += s.theta_i;
    }
    PolarPanel panel;
    panel.scattered = true;
    panel.samples = points.size();
    panel.theta_i = sum / static_cast<double>(points.size());
    panel.azimuth = azimuth;
    const size_t shown = std::min(points.size(), kDotsShown);
    for (size_t i = 0; i < shown; ++i) panel.data.push_back(points[i * points.size() / shown]);
    panel.fit = fittedCurve(panel.theta_i, azimuth, material);
    return panel;
}

std::vector<PolarPanel> scatteredPanels(const Source& source, const Material& material,
                                        const ComparisonSet& set)
{
    const std::vector<InPlane> all = samplesInPlane(set);
    std::vector<PolarPanel> panels;
    for (const bool across : {false, true}) {
        std::vector<InPlane> samples;
        for (const InPlane& s : all)
            if (source.isotropic ? !across : s.across == across && s.offAzimuth <= kPlaneTolerance)
                samples.push_back(s);
        for (const double theta_i : richestIncidences(samples))
            panels.push_back(scatteredPanel(samples, theta_i, across ? 90.0 : 0.0, material));
    }
    return panels;
}

}  // namespace

std::vector<PolarPanel> polarPanels(const Source& source, const Material& material,
                                    const ComparisonSet& set)
{
    if (!source.evaluate) return scatteredPanels(source, material, set);
    std::vector<PolarPanel> panels;
    for (const double azimuth : {0.0, 90.0}) {
        if (azimuth > 0.0 && source.isotropic) continue;
        for (const double theta_i : {10.0, 30.0, 50.0, 70.0}) {
            PolarPanel panel;
            panel.theta_i = theta_i;
            panel.azimuth = azimuth;
            panel.data = curve(theta_i, azimuth, source.evaluate);
            panel.samples = panel.data.size();
            panel.fit = fittedCurve(theta_i, azimuth, material);
            panels.push_back(panel);
        }
    }
    return panels;
}

}  // namespace fbrdf
