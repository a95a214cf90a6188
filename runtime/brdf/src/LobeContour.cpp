#include <fbrdf/brdf/LobeContour.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

template <class T>
Vec2<T> inverseSquareRoots(const Vec2<T>& v)
{
    return {T(1) / std::sqrt(v.x), T(1) / std::sqrt(v.y)};
}

}  // namespace

template <class T>
LevelMixture<T> levelMixture(T level)
{
    const T clamped = std::clamp(level, T(0), T(kCosineLevel)),
            lower = std::min(std::floor(clamped), T(kCosineLevel - 1));
    const T squared = std::exp2(T(2) * (lower - T(kCosineLevel))), fraction = clamped - lower;
    return {{squared, T(4) * squared}, {T(1) - fraction, fraction}};
}

template <class T>
T angleOverSine(T cosine)
{
    // Fitted to acos(c) / sqrt(1 - c^2) on [0, 1] by weighted least squares; beyond 90 degrees the
    // angle is pi less that of -c.
    const T c = std::min(std::abs(cosine), T(1));
    const T ratio =
        (T(1.570796268) + c * (T(1.100158696) + c * (T(0.0568270455) - c * T(0.00338514545)))) /
        (T(1) + c * (T(1.336998785) + c * T(0.387398181)));
    if (cosine >= T(0)) return ratio;
    // An edge that passes through the point itself has no direction: 1e-12 keeps it finite.
    return T(kPi) / std::sqrt(std::max(T(1) - c * c, T(1e-12))) - ratio;
}

template <class T>
Vec2<T> lobeEdge(const Vec3<T>& axis, const Vec2<T>& squaredWidth, const Vec3<T>& a,
                 const Vec3<T>& b)
{
    // Along the axis and across it: the stretch changes the ratio of the two alone.
    const T alongA = glm::dot(axis, a), alongB = glm::dot(axis, b);
    const Vec3<T> acrossA = a - alongA * axis, acrossB = b - alongB * axis;
    const Vec2<T> lengths = (glm::dot(acrossA, acrossA) + squaredWidth * (alongA * alongA)) *
                            (glm::dot(acrossB, acrossB) + squaredWidth * (alongB * alongB));
    const Vec2<T> inverse = inverseSquareRoots(glm::max(lengths, Vec2<T>(T(1e-30))));
    const Vec2<T> cosine =
        (glm::dot(acrossA, acrossB) + squaredWidth * (alongA * alongB)) * inverse;
    const T turn = glm::dot(axis, glm::cross(acrossA, acrossB));
    return turn * inverse * Vec2<T>(angleOverSine(cosine.x), angleOverSine(cosine.y));
}

template <class T>
Vec2<T> lobeInCap(const Vec2<T>& squaredWidth, T cosine, T squaredSine)
{
    // The cone of the cap, (c d)^2 - cos^2 |d|^2 > 0, in the plane of axis and centre: xx across
    // the axis, zz along it. It has one positive and one negative eigenvalue.
    const T z2 = cosine * cosine, x2 = T(1) - z2, cosine2 = T(1) - squaredSine;
    const Vec2<T> xx = squaredWidth * (squaredSine - z2);
    const T zz = squaredSine - x2;
    const Vec2<T> negated = squaredWidth * (squaredSine * cosine2);  // the determinant, negated
    const Vec2<T> trace = xx + zz;
    const Vec2<T> gap = glm::sqrt(trace * trace + T(4) * negated);
    // The root that does not cancel.
    const auto root = [](T sum, T difference, T product) {
        return sum > T(0) ? T(0.5) * (sum + difference) : T(2) * product / (difference - sum);
    };
    const Vec2<T> positive(root(trace.x, gap.x, negated.x), root(trace.y, gap.y, negated.y));
    const Vec2<T> lean = (positive - xx) / (positive + squaredWidth * cosine2);
    return (cosine > T(0) ? T(1) : T(-1)) * positive / gap * glm::sqrt(lean);
}

template struct LevelMixture<float>;
template struct LevelMixture<double>;
template LevelMixture<float> levelMixture(float);
template LevelMixture<double> levelMixture(double);
template float angleOverSine(float);
template double angleOverSine(double);
template Vec2<float> lobeEdge(const Vec3<float>&, const Vec2<float>&, const Vec3<float>&,
                              const Vec3<float>&);
template Vec2<double> lobeEdge(const Vec3<double>&, const Vec2<double>&, const Vec3<double>&,
                               const Vec3<double>&);
template Vec2<float> lobeInCap(const Vec2<float>&, float, float);
template Vec2<double> lobeInCap(const Vec2<double>&, double, double);

}  // namespace fbrdf
