// AreaTruth.h - what a surface reflects of a light with a shape, by brute force in double: the sum
// over points of the light.
#pragma once
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Reflectance.h>
#include <fbrdf/plan/AreaLight.h>

#include <vector>

namespace fbrdf {

/// At least so many points of a light are visited; where the mirror direction of the view is within
/// an angle of it, the reflectance may change between neighbours, and `near` are.
struct AreaPoints {
    int far = 1024, near = 6400;  ///< >= 1
    double nearAngle = 20.0 * kDegree;
};

class AreaTruth {
public:
    /// Expects a valid light.
    explicit AreaTruth(const AreaLight& light, const AreaPoints& points = {});

    /// The radiance that leaves a point of a surface towards `viewer` (unit, world space, above the
    /// horizon of the frame): the integral of f L cos theta_i over what is seen of the light,
    /// windowed as the light is. Inside of a sphere or a tube the light comes from everywhere.
    Vec3d reflected(const Reflectance& f, const Vec3d& position, const ShadingFrame<double>& frame,
                    const Vec3d& viewer) const;

private:
    /// A piece of the surface; it shines along its normal.
    struct Piece {
        Vec3d position, normal;
        double area;
    };
    /// One of many directions around one, and the solid angle that it stands for.
    struct Incoming {
        Vec3d direction;
        double solidAngle;
    };
    std::vector<Piece> piecesOf(int count) const;
    std::vector<Incoming> incomingAt(const Vec3d& position, bool near) const;
    bool isNear(const Vec3d& position, const Vec3d& mirror) const;

    AreaLight light_;
    AreaPoints points_;
    Vec3d centre_;
    double extent_;
    std::vector<Piece> far_, near_;  ///< none for spheres, whose directions are known
};

}  // namespace fbrdf
