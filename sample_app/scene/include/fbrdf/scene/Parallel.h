// Parallel.h - a loop over independent items on all cores.
#pragma once
#include <functional>

namespace fbrdf::scene {

/// Calls body(i) once for every i in [0, count), on `threads` threads (0: one a core). The first
/// exception of a body is thrown again here, after all threads have ended.
void parallelFor(int count, int threads, const std::function<void(int)>& body);

}  // namespace fbrdf::scene
