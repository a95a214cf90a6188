// Light.h - what lights a scene (docs/method.md, Eq. 2): a point light causes an irradiance of
// I / r^2, a directional light one that is the same everywhere; a spot is a point light inside a
// cone.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

struct Light {
    enum class Type { point, directional, spot } type = Type::point;
    /// World space. For a directional light this is the vector towards the light.
    Vec3f position{0.0f};
    /// Point lights, and spots on their axis: W/sr, falls off as 1 / r^2. Directional lights: the
    /// irradiance on a surface that faces the light.
    Vec3f intensity{1.0f};
    /// A point light or spot reaches no farther: its light is windowed to 0 there. 0: unlimited.
    float radius = 0.0f;
    Vec3f axis{0.0f, 0.0f, -1.0f};  ///< spots shine along it; world space, not 0, need not be unit
    /// Radians from a spot's axis, 0 <= inner <= outer <= pi. Light is full inside the inner cone
    /// and 0 outside the outer one.
    float innerAngle = 0.0f, outerAngle = 0.785398f;
};

/// True when every number is finite, the radius is not negative, directions are not 0 and cones are
/// in range. Other lights light nothing and are reported as dropped.
inline bool isValid(const Light& light)
{
    const auto finite = [](const Vec3f& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const bool located = light.type != Light::Type::directional || light.position != Vec3f(0.0f);
    const bool aimed =
        light.type != Light::Type::spot ||
        (finite(light.axis) && light.axis != Vec3f(0.0f) && light.innerAngle >= 0.0f &&
         light.innerAngle <= light.outerAngle && light.outerAngle <= static_cast<float>(kPi));
    return finite(light.position) && located && finite(light.intensity) &&
           std::isfinite(light.radius) && light.radius >= 0.0f && aimed;
}

/// The window (1 - (d2 / radius^2)^2)^2 of a light that ends at a radius, at squared distance d2
/// (Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9); 0 beyond it. inverseRadiusSquared: 0
/// for an unlimited light, whose window is 1. Twin: fbrdfInfluenceWindow in lights.glsl.
template <class T>
T influenceWindow(T distanceSquared, T inverseRadiusSquared)
{
    const T ratio = distanceSquared * inverseRadiusSquared;
    const T window = std::max(T(1) - ratio * ratio, T(0));
    return window * window;
}

/// 1 / radius^2 as the window takes it; 0 for an unlimited light, whose radius is 0.
template <class T>
T inverseRadiusSquared(T radius)
{
    return radius > T(0) ? T(1) / (radius * radius) : T(0);
}

/// Irradiance factor at squared distance d2: 1 / d2 times the window. Deviation: d2 below 1e-12
/// counts as 1e-12, so that a light on the surface stays finite. Twin: fbrdfFalloff in lights.glsl,
/// which takes d2 and its inverse, and 1 / radius^2.
template <class T>
T falloff(T distanceSquared, T radius)
{
    return influenceWindow(distanceSquared, inverseRadiusSquared(radius)) /
           std::max(distanceSquared, T(1e-12));
}

/// A cone as (scale, offset): the factor of a spot is clamp(scale cos + offset, 0, 1)^2, with the
/// cosine between its axis and the direction from it (Khronos 2017, KHR_lights_punctual, "Inner and
/// Outer Cone Angles"). Deviation: an edge is at least 1e-4 wide in cosine, so that it stays
/// finite.
struct Cone {
    double scale = 0.0, offset = 1.0;
};

/// The cone of a spot; for other lights the cone whose factor is 1 everywhere.
inline Cone coneOf(const Light& light)
{
    if (light.type != Light::Type::spot) return {};
    const double inner = std::cos(static_cast<double>(light.innerAngle)),
                 outer = std::cos(static_cast<double>(light.outerAngle));
    const double scale = 1.0 / std::max(inner - outer, 1e-4);
    return {scale, -outer * scale};
}

/// Share of a spot's intensity that leaves it along -toLight, 1 on its axis; 1 for other lights.
/// toLight is unit. Twin: fbrdfConeFactor in lights.glsl, which takes the cone of LightVectors.h.
inline double coneFactor(const Light& light, const Vec3d& toLight)
{
    const Cone cone = coneOf(light);
    const double cosine = -glm::dot(glm::normalize(Vec3d(light.axis)), toLight);
    const double edge = std::clamp(cone.scale * cosine + cone.offset, 0.0, 1.0);
    return edge * edge;
}

}  // namespace fbrdf
