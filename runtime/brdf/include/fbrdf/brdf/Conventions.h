// Conventions.h - the frame, the units and the symbols of every other header. Written once, here.
//
// Local frame: t, s, n = x, y, z with s = n x t; directions are unit and point away from the
// surface.
//   wi  to the light          wo  to the viewer          h = norm(wi + wo)
// f(wo, wi) is the BRDF in 1/sr, without the cosine; colours are linear RGB (Rec. 709 primaries).
// Angles are radians; degrees exist at the command line and in file formats that say so.
//   theta_i, theta_o  zenith angles of wi, wo
//   theta_h, phi_h    zenith and azimuth of h
//   theta_d, phi_d    wi in the frame turned so that h is the pole (Rusinkiewicz 1998)
// A pair with either direction at or below the horizon reflects nothing: f = 0.
// Tables hold log2 F unless their storage says linear (Table.h).
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace fbrdf {

template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;  ///< radians

/// Light and view direction of one evaluation: unit, local frame.
template <class T>
struct DirectionPair {
    Vec3<T> wo, wi;
};

}  // namespace fbrdf
