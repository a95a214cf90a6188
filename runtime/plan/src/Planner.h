// Planner.h - the passes that add up a form, within limits; what comes after the sum is Plan.cpp's.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <limits>

namespace fbrdf {

struct Limits {
    static constexpr int kUnlimited = std::numeric_limits<int>::max();
    int lookups = kUnlimited;  ///< in a pass
    int lights = 1;            ///< in a pass
    bool offscreen = true;
};

struct ListedPasses {
    std::vector<Pass> passes;
    std::string reason;  ///< why there are none
};

/// The fewest passes. request: lights above 0, valid.
ListedPasses listPasses(const Form& form, const PlanRequest& request, const Limits& limits);

}  // namespace fbrdf
