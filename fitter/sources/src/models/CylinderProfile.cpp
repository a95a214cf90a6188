#include "CylinderProfile.h"

#include <fbrdf/brdf/Conventions.h>

#include <cmath>

// Derivation, for gamma >= 0 (light from +y; the other side follows by reflection).
// Let q(p) = p . (-cos gamma, sin gamma): how far a point lies above the ray through the origin.
// A point is hidden by an obstacle towards +y when the obstacle's largest q exceeds its own.
//
// Cylinders: q(psi) = sin(gamma - psi) - centre sin gamma. While gamma <= pi/2 - halfArc the whole
// arc faces the direction and nothing stands higher. Above that the arc turns away at the
// terminator psi_t = gamma - pi/2, where its q is largest: 1 - centre sin gamma. The next
// cylinder's is that less period cos gamma, and of the ones after it less still. So the visible
// points have
//   psi = psi_t + t, t >= 0  and  cos t = sin(gamma - psi) >= 1 - period cos gamma,
// that is t <= 2 asin(sqrt(period cos gamma / 2)). On the plane q(y) = -y cos gamma.
//
// Grooves: q(psi) = centre sin gamma - sin(psi + gamma), the obstacle is the rim psi = halfArc, and
//   sin(psi + gamma) <= sin(halfArc + gamma),  that is  psi <= pi - halfArc - 2 gamma
// once halfArc + gamma > pi/2. The plane between grooves sees everything.

namespace fbrdf {

Interval intersection(const Interval& a, const Interval& b)
{
    return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

CylinderProfile::CylinderProfile(double height, double spacing)
    : groove_(height < 0.0),
      halfArc_(std::acos(1.0 - std::abs(height))),
      halfWidth_(std::sin(halfArc_)),
      period_(2.0 * halfWidth_ * spacing),
      centre_(1.0 - std::abs(height))
{
}

bool CylinderProfile::facesWholeArc(double gamma) const
{
    return gamma <= 0.5 * kPi - halfArc_;
}

Interval CylinderProfile::visibleCylinder(double gamma) const
{
    if (facesWholeArc(gamma)) return {-halfArc_, halfArc_};
    const double first = gamma - 0.5 * kPi;
    const double reach = 2.0 * std::asin(std::sqrt(std::min(1.0, 0.5 * period_ * std::cos(gamma))));
    return {first, std::min(halfArc_, first + reach)};
}

Interval CylinderProfile::visibleGroove(double gamma) const
{
    return {-halfArc_, std::min(halfArc_, kPi - halfArc_ - 2.0 * gamma)};
}

Interval CylinderProfile::visibleArc(double gamma) const
{
    if (gamma < 0.0) return visibleArc(-gamma).mirrored();
    return groove_ ? visibleGroove(gamma) : visibleCylinder(gamma);
}

Interval CylinderProfile::visibleFloor(double gamma) const
{
    if (gamma < 0.0) return visibleFloor(-gamma).mirrored();
    const double half = 0.5 * floorWidth();
    if (groove_ || facesWholeArc(gamma)) return {-half, half};
    const double highest = 1.0 - centre_ * std::sin(gamma);
    // y <= period - highest / cos gamma from the cylinder's axis, so from the middle:
    return {-half, std::min(half, 0.5 * period_ - highest / std::cos(gamma))};
}

}  // namespace fbrdf
