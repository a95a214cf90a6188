#include "Arguments.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Text.h>

#include <osgDB/FileNameUtils>

#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

namespace osgFbrdf {
namespace {

/// Names of techniques in options, with their indices: those of the runtime, and two of our own.
std::vector<std::pair<std::string, int>> techniqueIndices()
{
    std::vector<std::pair<std::string, int>> indices{{"auto", osgFX::Effect::AUTO_DETECT}};
    for (const fbrdf::Technique technique : fbrdf::allTechniques())
        indices.emplace_back(fbrdf::techniqueName(technique), static_cast<int>(technique));
    indices.emplace_back("diffuse", kDiffuseFallback);
    return indices;
}

bool setTechnique(FactorizedBrdf& effect, const std::string& name)
{
    for (const auto& [known, index] : techniqueIndices()) {
        if (known != name) continue;
        effect.selectTechnique(index);
        return true;
    }
    return false;
}

/// "technique=auto|single|...".
std::string techniqueOption()
{
    std::string option;
    for (const auto& known : techniqueIndices())
        option += (option.empty() ? "technique=" : "|") + known.first;
    return option;
}

bool setTransfer(FactorizedBrdf& effect, const std::string& name)
{
    static const std::map<std::string, fbrdf::Transfer> kTransfers{
        {"linear", fbrdf::Transfer::linear},
        {"srgb", fbrdf::Transfer::srgb},
        {"tone-map", fbrdf::Transfer::toneMap}};
    const auto found = kTransfers.find(name);
    if (found != kTransfers.end()) effect.setTransfer(found->second);
    return found != kTransfers.end();
}

/// True for a whole number not below `least`.
bool integer(const std::string& text, int least, int& value)
{
    char* end = nullptr;
    const long number = std::strtol(text.c_str(), &end, 10);
    value = static_cast<int>(number);
    return !text.empty() && *end == '\0' && number >= least && number <= 1000000;
}

bool applyOption(FactorizedBrdf& effect, const std::string& name, const std::string& text,
                 bool& known)
{
    int number = 0;
    if (name == "technique") return setTechnique(effect, text);
    if (name == "transfer") return setTransfer(effect, text);
    if (name == "exposure") {
        double value = 0.0;
        if (!fbrdf::parseNumber(text, value) || !(value >= 0.0)) return false;
        effect.setExposure(static_cast<float>(value));
    } else if (name == "lightsPerPass") {
        if (!integer(text, 1, number)) return false;
        effect.setLightsPerPass(number);
    } else if (name == "lookupsPerPass") {
        if (!integer(text, 0, number)) return false;
        effect.setLookupsPerPass(number);
    } else if (name == "firstTextureUnit") {
        if (!integer(text, 0, number)) return false;
        effect.setFirstTextureUnit(number);
    } else if (name == "floatTarget" || name == "derivedTangents" || name == "preciseFiltering" ||
               name == "reload") {
        if (text != "0" && text != "1") return false;
        if (name == "floatTarget") effect.setFloatTarget(text == "1");
        if (name == "derivedTangents") effect.setDerivedTangents(text == "1");
        if (name == "preciseFiltering") effect.setPreciseFiltering(text == "1");
        if (name == "reload") effect.setReloading(text == "1");
    } else {
        known = false;
    }
    return true;
}

}  // namespace

PseudoName pseudoName(const std::string& file)
{
    const std::string rest = osgDB::getNameLessExtension(file);
    if (!rest.empty() && rest.back() == ']') {
        const size_t open = rest.rfind(".[");
        if (open == std::string::npos || open == 0) return {};
        return {rest.substr(0, open), rest.substr(open + 2, rest.size() - open - 3)};
    }
    // A name is MODEL.EXT.NAME only where MODEL has an extension itself, or a material called
    // "a.b.fbrdf" would never be found.
    const std::string model = osgDB::getNameLessExtension(rest);
    if (model == rest || osgDB::getFileExtension(model).empty()) return {};
    return {model, osgDB::getFileExtension(rest) + ".fbrdf"};
}

std::string plainName(const std::string& file)
{
    const std::string rest = osgDB::getNameLessExtension(file);
    return rest == file || osgDB::getFileExtension(rest).empty() ? "" : rest;
}

std::vector<OptionText> optionTexts()
{
    return {{"exposure=<number>", "Multiplies radiance; default 1"},
            {techniqueOption(), "How lights are spread over passes; default auto"},
            {"lightsPerPass=<n>", "Lights in a pass of the technique batched; default 8"},
            {"lookupsPerPass=<n>",
             "The most texture look-ups in any pass; default 0: the limit of the technique"},
            {"firstTextureUnit=<n>", "The maps take this unit and those after it; default 0"},
            {"floatTarget=0|1", "1 where the colour buffer is RGBA32F; default 0"},
            {"derivedTangents=0|1", "1 derives tangents along texture coordinate s; default 0"},
            {"preciseFiltering=0|1", "1 filters maps in the shader, finer than a GPU; default 0"},
            {"transfer=linear|srgb|tone-map", "What is stored of the radiance; default linear"},
            {"reload=0|1", "1 reads the material again when its file changes; default 0"}};
}

std::vector<std::string> applyOptions(FactorizedBrdf& effect, const std::string& options)
{
    std::vector<std::string> problems;
    std::istringstream words(options);
    for (std::string word; words >> word;) {
        const size_t equals = word.find('=');
        if (equals == std::string::npos) continue;
        bool known = true;
        if (!applyOption(effect, word.substr(0, equals), word.substr(equals + 1), known))
            problems.push_back("option '" + word + "': found a value out of range");
    }
    return problems;
}

}  // namespace osgFbrdf
