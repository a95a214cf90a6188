// SurfaceRuns.h - passes that write the same surface one after the other, between which the surface
// is changed.
#pragma once
#include "NestedBin.h"
#include "Surfaces.h"

#include <fbrdf/plan/Plan.h>

#include <algorithm>
#include <set>

namespace osgFbrdf {

inline bool isOffscreen(const fbrdf::Pass& pass)
{
    return pass.writes != fbrdf::Surface::target;
}

inline bool needsSurfaces(const fbrdf::Plan& plan)
{
    return std::any_of(plan.passes.begin(), plan.passes.end(), isOffscreen);
}

/// Passes in runs that write the same surface; cullPass(i) culls one.
template <class CullPass>
void cullRuns(osgUtil::CullVisitor& visitor, const fbrdf::Plan& plan, Surfaces& surfaces,
              CullPass cullPass)
{
    std::set<fbrdf::Surface> cleared;
    for (size_t i = 0; i < plan.passes.size();) {
        const fbrdf::Surface writes = plan.passes[i].writes;
        NestedBin run(visitor, static_cast<int>(i) + 1);
        if (isOffscreen(plan.passes[i])) {
            const bool first = cleared.empty(), clears = cleared.insert(writes).second;
            run.setDrawCallback(new SurfaceDraw(surfaces, writes, clears, first));
        }
        for (; i < plan.passes.size() && plan.passes[i].writes == writes; ++i) cullPass(i);
    }
}

}  // namespace osgFbrdf
