// Definitions after the documentation of ALTA's class `params`; angles in radians. h is the half
// vector and d Rusinkiewicz' difference vector of V, whereas here d is that of the light. k is the
// half vector of V and the mirrored light R. Where a name leaves an azimuth open, light and view
// lie in the plane x, z.
#include "formats/AltaInputs.h"

#include "SampleRow.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <cmath>

namespace fbrdf {
namespace {

using Pair = DirectionPair<double>;

Pair fromHalf(double theta_h, double phi_h, double theta_d, double phi_d)
{
    const Pair pair = pairFromHalfDifference({theta_h, phi_h, theta_d, phi_d});
    return {pair.wi, pair.wo};
}

/// Zenith angle and azimuth as a point of the plane: (theta cos phi, theta sin phi).
Vec3d fromProjected(double x, double y)
{
    return directionFromAngles(std::hypot(x, y), std::atan2(y, x));
}

/// The unit vector above a point of the unit disc; not finite outside it.
Vec3d aboveDisc(double x, double y)
{
    return {x, y, std::sqrt(1.0 - x * x - y * y)};
}

Vec3d mirrored(const Vec3d& w)
{
    return {-w.x, -w.y, w.z};
}

/// The view whose half vector with the mirrored light is k.
Vec3d viewFromBack(const Vec3d& k, const Vec3d& light)
{
    const Vec3d r = mirrored(light);
    return 2.0 * glm::dot(r, k) * k - r;
}

/// The view at an angle from the light, at an azimuth about it that is 0 towards the normal.
Vec3d viewFromLight(double theta_l, double x, double y)
{
    const double angle = std::hypot(x, y), azimuth = std::atan2(y, x);
    const Vec3d light = directionFromAngles(theta_l, 0.0);
    const Vec3d up(-std::cos(theta_l), 0.0, std::sin(theta_l));
    return std::cos(angle) * light +
           std::sin(angle) * (std::cos(azimuth) * up + std::sin(azimuth) * Vec3d(0, 1, 0));
}

/// (L + V) / 2 = (x0, 0, hz) and (L - V) / 2 = b, perpendicular, of lengths whose squares sum to 1.
Pair fromStark(double x0, double length, double phi)
{
    const double hz = std::sqrt(1.0 - x0 * x0 - length * length);
    const Vec3d h(x0, 0.0, hz);
    const Vec3d across(hz * std::cos(phi), hz * std::sin(phi), -x0 * std::cos(phi));
    const double size = glm::length(across);
    const Vec3d b = size > 0.0 ? across * (length / size) : Vec3d(0.0, length, 0.0);
    return {h - b, h + b};
}

Pair fromNeumann(double x0, double x1, double phi)
{
    const double c = x1 * std::cos(phi), s = x1 * std::sin(phi);
    return {aboveDisc(x0 + c, s), aboveDisc(x0 - c, -s)};
}

/// Inverse of the stereographic projection from the lower pole.
Vec3d fromStereographic(double x, double y)
{
    const double square = x * x + y * y;
    return Vec3d(2.0 * x, 2.0 * y, 1.0 - square) / (1.0 + square);
}

constexpr Vec3d kNormal(0.0, 0.0, 1.0);

constexpr AltaInput kInputs[] = {
    {"COS_TH", 1, true, [](const double* x) { return fromHalf(std::acos(x[0]), 0, 0, 0); }},
    {"COS_TK", 1, true,
     [](const double* x) {
         const Vec3d k = directionFromAngles(std::acos(x[0]), kPi);
         return Pair{k, mirrored(k)};
     }},
    {"COS_TLV", 1, true,
     [](const double* x) {
         return Pair{directionFromAngles(std::acos(x[0]), 0), kNormal};
     }},
    {"COS_TLR", 1, true,
     [](const double* x) {
         return Pair{directionFromAngles(std::acos(x[0]), kPi), kNormal};
     }},
    {"COS_TH_TD", 2, true,
     [](const double* x) { return fromHalf(std::acos(x[0]), 0, std::acos(x[1]), 0); }},
    {"RUSIN_TH_TD", 2, true, [](const double* x) { return fromHalf(x[0], 0, x[1], kPi / 2); }},
    {"ISOTROPIC_TV_PROJ_DPHI", 2, true,
     [](const double* x) {
         return Pair{fromProjected(x[0], x[1]), kNormal};
     }},
    {"STARK_2D", 2, true, [](const double* x) { return fromStark(x[0], x[1], kPi / 2); }},
    {"NEUMANN_2D", 2, true, [](const double* x) { return fromNeumann(x[0], x[1], kPi / 2); }},
    {"RUSIN_TH_PH_TD", 3, false, [](const double* x) { return fromHalf(x[0], x[1], x[2], 0); }},
    {"RUSIN_TH_TD_PD", 3, true, [](const double* x) { return fromHalf(x[0], 0, x[1], x[2]); }},
    {"ISOTROPIC_TV_TL_DPHI", 3, true,
     [](const double* x) {
         return Pair{directionFromAngles(x[0], 0), directionFromAngles(x[1], x[2])};
     }},
    {"RUSIN_VH", 3, false,
     [](const double* x) {
         return Pair{{x[0], x[1], x[2]}, {x[0], x[1], x[2]}};
     }},
    {"SCHLICK_VK", 3, false,
     [](const double* x) {
         const Vec3d k(x[0], x[1], x[2]);
         return Pair{k, mirrored(k)};
     }},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", 3, true,
     [](const double* x) {
         return Pair{fromProjected(x[1], x[2]), directionFromAngles(x[0], 0)};
     }},
    {"SCHLICK_TL_TK_PROJ_DPHI", 3, true,
     [](const double* x) {
         const Vec3d light = directionFromAngles(x[0], 0);
         return Pair{viewFromBack(fromProjected(x[1], x[2]), light), light};
     }},
    {"RETRO_TL_TVL_PROJ_DPHI", 3, true,
     [](const double* x) {
         return Pair{viewFromLight(x[0], x[1], x[2]), directionFromAngles(x[0], 0)};
     }},
    {"STARK_3D", 3, true, [](const double* x) { return fromStark(x[0], x[1], x[2]); }},
    {"NEUMANN_3D", 3, true, [](const double* x) { return fromNeumann(x[0], x[1], x[2]); }},
    {"RUSIN_TH_PH_TD_PD", 4, false,
     [](const double* x) { return fromHalf(x[0], x[1], x[2], x[3]); }},
    {"SPHERICAL_TL_PL_TV_PV", 4, false,
     [](const double* x) {
         return Pair{directionFromAngles(x[2], x[3]), directionFromAngles(x[0], x[1])};
     }},
    {"STEREOGRAPHIC", 4, false,
     [](const double* x) {
         return Pair{fromStereographic(x[0], x[1]), fromStereographic(x[2], x[3])};
     }},
    {"CARTESIAN", 6, false,
     [](const double* x) {
         return Pair{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
     }},
};

}  // namespace

const AltaInput* altaInputNamed(const std::string& name, std::string& known)
{
    // ALTA's own table of names has the second for the first.
    const std::string wanted = name == "SCHLICK_VH" ? "SCHLICK_VK" : name;
    for (const AltaInput& input : kInputs) {
        if (wanted == input.name) return &input;
        known += std::string(known.empty() ? "" : ", ") + input.name;
    }
    return nullptr;
}

}  // namespace fbrdf
