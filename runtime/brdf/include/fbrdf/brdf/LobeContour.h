// LobeContour.h - how much of a lobe lies inside a region of directions: what a light with a shape
// sends into it. A stretched cosine is a linearly transformed one, so the integral over a spherical
// polygon is a sum over its edges, and over a cap a closed form (docs/method.md, Area lights).
#pragma once
#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf {

/// The two stretched cosines whose mixture is the lobe of a level (lobeValue).
template <class T>
struct LevelMixture {
    Vec2<T> squaredWidth;  ///< of the narrower and the wider one
    Vec2<T> share;         ///< add up to 1
};
/// level is clamped to 0 to 6. Twin: fbrdfLevelMixture.
template <class T>
LevelMixture<T> levelMixture(T level);

/// The angle over its sine of an angle whose cosine is given, relative error 4e-8: a rational
/// approximation, because acos has no digits left where the sine is small. Twin:
/// fbrdfAngleOverSine.
template <class T>
T angleOverSine(T cosine);

/// What the edge from a to b of a polygon of directions, not unit, adds to 2 pi times the integral
/// of both stretched cosines about the unit `axis`: Baum, Rushmeier, Winget 1989, "Improving
/// Radiosity Solutions Through the Use of Analytically Determined Form-Factors", Eq. 6, for the
/// directions that the inverse stretch maps to (Heitz et al. 2016, Eq. 5). No vertex may be more
/// than 90 degrees from the axis. Positive where the edge runs counterclockwise about the axis,
/// seen from outside of the sphere. Twin: fbrdfLobeEdge.
template <class T>
Vec2<T> lobeEdge(const Vec3<T>& axis, const Vec2<T>& squaredWidth, const Vec3<T>& a,
                 const Vec3<T>& b);

/// The integral of both over the cap of directions around one whose cosine to the axis is given.
/// squaredSine: of the cap's angular radius; the cap must end before 90 degrees from the axis.
/// The inverse stretch maps a cap to an elliptic cone, whose vector irradiance is along its axis
/// (Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading", section 4). Here the principal
/// axes are those of a symmetric 2 x 2 matrix, because the lobe is the same all around. Twin:
/// fbrdfLobeInCap.
template <class T>
Vec2<T> lobeInCap(const Vec2<T>& squaredWidth, T cosine, T squaredSine);

}  // namespace fbrdf
