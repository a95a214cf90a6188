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

/// The half vector turned about the normal to azimuth 0, and the direction of the light as seen
/// from it: `half` is (sin theta_h, 0, cos theta_h), `difference` the unit vector at theta_d and
/// phi_d. No angle is computed on the way.
struct HalfDifferenceVectors {
    Vec3d half, difference;
};
HalfDifferenceVectors halfDifferenceVectors(const DirectionPair<double>& pair);

/// Angles of a pair. Azimuths whose direction coincides with its pole are 0.
HalfDifference halfDifferenceFromPair(const DirectionPair<double>& pair);

/// Inverse. The pair may lie below the horizon: not every combination of angles is a reflection.
DirectionPair<double> pairFromHalfDifference(const HalfDifference& angles);

/// Unit direction at zenith angle `theta` and azimuth `phi` (radians).
Vec3d directionFromAngles(double theta, double phi);

}  // namespace fbrdf
