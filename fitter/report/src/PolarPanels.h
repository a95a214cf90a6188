// PolarPanels.h - data and fit in planes of incidence, ready to be drawn.
#pragma once
#include "ComparisonSet.h"

#include <vector>

namespace fbrdf {

/// Reflectance towards one direction of the plane of incidence.
struct PolarPoint {
    /// Degrees; positive on the side of the mirror direction, negative on that of the light.
    double theta_o = 0;
    Vec3d f{0.0};  ///< 1/sr
};

struct PolarPanel {
    double theta_i = 0;  ///< degrees
    double azimuth = 0;  ///< of the light, degrees from the tangent
    std::vector<PolarPoint> fit, data;
    bool scattered = false;  ///< data are samples near the plane, not a curve
    size_t samples = 0;      ///< their number; `data` has at most kDotsShown of them
};

constexpr size_t kDotsShown = 400;
/// How far from the plane a sample is shown in it, and from its incidence, degrees.
constexpr double kPlaneTolerance = 5.0;
constexpr double kIncidenceTolerance = 2.0;

/// Curves where the source is a function: 10, 30, 50 and 70 degrees, along the tangent and, unless
/// the source is isotropic, across it. Otherwise the incidences at which most samples lie near the
/// plane; none when there is no such sample.
std::vector<PolarPanel> polarPanels(const Source& source, const Material& material,
                                    const ComparisonSet& set);

}  // namespace fbrdf
