// LobeSampling.h - directions in proportion to what a material reflects, drawn from its lobes: for
// importance sampling. The density is that of a mixture of stretched cosines, so it is known
// exactly and positive wherever a lobe reaches; the cosine about the normal reaches all of the
// upper half.
#pragma once
#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf {

template <class T>
struct SampledDirection {
    Vec3<T> wi{T(0)};  ///< unit, local frame; may be below the horizon, where f is 0
    T pdf = T(0);      ///< 1/sr, as lobePdf
};

/// u in [0, 1)^2. Expects a table that validate accepts and is not empty, and a unit wo above the
/// horizon. A material that reflects nothing is sampled by the cosine. The first number chooses
/// a lobe, and what is left of it the direction, so even numbers give even directions.
template <class T>
SampledDirection<T> sampleLobes(const LobeTable& table, const Vec3<T>& wo, const Vec2<T>& u);

/// The density in 1/sr, over the whole sphere, with which sampleLobes draws wi.
template <class T>
T lobePdf(const LobeTable& table, const Vec3<T>& wo, const Vec3<T>& wi);

}  // namespace fbrdf
