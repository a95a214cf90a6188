#include "Lookups.h"

namespace fbrdf::tool {

int lookupsPerLight(const Form& form)
{
    int lookups = 0;
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors)
            if (dependsOnLight(factor) && !form.tables[static_cast<size_t>(factor.table)].uniform)
                ++lookups;
    return lookups;
}

}  // namespace fbrdf::tool
