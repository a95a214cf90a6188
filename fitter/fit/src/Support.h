// Support.h - which texels the data say anything about.
#pragma once
#include "Feed.h"
#include "Traits.h"

#include <fbrdf/brdf/Material.h>

namespace fbrdf {

/// Sum of interpolation weights that supports a texel: a tenth of a sample that lies on it.
constexpr float kSupport = 0.1f;

/// Sets Table::unsupported of every table: reachable texels whose interpolation weights, summed
/// over the samples with a channel above the noise floor, stay at or below kSupport. A symmetric
/// table's mirrored texels share their sum. Reads no further than until every texel is supported.
void markUnsupported(Material& material, const Feed& feed, const DataTraits& traits, int threads);

}  // namespace fbrdf
