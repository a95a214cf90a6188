#include "LeanHeap.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace fbrdf::viewer {

void keepHeapLean()
{
#ifdef __GLIBC__
    constexpr int kHeaps = 2, kLarge = 1 << 20;  // bytes
    mallopt(M_ARENA_MAX, kHeaps);
    mallopt(M_MMAP_THRESHOLD, kLarge);
    mallopt(M_TRIM_THRESHOLD, 4 * kLarge);
#endif
}

}  // namespace fbrdf::viewer
