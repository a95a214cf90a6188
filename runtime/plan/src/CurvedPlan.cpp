#include "CurvedPlan.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <iterator>

namespace fbrdf {

Plan curvedPlan(Plan plan, Transfer transfer, bool offscreen)
{
    FBRDF_ASSERT(plan.feasible(), ==, true);
    FBRDF_ASSERT(plan.passes.size(), >, size_t{0});
    const bool isSumElsewhere =
        std::none_of(plan.passes.begin(), std::prev(plan.passes.end()),
                     [](const Pass& pass) { return pass.writes == Surface::target; });
    if (isSumElsewhere) {
        plan.passes.back().transfer = transfer;
        return plan;
    }
    if (!offscreen) {
        Plan none;
        none.reason =
            "a sum of several passes before a curved output needs an offscreen surface, which this "
            "target cannot have";
        return none;
    }
    // All surfaces of the renderer share one depth buffer, which the first pass writes.
    for (Pass& pass : plan.passes) {
        if (pass.writes == Surface::target) pass.writes = Surface::sum;
        pass.depth = Depth::match;
    }
    plan.passes.front().depth = Depth::write;
    Pass last;
    last.parts = {{0, {}, false}};
    last.reads = Surface::sum;
    last.transfer = transfer;
    last.lookups = 1;
    plan.maxLookups = std::max(plan.maxLookups, last.lookups);
    plan.passes.push_back(std::move(last));
    return plan;
}

}  // namespace fbrdf
