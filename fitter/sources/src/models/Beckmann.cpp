// Microfacets with Beckmann's distribution (Gaussian slopes) over a Lambertian.
#include "Microfacet.h"

namespace fbrdf {

Model beckmannModel()
{
    return {"beckmann",
            "Beckmann microfacets and a Lambertian",
            "Cook and Torrance 1982, A Reflectance Model for Computer Graphics; anisotropic, "
            "height-correlated masking of Heitz 2014 (exact Lambda); Schlick 1994 Fresnel",
            microfacetParameters(),
            roughnessIsIsotropic,
            {"kd = 0", hasNoDiffusePart},
            microfacetsOverLambertian<beckmannDistribution, beckmannLambda>};
}

}  // namespace fbrdf
