// Plan.h - from (form, number of lights, limits) to the list of passes that draws one object. Pure:
// no GL.
//
// p(wo) does not depend on the light, so it leaves the sum: L = s p(wo) sum_j q(h_j) p(wi_j)
// [n.wi_j] E_j, and `two-lookup` needs N + 1 passes for pqp, never 2 N + N.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>
#include <vector>

namespace fbrdf {

/// How lights are spread over passes. single: all in one; batched: lightsPerPass at a time;
/// twoLookup: one at a time, at most two look-ups in any pass.
enum class Technique { single, batched, twoLookup };

const char* techniqueName(Technique technique);        ///< "single", "batched", "two-lookup"
Technique techniqueFromName(const std::string& name);  ///< throws Error(usage)

}  // namespace fbrdf
