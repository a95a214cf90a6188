#include <fbrdf/fit/Fit.h>
#include <fbrdf/plan/Plan.h>

#include <limits>

namespace fbrdf {

int lookupsPerLight(const Form& form)
{
    int lookups = 0;
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors)
            if (!form.tables[static_cast<size_t>(factor.table)].uniform && dependsOnLight(factor))
                ++lookups;
    return lookups;
}

int lookupsPerPass(const Form& form)
{
    PlanRequest request;
    request.technique = Technique::batched;
    request.lights = 2;  // any number above 1: whether passes exist does not depend on it
    request.lightsPerPass = 1;
    request.offscreen = false;
    for (request.maxLookups = 1;; ++request.maxLookups)
        if (planPasses(form, request, {}).feasible()) return request.maxLookups;
}

}  // namespace fbrdf
