// Reads the text of main(), in which every look-up of a program stands as one of the macros
// FBRDF_TEXTURE2, FBRDF_TEXTURE3, FBRDF_TEXTURE_CUBE, FBRDF_TEXTURE_CUBE_LEVEL and
// FBRDF_TEXTURE_PRECISE. No other function fetches but what the last one stands for.
#include <fbrdf/shaders/ShaderSource.h>

#include <algorithm>

namespace fbrdf {
namespace {

/// End of the block whose opening brace is at or after `from`.
size_t blockEnd(const std::string& text, size_t from)
{
    int depth = 0;
    for (size_t i = text.find('{', from); i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i;
    }
    return text.size();
}

std::string samplerAt(const std::string& text, size_t fetch)
{
    const size_t from = text.find('(', fetch) + 1;
    return text.substr(from, text.find(',', from) - from);
}

}  // namespace

LookupCount countLookups(const std::string& fragmentSource,
                         const std::vector<std::string>& activeSamplers)
{
    LookupCount count;
    const size_t start = fragmentSource.find("void main()");
    if (start == std::string::npos) return count;
    const std::string main = fragmentSource.substr(start);
    const size_t loop = main.find("for (");
    const size_t loopEnd = loop == std::string::npos ? loop : blockEnd(main, loop);
    for (size_t at = main.find("FBRDF_TEXTURE"); at != std::string::npos;
         at = main.find("FBRDF_TEXTURE", at + 1)) {
        const std::string sampler = samplerAt(main, at);
        if (std::find(activeSamplers.begin(), activeSamplers.end(), sampler) ==
            activeSamplers.end())
            continue;
        ++(loop != std::string::npos && at > loop && at < loopEnd ? count.perLight : count.once);
    }
    return count;
}

}  // namespace fbrdf
