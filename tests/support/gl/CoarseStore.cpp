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

std::string coarselyStored(std::string text, ByteStore store)
{
    const std::string main = "void main()";
    const size_t at = text.rfind(main);
    if (text.find("fbrdfColour = ") == std::string::npos || at == std::string::npos) return text;
    text.replace(at, main.size(), "void fbrdfWholeMain()");
    return text +
           "void main()\n{\n    fbrdfWholeMain();\n"
           "    vec3 x = clamp(fbrdfColour.rgb, 0.0, 1.0);\n"
           "    vec3 last = exp2(floor(log2(max(x, 6.103515625e-5))) - 10.0);\n"
           "    fbrdfColour.rgb = " +
           storedValue(store) + ";\n}\n";
}

}  // namespace

HeadlessContext::Load coarselyStoring(Backend backend, ByteStore store)
{
    return rewritingShaders(
        backend, [store](std::string text) { return coarselyStored(std::move(text), store); });
}

}  // namespace fbrdf::test
