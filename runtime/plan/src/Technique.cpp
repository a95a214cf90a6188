#include <fbrdf/base/Error.h>
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

const char* techniqueName(Technique technique)
{
    switch (technique) {
        case Technique::single: return "single";
        case Technique::batched: return "batched";
        case Technique::twoLookup: return "two-lookup";
    }
    return "?";
}

Technique techniqueFromName(const std::string& name)
{
    for (const Technique t : {Technique::single, Technique::batched, Technique::twoLookup})
        if (name == techniqueName(t)) return t;
    throw Error(ErrorKind::usage, "technique",
                "found '" + name + "', expected single, batched or two-lookup");
}

const char* colourFormatName(ColourFormat format)
{
    switch (format) {
        case ColourFormat::rgba8: return "RGBA8";
        case ColourFormat::rgba16: return "RGBA16";
        case ColourFormat::rgba16f: return "RGBA16F";
        case ColourFormat::rgba32f: return "RGBA32F";
        case ColourFormat::other: return "other";
    }
    return "?";
}

void validate(const PlanRequest& request)
{
    const auto refuse = [](const std::string& what) {
        throw Error(ErrorKind::usage, "plan", what);
    };
    if (request.lights < 0)
        refuse("found " + std::to_string(request.lights) + " lights, expected 0 or more");
    if (request.lightsPerPass < 1)
        refuse("found " + std::to_string(request.lightsPerPass) +
               " lights a pass, expected 1 or more");
    if (request.maxLookups < 0)
        refuse("found a limit of " + std::to_string(request.maxLookups) +
               " look-ups, expected 0 (none) or more");
    if (!(request.recombination >= 0.0))
        refuse("found a recombination error of " + std::to_string(request.recombination) +
               ", expected 0 or more");
}

}  // namespace fbrdf
