// ShadingFrame.h - the local frame of a shaded point from an interpolated normal and tangent.
// Conventions: Conventions.h. Twin: fbrdfShadingFrame in frame.glsl, step by step.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <cmath>

namespace fbrdf {

/// Three orthonormal vectors, right-handed with s = n x t, or left-handed with s = -n x t where the
/// tangents of a mesh are mirrored. Local coordinates of w are (t.w, s.w, n.w).
template <class T>
struct ShadingFrame {
    Vec3<T> t, s, n;

    /// Local coordinates of w. Twin: fbrdfLocal in frame.glsl.
    Vec3<T> local(const Vec3<T>& w) const
    {
        return {glm::dot(t, w), glm::dot(s, w), glm::dot(n, w)};
    }
};

/// The frame whose normal is `normal` and whose tangent is `tangent` made orthogonal to it; neither
/// need be unit. A tangent that is zero or parallel to the normal gives a frame turned by some
/// arbitrary but fixed angle. handedness: negative where s = -n x t (glTF 2.0, 3.7.2.1, TANGENT).
template <class T>
ShadingFrame<T> shadingFrame(const Vec3<T>& normal, const Vec3<T>& tangent, T handedness = T(1))
{
    // Relative to |tangent|^2: what rounding leaves of a parallel tangent, squared, in float.
    constexpr T kParallel = T(1e-10);
    ShadingFrame<T> frame;
    frame.n = glm::normalize(normal);
    Vec3<T> t = tangent - frame.n * glm::dot(frame.n, tangent);
    if (!(glm::dot(t, t) > kParallel * glm::dot(tangent, tangent))) {
        const Vec3<T> axis =
            std::abs(frame.n.x) < T(0.5) ? Vec3<T>(T(1), T(0), T(0)) : Vec3<T>(T(0), T(1), T(0));
        t = axis - frame.n * glm::dot(frame.n, axis);
    }
    frame.t = glm::normalize(t);
    frame.s = handedness < T(0) ? glm::cross(frame.t, frame.n) : glm::cross(frame.n, frame.t);
    return frame;
}

/// The frame about `normal`, which is given in the coordinates of `frame` and need not be unit, as
/// a normal map stores it. The tangent changes as little as possible and the handedness stays; a
/// normal of 0 changes nothing. Twin: fbrdfPerturbed in frame.glsl.
template <class T>
ShadingFrame<T> perturbed(const ShadingFrame<T>& frame, const Vec3<T>& normal)
{
    if (!(glm::dot(normal, normal) > T(0))) return frame;
    const T handedness = glm::dot(glm::cross(frame.n, frame.t), frame.s);
    return shadingFrame(frame.t * normal.x + frame.s * normal.y + frame.n * normal.z, frame.t,
                        handedness);
}

}  // namespace fbrdf
