// LobeDictionary.h - the lobes that a fit chooses from, in the norm in which it measures errors.
// They lie about the mirror direction of wo, so that they are the same for every wo.
//
// The norm is the expected squared error of light under a random environment: F^T C F with the
// covariance C(g) = 2 + exp(-g / 0.7) + exp(-g / 0.1) of radiance at two directions that are g
// radians apart. Its shape follows the autocovariances of photographed environments.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace fbrdf {

/// A function over the sphere projected so that the dot product of two is their covariance.
using Projected = std::vector<float>;

double dot(const Projected& a, const Projected& b);

/// Nodes over the sphere of directions, folded at the plane of incidence (y >= 0), in the frame of
/// the mirror direction: z along it, x in the plane of incidence towards the normal.
struct MirrorQuadrature {
    std::vector<Vec3d> nodes;
    std::vector<double> weights;  ///< solid angles of both sides: they add up to 4 pi
};
/// A direction given in the frame of the mirror direction of wo, in the local frame; wo is in the
/// xz plane at theta_o.
Vec3d fromMirrorFrame(const Vec3d& direction, double theta);

class LobeDictionary {
public:
    /// Takes about as long as a fit.
    explicit LobeDictionary(int threads);

    const MirrorQuadrature& quadrature() const { return quadrature_; }

    size_t size() const { return levels_.size(); }
    float level(size_t atom) const { return levels_[atom]; }
    float tilt(size_t atom) const { return tilts_[atom]; }
    const Projected& projected(size_t atom) const { return projected_[atom]; }
    double product(size_t a, size_t b) const { return double(products_[a * size() + b]); }

    /// The projection of values at the nodes of the quadrature.
    Projected project(const std::vector<double>& values) const;
    /// The projection of any lobe, whose integral is 1.
    Projected lobe(double level, double tilt) const;
    /// The projection of the cosine about the normal, whose integral is 1.
    Projected cosine(double theta) const;

private:
    std::vector<double> lobeValues(double level, double tilt) const;
    void factorCovariance();

    MirrorQuadrature quadrature_;
    size_t rank_ = 0;
    std::vector<float> root_;  ///< nodes x rank: covariance ~ root root^T
    std::vector<float> levels_, tilts_;
    std::vector<Projected> projected_;
    std::vector<float> products_;
};

}  // namespace fbrdf
