#include "CoarseStore.h"

#include "ShaderRewriter.h"

namespace fbrdf::test {
namespace {

const char* storedValue(ByteStore store)
{
    switch (store) {
        case ByteStore::truncated: return "floor(255.0 * x) / 255.0";
        case ByteStore::viaHalves:
            // 2^-14 is the smallest normal half.
            return "floor(x / last + 0.5) * last";
        case ByteStore::wrong: return "max(floor(255.0 * x - 0.06), 0.0) / 255.0";
    }
    return "x";
}

}  // namespace

HeadlessContext::Load coarselyStoring(Backend backend, ByteStore store)
{
    return rewritingShaders(
        backend, afterMain("    vec3 x = clamp(fbrdfColour.rgb, 0.0, 1.0);\n"
                           "    vec3 last = exp2(floor(log2(max(x, 6.103515625e-5))) - 10.0);\n"
                           "    fbrdfColour.rgb = " +
                           std::string(storedValue(store)) + ";\n"));
}

}  // namespace fbrdf::test
