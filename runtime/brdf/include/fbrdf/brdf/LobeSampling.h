// LobeSampling.h - directions in proportion to what a material reflects, drawn from its lobes: for
// importance sampling (docs/method.md, Sampling). The density is that of a mixture of stretched
// cosines, so it is known exactly and positive wherever a lobe reaches; the cosine about the normal
// reaches all of the upper half. The same functions for shaders: samplingFunctions, ShaderSource.h.
#pragma once
#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf {

/// The density of one view direction: the cosine about the normal, and for each lobe stretched
/// cosines of the two levels that it is between. Those are wider along the plane of incidence than
/// across it, as highlights are, which the lobes themselves are not. Twin: FbrdfLobeMixture.
template <class T>
struct LobeMixture {
    struct Part {
        /// A right-handed frame: y across the plane of wo and the axis, z the axis; unit, local.
        std::array<Vec3<T>, 3> axes{};
        std::array<Vec2<T>, 2> widths{};  ///< along x and y, of the lower and the upper level
        std::array<T, 2> shares{};        ///< >= 0
    };
    T cosine = T(1);  ///< its share, > 0; all shares add up to 1
    std::array<Part, kMostLobes> parts{};
    int count = 0;
};

template <class T>
struct SampledDirection {
    Vec3<T> wi{T(0)};  ///< unit, local frame; may be below the horizon, where f is 0
    T pdf = T(0);      ///< 1/sr, as lobePdf
};

/// Expects a table that validate accepts and is not empty, and a unit wo above the horizon. A
/// material that reflects nothing is sampled by the cosine. Twin: fbrdfLobeMixture.
template <class T>
LobeMixture<T> lobeMixture(const LobeTable& table, const Vec3<T>& wo);

/// u in [0, 1)^2. The first number chooses a cosine, and what is left of it the direction, so even
/// numbers give even directions. Twin: fbrdfSampleMixture.
template <class T>
SampledDirection<T> sampleMixture(const LobeMixture<T>& mixture, const Vec2<T>& u);

/// The density in 1/sr, over the whole sphere, with which sampleMixture draws wi. Twin:
/// fbrdfMixturePdf.
template <class T>
T mixturePdf(const LobeMixture<T>& mixture, const Vec3<T>& wi);

/// One direction: sampleMixture of lobeMixture. Twin: fbrdfSampleLobes.
template <class T>
SampledDirection<T> sampleLobes(const LobeTable& table, const Vec3<T>& wo, const Vec2<T>& u)
{
    return sampleMixture(lobeMixture(table, wo), u);
}

/// The density in 1/sr with which sampleLobes draws wi. Twin: fbrdfLobePdf.
template <class T>
T lobePdf(const LobeTable& table, const Vec3<T>& wo, const Vec3<T>& wi)
{
    return mixturePdf(lobeMixture(table, wo), wi);
}

}  // namespace fbrdf
