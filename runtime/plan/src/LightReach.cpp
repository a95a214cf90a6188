#include "LightReach.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

double influenceRadius(const LightVectors& light)
{
    FBRDF_ASSERT(light[0].w, >, 0.0f);
    return 1.0 / std::sqrt(static_cast<double>(light[0].w));
}

// The smallest sphere about a cone of half angle a whose sides are r long and whose end is round.
// Up to 45 degrees it touches apex and rim, with the radius r / (2 cos a); up to 90, its great
// circle is the rim, with the radius r sin a; beyond it is the whole sphere.
Reach reachOf(const LightVectors& light)
{
    // More than the shader's rounding of the angle between a direction and the axis.
    constexpr double kCosineMargin = 2e-6;
    const Vec3d position(light[0]), scaledAxis(light[2]);
    const double radius = influenceRadius(light), scale = glm::length(scaledAxis);
    const double outer = scale > 0.0 ? -static_cast<double>(light[2].w) / scale : -1.0,
                 cosine = std::min(outer - kCosineMargin, 1.0);
    if (cosine <= -1.0) return {position, radius};
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const Vec3d axis = scaledAxis / scale;
    if (cosine <= 0.0) return {position, radius, position, axis, cosine, sine};
    const bool isNarrow = cosine * cosine >= 0.5;
    const double along = isNarrow ? 0.5 * radius / cosine : radius * cosine;
    return {
        position + along * axis, isNarrow ? along : radius * sine, position, axis, cosine, sine};
}

}  // namespace fbrdf
