// Reads the text of main(), in which every look-up of a program stands as one of the macros
// FBRDF_TEXTURE2, FBRDF_TEXTURE3, FBRDF_TEXTURE_CUBE, FBRDF_TEXTURE_CUBE_LEVEL and
// FBRDF_TEXTURE_PRECISE. No other function fetches but what the last one stands for, and, of the
// programs that draw directions of an environment, fbrdfEvaluate, which their loop calls.
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

/// Counts the fetches between two places of a text.
int fetchesBetween(const std::string& text, size_t begin, size_t end,
                   const std::vector<std::string>& samplers)
{
    int count = 0;
    for (size_t at = text.find("FBRDF_TEXTURE", begin); at < end;
         at = text.find("FBRDF_TEXTURE", at + 1))
        count +=
            static_cast<int>(std::count(samplers.begin(), samplers.end(), samplerAt(text, at)));
    return count;
}

}  // namespace

LookupCount countLookups(const std::string& fragmentSource,
                         const std::vector<std::string>& activeSamplers)
{
    LookupCount count;
    const size_t main = fragmentSource.find("void main()");
    if (main == std::string::npos) return count;
    const size_t end = fragmentSource.size();
    const size_t loop = std::min(fragmentSource.find("for (", main), end),
                 loopEnd = loop < end ? blockEnd(fragmentSource, loop) : end;
    const auto fetches = [&](size_t from, size_t to) {
        return fetchesBetween(fragmentSource, from, to, activeSamplers);
    };
    count.once = fetches(main, loop) + fetches(loopEnd, end);
    count.perLight = fetches(loop, loopEnd);
    const size_t evaluate = fragmentSource.find("vec3 fbrdfEvaluate(");
    if (fragmentSource.find("fbrdfEvaluate(", loop) < loopEnd && evaluate < main)
        count.perLight += fetches(evaluate, blockEnd(fragmentSource, evaluate));
    return count;
}

}  // namespace fbrdf
