// CylinderProfile.h - the cross-section of the surface of Poulin and Fournier 1990: equal parallel
// cylinders, half sunk into a plane or cut out of it, and the parts of it that a direction sees.
//
// The cylinders run along x; the section lies in the y-z plane and repeats along y. Lengths are in
// cylinder radii. Points of an arc are named by psi, the angle at the cylinder's centre between the
// vertical and the point: (sin psi, cos psi) added, (sin psi, -cos psi) cut out. A direction enters
// by gamma = atan2(w.y, w.z), its angle in the section, |gamma| < pi/2.
#pragma once
#include <algorithm>

namespace fbrdf {

struct Interval {
    double lower, upper;
    double length() const { return std::max(0.0, upper - lower); }
    Interval mirrored() const { return {-upper, -lower}; }
};
Interval intersection(const Interval& a, const Interval& b);

class CylinderProfile {
public:
    /// `height`: of the crest above the plane, (0, 1], or minus the depth of a groove, [-1, 0).
    /// `spacing`: between axes, in widths of an arc at the plane, >= 1.
    CylinderProfile(double height, double spacing);

    bool isGroove() const { return groove_; }
    double period() const { return period_; }
    double halfArc() const { return halfArc_; }      ///< psi of the arc's end
    double halfWidth() const { return halfWidth_; }  ///< y of the arc's end
    double floorWidth() const { return period_ - 2.0 * halfWidth_; }

    /// psi of the arc's points that see the direction: a connected piece, as no part overhangs.
    Interval visibleArc(double gamma) const;
    /// y of the plane's points that see it, measured from the middle between two arcs.
    Interval visibleFloor(double gamma) const;

private:
    bool facesWholeArc(double gamma) const;  ///< gamma >= 0
    Interval visibleCylinder(double gamma) const;
    Interval visibleGroove(double gamma) const;

    bool groove_;
    double halfArc_, halfWidth_, period_;
    double
        centre_;  ///< depth of a cylinder's centre below the plane (height above it, of a groove)
};

}  // namespace fbrdf
