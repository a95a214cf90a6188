#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

struct Polar {
    double theta, phi;
};

// atan2 keeps full precision at the pole, where acos(z) loses half of the digits.
Polar polarOf(const Vec3d& v)
{
    const double radius = std::hypot(v.x, v.y);
    return {std::atan2(radius, v.z), radius > 0.0 ? std::atan2(v.y, v.x) : 0.0};
}

Vec3d rotatedAboutZ(const Vec3d& v, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

Vec3d rotatedAboutY(const Vec3d& v, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

}  // namespace

Vec3d directionFromAngles(double theta, double phi)
{
    const double sine = std::sin(theta);
    return {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
}

HalfDifferenceVectors halfDifferenceVectors(const DirectionPair<double>& pair)
{
    const Vec3d sum = pair.wi + pair.wo;
    const double length = glm::length(sum);
    const Vec3d half = length > 0.0 ? sum / length : Vec3d(0.0, 0.0, 1.0);
    const double radius = std::sqrt(half.x * half.x + half.y * half.y);
    const double c = radius > 0.0 ? half.x / radius : 1.0, s = radius > 0.0 ? half.y / radius : 0.0;
    const Vec3d& wi = pair.wi;
    const double along = c * wi.x + s * wi.y;  // of wi, on the side of the half vector
    return {{radius, 0.0, half.z},
            {half.z * along - radius * wi.z, c * wi.y - s * wi.x,
             std::max(radius * along + half.z * wi.z, 0.0)}};
}

HalfDifference halfDifferenceFromPair(const DirectionPair<double>& pair)
{
    const Vec3d sum = pair.wi + pair.wo;
    const HalfDifferenceVectors vectors = halfDifferenceVectors(pair);
    const Polar d = polarOf(vectors.difference);
    const double phi_h = vectors.half.x > 0.0 ? std::atan2(sum.y, sum.x) : 0.0;
    return {std::atan2(vectors.half.x, vectors.half.z), phi_h, d.theta, d.phi};
}

DirectionPair<double> pairFromHalfDifference(const HalfDifference& a)
{
    const auto intoFrame = [&a](const Vec3d& v) {
        return rotatedAboutZ(rotatedAboutY(v, a.theta_h), a.phi_h);
    };
    const Vec3d d = directionFromAngles(a.theta_d, a.phi_d);
    return {intoFrame({-d.x, -d.y, d.z}), intoFrame(d)};
}

}  // namespace fbrdf
