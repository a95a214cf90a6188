// HalfDifference.h - Rusinkiewicz' half and difference angles of a pair, both ways.
// Conventions: Conventions.h. Reference: Rusinkiewicz 1998, "A New Change of Variables for
// Efficient BRDF Representation", section 3.
#pragma once
#include <fbrdf/brdf/Conventions.h>

namespace fbrdf {

/// theta_h, theta_d in [0, pi/2]; phi_h in (-pi, pi]; phi_d in (-pi, pi].
struct HalfDifference {
    double theta_h, phi_h, theta_d, phi_d;
};

/// Angles of a pair. Azimuths whose direction coincides with its pole are 0.
HalfDifference halfDifferenceFromPair(const DirectionPair<double>& pair);

/// Inverse. The pair may lie below the horizon: not every combination of angles is a reflection.
DirectionPair<double> pairFromHalfDifference(const HalfDifference& angles);

/// Unit direction at zenith angle `theta` and azimuth `phi` (radians).
Vec3d directionFromAngles(double theta, double phi);

}  // namespace fbrdf
