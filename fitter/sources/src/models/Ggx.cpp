// Microfacets with the GGX (Trowbridge-Reitz) distribution over a Lambertian.
#include "Microfacet.h"

namespace fbrdf {

Model ggxModel()
{
    return {"ggx",
            "GGX microfacets and a Lambertian",
            "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces; "
            "anisotropic, height-correlated masking of Heitz 2014; Schlick 1994 Fresnel",
            microfacetParameters(),
            roughnessIsIsotropic,
            {"kd = 0", hasNoDiffusePart},
            microfacetsOverLambertian<ggxDistribution, ggxLambda>};
}

}  // namespace fbrdf
