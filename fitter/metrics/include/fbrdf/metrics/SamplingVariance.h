// SamplingVariance.h - how far one random direction is from the light that a material reflects: the
// variance of f cos theta_i / p in light that is 1 everywhere, by quadrature.
//
// The light that leaves towards wo is the mean of f(wo, wi) cos theta_i / p(wi) over directions wi
// drawn with the density p. The deviation is the root of that estimate's variance over the light
// itself, both as means over 12 angles theta_o, weighted as a sphere in parallel light shows them
// (cos theta_o sin theta_o), over four azimuths where the material is anisotropic, and over the
// channels. It falls with the root of the number of directions.
#pragma once
#include <fbrdf/environment/Reflectance.h>

#include <functional>
#include <vector>

namespace fbrdf {

/// What a material reflects to some view directions, on a fixed set of directions for each.
class ReflectedLight {
public:
    struct Node {
        Vec3d wi;
        double solidAngle;
        double square;  ///< of f cos theta_i: mean over channels
    };
    struct View {
        Vec3d wo;
        double weight;  ///< all add up to 1
        std::vector<Node> nodes;
        double square;  ///< of the light that leaves: mean over channels
    };

    /// Evaluates f at 12 x 9216 pairs, four times as many where it is anisotropic. Nodes are dense
    /// about the mirror direction. threads: 0: one a core.
    ReflectedLight(const Reflectance& f, bool isotropic, int threads);

    const std::vector<View>& views() const { return views_; }
    bool isIsotropic() const { return isotropic_; }

    /// density(wo, wi) in 1/sr, over the whole sphere: p, positive where f is. Infinite where f is
    /// not 0 and p is.
    double deviation(const std::function<double(const Vec3d& wo, const Vec3d& wi)>& density) const;
    /// From the mean of (f cos theta_i / p)^2 over wi, views and channels.
    double deviationOf(double meanSquare) const;

private:
    int threads_;
    bool isotropic_;
    std::vector<View> views_;
};

}  // namespace fbrdf
