#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/plan/Plan.h>

namespace fbrdf {
namespace {

constexpr bool isInOrder()
{
    for (size_t i = 0; i < kTechniques.size(); ++i)
        if (kTechniques[i].technique != static_cast<Technique>(i)) return false;
    return true;
}
static_assert(isInOrder(), "techniqueInfo indexes the rows by enumerator");

}  // namespace

Technique techniqueFromName(const std::string& name)
{
    for (const TechniqueInfo& row : kTechniques)
        if (name == row.name) return row.technique;
    throw Error(ErrorKind::usage, "technique",
                Found("'" + name + "'").expected("one of " + techniqueNames()));
}

std::string techniqueNames()
{
    std::string names;
    for (const TechniqueInfo& row : kTechniques)
        names += std::string(names.empty() ? "" : ", ") + row.name;
    return names;
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
        refuse(Found(std::to_string(request.lights) + " lights").expected("0 or more"));
    if (request.lightsPerPass < 1)
        refuse(
            Found(std::to_string(request.lightsPerPass) + " lights a pass").expected("1 or more"));
    if (request.maxLookups < 0)
        refuse(Found("a limit of " + std::to_string(request.maxLookups) + " look-ups")
                   .expected("0 (none) or more"));
    if (request.environmentSamples < 0 ||
        (request.environmentSamples > 0 && !request.lobeLight.environment))
        refuse(Found(std::to_string(request.environmentSamples) + " directions" +
                     (request.lobeLight.environment ? "" : " without an environment"))
                   .expected("0 (none) or more of one"));
    if (request.lobeLight.areaLights < 0)
        refuse(Found(std::to_string(request.lobeLight.areaLights) + " area lights")
                   .expected("0 or more"));
    if (!request.lobeLight.isEmpty() && (request.lobes.lobes < 1 || request.lobes.knots() < 1))
        refuse(Found(std::to_string(request.lobes.lobes) + " lobes at " +
                     std::to_string(request.lobes.knots()) + " knots")
                   .expected("those of a table"));
    if (!(request.lobeError >= 0.0))
        refuse(
            Found("an error of lobes of " + numberText(request.lobeError)).expected("0 or more"));
    for (const double error : {request.maps.recombination, request.maps.filtering,
                               request.maps.absolute, request.maps.exponent})
        if (!(error >= 0.0))
            refuse(Found("an error of maps of " + numberText(error)).expected("0 or more"));
}

}  // namespace fbrdf
