// RadialCovariance.h - the norm of LobeDictionary.h for lobes with any axes: covariances of
// radially symmetric functions depend on the angle between their axes alone, and are sums of
// Legendre polynomials.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <vector>

namespace fbrdf {

/// The covariance of radiance at two directions whose cosine is given: see LobeDictionary.h.
double radianceCovariance(double cosine);

class RadialCovariance {
public:
    RadialCovariance();

    /// Levels that lobes may have here: 0 to kCosineLevel in steps of kStep.
    static constexpr double kStep = 0.25;
    size_t levels() const { return direction_.size(); }

    /// Of a lobe and a single direction, of two lobes of one level, and of a lobe and the cosine.
    double withDirection(size_t level, double cosine) const
    {
        return at(direction_[level], cosine);
    }
    double withLobe(size_t level, double cosine) const { return at(lobe_[level], cosine); }
    double withCosine(size_t level, double cosine) const { return at(cosine_[level], cosine); }

private:
    using Radial = std::vector<float>;
    static double at(const Radial& table, double cosine);

    std::vector<Radial> direction_, lobe_, cosine_;
};

}  // namespace fbrdf
