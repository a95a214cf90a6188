// Light.h - what lights a scene. Seed Eq. 2: a point light gives I / r^2, a directional one an
// irradiance.
#pragma once
#include <fbrdf/brdf/Conventions.h>

namespace fbrdf {

struct Light {
    enum class Type { point, directional } type = Type::point;
    Vec3f position{0.0f};   ///< world; a directional light: unit vector towards the light
    Vec3f intensity{1.0f};  ///< point: W/sr, falls off as 1 / r^2; directional: irradiance on a
                            ///< surface that faces it
    float radius = 0.0f;    ///< influence of a point light, windowed to 0 there; 0: unlimited
};

/// Irradiance factor at squared distance d2: 1 / d2, times the window (1 - (d2 / radius^2)^2)^2
/// when radius > 0 (Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9). Twin: fbrdfFalloff in
/// lights.glsl.
template <class T>
T falloff(T distanceSquared, T radius)
{
    T factor = T(1) / distanceSquared;
    if (radius > T(0)) {
        const T ratio = distanceSquared / (radius * radius);
        const T window = ratio < T(1) ? T(1) - ratio * ratio : T(0);
        factor *= window * window;
    }
    return factor;
}

}  // namespace fbrdf
