// Technique.h - how lights are spread over the passes that draw an object. The table below is the
// only list of techniques: planners, menus, command lines and tests read it, so a technique that
// differs in these limits alone is an enumerator and a row.
#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace fbrdf {

enum class Technique { single, batched, twoLookup };

/// How many lights a pass may take, as far as uniforms allow: all of them, the number that the
/// caller asks for (PlanRequest::lightsPerPass), or one.
enum class LightsPerPass { all, asRequested, one };

struct TechniqueInfo {
    Technique technique;
    const char* name;         ///< on command lines and in files
    const char* title;        ///< in menus and reports
    const char* description;  ///< a sentence without its full stop
    LightsPerPass lightsPerPass;
    int maxLookups;  ///< texture look-ups in any pass; 0: no limit
};

/// One row for each technique, in the order of the enumerators.
inline constexpr std::array<TechniqueInfo, 3> kTechniques{{
    {Technique::single, "single", "single pass", "All lights in one pass", LightsPerPass::all, 0},
    {Technique::batched, "batched", "batched", "A few lights in each pass",
     LightsPerPass::asRequested, 0},
    {Technique::twoLookup, "two-lookup", "two look-ups per pass",
     "One light and at most two texture look-ups in each pass", LightsPerPass::one, 2},
}};

constexpr int kTechniqueCount = static_cast<int>(kTechniques.size());

inline constexpr auto kTechniqueEnumerators = [] {
    std::array<Technique, kTechniques.size()> all{};
    for (size_t i = 0; i < all.size(); ++i) all[i] = kTechniques[i].technique;
    return all;
}();

constexpr const std::array<Technique, kTechniques.size()>& allTechniques()
{
    return kTechniqueEnumerators;
}

constexpr const TechniqueInfo& techniqueInfo(Technique technique)
{
    return kTechniques[static_cast<size_t>(technique)];
}

constexpr const char* techniqueName(Technique technique)
{
    return techniqueInfo(technique).name;
}

/// Throws Error(usage) that lists the names.
Technique techniqueFromName(const std::string& name);

/// "single, batched, two-lookup": every name, for messages and help.
std::string techniqueNames();

}  // namespace fbrdf
