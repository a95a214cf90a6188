// Planner.h - the passes that add up a form, within limits. Plan.cpp adds what follows the sum.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <limits>

namespace fbrdf {

struct Limits {
    static constexpr int kUnlimited = std::numeric_limits<int>::max();
    int lookups = kUnlimited;     ///< in any pass
    int lights = 1;               ///< in any pass, > 0
    int areaLights = kUnlimited;  ///< in any pass, > 0
    int vectors = kUnlimited;     ///< uniforms of lights and lobes in any pass
    bool offscreen = true;
};

struct ListedPasses {
    std::vector<Pass> passes;
    std::string reason;  ///< why there are no passes
};

/// The fewest passes. Expects a valid request with at least one light of any kind.
ListedPasses listPasses(const Form& form, const PlanRequest& request, const Limits& limits);

}  // namespace fbrdf
