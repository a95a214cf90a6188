// Light.h - what lights a scene. Seed Eq. 2: a point light gives I / r^2, a directional one an
// irradiance.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

struct Light {
    enum class Type { point, directional } type = Type::point;
    Vec3f position{0.0f};   ///< world; a directional light: vector towards the light
    Vec3f intensity{1.0f};  ///< point: W/sr, falls off as 1 / r^2; directional: irradiance on a
                            ///< surface that faces it
    float radius = 0.0f;    ///< influence of a point light, windowed to 0 there; 0: unlimited
};

/// True when every number is finite, the radius is not negative and a direction is not 0; others
/// light nothing and are reported as dropped.
inline bool isValid(const Light& light)
{
    const auto finite = [](const Vec3f& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const bool located = light.type == Light::Type::point || light.position != Vec3f(0.0f);
    return finite(light.position) && located && finite(light.intensity) &&
           std::isfinite(light.radius) && light.radius >= 0.0f;
}

/// Irradiance factor at squared distance d2: 1 / d2, times the window (1 - (d2 / radius^2)^2)^2
/// when radius > 0 (Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9). Deviation: d2 below
/// 1e-12 counts as 1e-12, so that a light on the surface stays finite. Twin: fbrdfFalloff in
/// lights.glsl.
template <class T>
T falloff(T distanceSquared, T radius)
{
    T factor = T(1) / std::max(distanceSquared, T(1e-12));
    if (radius > T(0)) {
        const T ratio = distanceSquared / (radius * radius);
        const T window = ratio < T(1) ? T(1) - ratio * ratio : T(0);
        factor *= window * window;
    }
    return factor;
}

}  // namespace fbrdf
