// CoarseStore.h - a loader in whose contexts colours are stored as other drivers store them. It
// changes what shaders write, and so fits targets of bytes alone.
#pragma once
#include <fbrdf/headless/Context.h>

namespace fbrdf::test {

enum class ByteStore {
    truncated,  ///< towards 0: either neighbour is right (OpenGL 4.6, 2.3.5.2)
    viaHalves,  ///< to a half float before it is rounded, as drivers of GPUs do
    wrong,      ///< up to 1.06 steps below, which no driver may
};

/// Later calls of this or of coarselyFiltering for the same backend replace what it does.
HeadlessContext::Load coarselyStoring(Backend backend, ByteStore store);

}  // namespace fbrdf::test
