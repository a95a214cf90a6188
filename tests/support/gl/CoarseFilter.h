// CoarseFilter.h - a loader in whose contexts textures are filtered as a GPU does it: the place
// between two texels is rounded to a few bits. It changes the look-ups in the text of shaders.
#pragma once
#include <fbrdf/headless/Context.h>

namespace fbrdf::test {

/// bits: 0 to 16; 0 filters nothing. A later call for the same backend changes the bits of all.
HeadlessContext::Load coarselyFiltering(Backend backend, int bits);

}  // namespace fbrdf::test
