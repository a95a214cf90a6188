// PassWatch.h - what a renderer does, pass by pass: for hosts that show passes or time them.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <functional>
#include <string_view>

namespace fbrdf::gl {

/// A pass of an item, or of the objects of a batch that are drawn together.
struct PassEvent {
    std::string_view material;  ///< its name
    int index = 0, count = 0;   ///< of the passes of the item
    const Pass* pass = nullptr;
    int lookups = 0;  ///< texture look-ups that a fragment executes, counted from the program
};

/// Both are called by draws, while their state is set: a host may begin and end queries in them,
/// and touches no other state. They must not throw. Either may be empty.
struct PassWatch {
    std::function<void(const PassEvent&)> begins, ends;
};

}  // namespace fbrdf::gl
