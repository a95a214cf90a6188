#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/brdf/LobeContour.h>
#include <fbrdf/plan/AreaContour.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

template <class T>
T squared(const Vec3<T>& v)
{
    return glm::dot(v, v);
}

/// How far the points between the ends of an arc are moved out, so that the polygon has the area of
/// the sector: the root of (n - 3) r^2 + 2 r = 2 half / sin(step).
template <class T>
T bulgeOf(T half)
{
    const T spans = T(kArcPoints - 1), step = T(2) * half / spans;
    const T area = step > T(1e-3) ? T(2) * half / std::sin(step) : spans;
    return (std::sqrt(T(1) + T(kArcPoints - 3) * area) - T(1)) / T(kArcPoints - 3);
}

/// A circle or an ellipse as two halves, which share no point.
template <class T>
AreaContour<T> wholeCircle(const Vec3<T>& centre, const Vec3<T>& along, const Vec3<T>& across)
{
    constexpr int kPoints = kArcPoints - 1;  // of each half
    constexpr double kStep = kPi / kPoints;
    // The polygon has the area of the circle.
    static const T r = T(std::sqrt(kStep / std::sin(kStep)));
    AreaContour<T> contour;
    contour.centre = {centre, centre};
    contour.along = {r * along, -r * along};
    contour.across = {r * across, -r * across};
    contour.half = {T(0.5 * (kPoints - 1) * kStep), T(0.5 * (kPoints - 1) * kStep)};
    contour.bulge = {T(1), T(1)};
    contour.points = kPoints;
    return contour;
}

/// A sphere about `centre`, from which the point at 0 is farther than its radius.
template <class T>
AreaContour<T> sphereContour(const Vec3<T>& centre, T radius)
{
    const T squaredSine = radius * radius / squared(centre);
    const Vec3<T> axis = centre / std::sqrt(squared(centre));
    const auto axes = axesAbout(axis);
    const T sine = std::sqrt(squaredSine), cosine = std::sqrt(std::max(T(1) - squaredSine, T(0)));
    AreaContour<T> contour = wholeCircle(axis * cosine, axes[0] * sine, axes[1] * sine);
    contour.axis = axis;
    contour.squaredSine = squaredSine;
    return contour;
}

/// The hull of two spheres of one radius: arcs of both outlines, and the great circles that touch
/// them.
template <class T>
AreaContour<T> tubeContour(const Vec3<T>& a, const Vec3<T>& b, T radius)
{
    const T lengthA = std::sqrt(squared(a)), lengthB = std::sqrt(squared(b));
    const T sineA = radius / lengthA, sineB = radius / lengthB;
    const Vec3<T> axisA = a / lengthA, axisB = b / lengthB, normal = glm::cross(axisA, axisB);
    const T sine = std::sqrt(squared(normal)), cosine = glm::dot(axisA, axisB);
    const T cosineA = std::sqrt(T(1) - sineA * sineA), cosineB = std::sqrt(T(1) - sineB * sineB);
    // Where the great circle touches that goes around the other as well: that circle's pole is
    // 90 degrees and the angular radius from either axis.
    const T touchA = sineB - sineA * cosine, touchB = sineA - sineB * cosine;
    // One end covers the other.
    if (!(touchA > -cosineA * sine)) return sphereContour(a, radius);
    if (!(touchB > -cosineB * sine)) return sphereContour(b, radius);
    const Vec3<T> across = normal / sine;
    const T halfA = std::acos(std::clamp(touchA / (cosineA * sine), T(-1), T(1))),
            halfB = std::acos(std::clamp(touchB / (cosineB * sine), T(-1), T(1)));
    AreaContour<T> contour;
    contour.centre = {axisA * cosineA, axisB * cosineB};
    contour.along = {glm::cross(axisA, across) * sineA, glm::cross(across, axisB) * sineB};
    contour.across = {across * sineA, -across * sineB};
    contour.half = {halfA, halfB};
    contour.bulge = {bulgeOf(halfA), bulgeOf(halfB)};
    contour.points = kArcPoints;
    return contour;
}

template <class T>
AreaContour<T> facetContour(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& d)
{
    AreaContour<T> contour;
    contour.centre = {T(0.5) * (a + b), T(0.5) * (c + d)};
    contour.across = {T(0.5) * (b - a), T(0.5) * (d - c)};
    contour.along = {Vec3<T>(T(0)), Vec3<T>(T(0))};
    contour.half = {T(0.5 * kPi), T(0.5 * kPi)};
    contour.bulge = {T(1), T(1)};
    contour.points = 2;
    return contour;
}

/// The squared distance of 0 from a segment.
template <class T>
T squaredDistance(const Vec3<T>& a, const Vec3<T>& b)
{
    const Vec3<T> axis = b - a;
    const T along = std::clamp(-glm::dot(a, axis) / std::max(squared(axis), T(1e-30)), T(0), T(1));
    return squared(a + along * axis);
}

/// Where an outline passes through a plane. Of several such edges the steepest counts: rounding
/// may take a corner in the plane to the other side and back by edges that are next to nothing.
template <class T>
struct Crossing {
    Vec3<T> point{T(0)};
    T steepness = T(0);

    void meet(const Vec3<T>& other, T otherSteepness)
    {
        if (otherSteepness > steepness) *this = {other, otherSteepness};
    }
};

/// Cuts the edge from a to b where it passes through a plane, and remembers where the outline
/// leaves the upper half and comes back. Returns false where nothing is above. Twin: fbrdfCutEdge.
template <class T>
bool cutEdge(const Vec3<T>& n, Vec3<T>& a, Vec3<T>& b, Crossing<T>& leaves, Crossing<T>& enters)
{
    const T heightA = glm::dot(n, a), heightB = glm::dot(n, b);
    if (heightA <= T(0) && heightB <= T(0)) return false;
    const Vec3<T> crossing = a + (b - a) * (heightA / (heightA - heightB));
    // Corners in the plane count as below, so that what leaves also enters.
    if (heightA <= T(0)) {
        a = crossing;
        enters.meet(crossing, heightB - heightA);
    }
    if (heightB <= T(0)) {
        b = crossing;
        leaves.meet(crossing, heightA - heightB);
    }
    return true;
}

/// The outline cut by the horizon and by the equator of the lobe, edge by edge.
template <class T>
T lobeInOutline(const AreaContour<T>& contour, const Vec3<T>& n, const Vec3<T>& axis, T level)
{
    const LevelMixture<T> lobe = levelMixture(level);
    Crossing<T> leaves, enters, equatorLeaves, equatorEnters;
    Vec2<T> sum(T(0));
    const int count = 2 * contour.points;
    Vec3<T> last = contourPoint(contour, count - 1);
    // The last edge runs along the horizon.
    for (int i = 0; i <= count; ++i) {
        Vec3<T> a = last, b = enters.point;
        if (i < count) {
            b = last = contourPoint(contour, i);
            if (!cutEdge(n, a, b, leaves, enters)) continue;
        } else {
            a = leaves.point;
        }
        if (cutEdge(axis, a, b, equatorLeaves, equatorEnters))
            sum += lobeEdge(axis, lobe.squaredWidth, a, b);
    }
    sum += lobeEdge(axis, lobe.squaredWidth, equatorLeaves.point, equatorEnters.point);
    return std::abs(glm::dot(sum, lobe.share)) / T(2.0 * kPi);
}

}  // namespace

template <class T>
AreaContour<T> areaContour(const AreaVectors& light, const Vec3<T>& point)
{
    const auto kind = static_cast<AreaKind>(static_cast<int>(light[4].w) % kAreaKinds);
    const auto vector = [&light](size_t i) { return Vec3<T>(Vec3f(light[i])); };
    const Vec3<T> a = vector(1) - point;
    AreaContour<T> contour;
    if (kind == AreaKind::sphere || kind == AreaKind::tube) {
        const bool isTube = kind == AreaKind::tube;
        const Vec3<T> b = isTube ? vector(2) - point : a;
        const T radius = isTube ? T(light[3].x) : T(light[2].x);
        contour.isAround = squaredDistance(a, b) <= radius * radius;
        if (contour.isAround) return contour;
        return isTube ? tubeContour(a, b, radius) : sphereContour(a, radius);
    }
    if (kind == AreaKind::disc || kind == AreaKind::twoSidedDisc) {
        const Vec3<T> u = vector(2), v = vector(3);
        const T height = -glm::dot(glm::cross(u, v), a);
        const bool seen = kind == AreaKind::twoSidedDisc ? height != T(0) : height > T(0);
        return seen ? wholeCircle(a, u, v) : contour;
    }
    const Vec3<T> b = vector(2) - point, c = vector(3) - point, d = vector(4) - point;
    const T height = -glm::dot(glm::cross(c - a, d - b), a);
    const bool seen = kind == AreaKind::twoSidedFacet ? height != T(0) : height > T(0);
    return seen ? facetContour(a, b, c, d) : contour;
}

template <class T>
Vec3<T> contourPoint(const AreaContour<T>& contour, int i)
{
    const size_t arc = i < contour.points ? 0 : 1;
    const int place = arc == 0 ? i : i - contour.points, last = contour.points - 1;
    const T angle = contour.half[arc] * (T(2 * place) / T(last) - T(1));
    const T r = place == 0 || place == last ? T(1) : contour.bulge[arc];
    return contour.centre[arc] +
           r * (contour.along[arc] * std::cos(angle) + contour.across[arc] * std::sin(angle));
}

template <class T>
T lobeInArea(const AreaContour<T>& contour, const Vec3<T>& n, const Vec3<T>& axis, T level)
{
    if (contour.isAround) return T(1);
    if (contour.points == 0) return T(0);
    if (contour.squaredSine > T(0)) {
        const T sine = std::sqrt(contour.squaredSine), height = glm::dot(n, contour.axis),
                cosine = glm::dot(axis, contour.axis);
        if (height <= -sine) return T(0);
        // The whole circle is above the horizon and the equator.
        if (height > sine && cosine > sine) {
            const LevelMixture<T> lobe = levelMixture(level);
            return glm::dot(lobeInCap(lobe.squaredWidth, cosine, contour.squaredSine), lobe.share);
        }
    }
    return lobeInOutline(contour, n, axis, level);
}

template <class T>
Vec3<T> areaReflected(const LobeSum<T>& lobes, const ShadingFrame<T>& frame,
                      const AreaVectors& light, const Vec3<T>& point)
{
    const Vec3<T> toCentre = Vec3<T>(Vec3f(light[0])) - point;
    const T window = influenceWindow(squared(toCentre), T(light[0].w));
    if (!(window > T(0))) return Vec3<T>(T(0));
    const AreaContour<T> contour = areaContour(light, point);
    Vec3<T> sum = lobes.cosine * lobeInArea(contour, frame.n, frame.n, T(kCosineLevel));
    for (size_t k = 0; k < static_cast<size_t>(lobes.lobes); ++k) {
        const Vec3<T>& local = lobes.axis[k];
        const Vec3<T> axis = frame.t * local.x + frame.s * local.y + frame.n * local.z;
        sum += lobes.weight[k] * lobeInArea(contour, frame.n, axis, lobes.level[k]);
    }
    return sum * window * Vec3<T>(T(light[1].w), T(light[2].w), T(light[3].w));
}

template AreaContour<float> areaContour(const AreaVectors&, const Vec3<float>&);
template AreaContour<double> areaContour(const AreaVectors&, const Vec3<double>&);
template Vec3<float> contourPoint(const AreaContour<float>&, int);
template Vec3<double> contourPoint(const AreaContour<double>&, int);
template float lobeInArea(const AreaContour<float>&, const Vec3<float>&, const Vec3<float>&, float);
template double lobeInArea(const AreaContour<double>&, const Vec3<double>&, const Vec3<double>&,
                           double);
template Vec3<float> areaReflected(const LobeSum<float>&, const ShadingFrame<float>&,
                                   const AreaVectors&, const Vec3<float>&);
template Vec3<double> areaReflected(const LobeSum<double>&, const ShadingFrame<double>&,
                                    const AreaVectors&, const Vec3<double>&);

}  // namespace fbrdf
