#include "Arguments.h"

#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Percent.h>
#include <fbrdf/base/Text.h>

#include <osgDB/FileNameUtils>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace osgFbrdf {
namespace {

// More than any context has.
constexpr int kMostTextureUnits = 1024;

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

bool setAccumulation(FactorizedBrdf& effect, const std::string& name)
{
    for (const auto format : kAccumulationFormats) {
        if (name != fbrdf::colourFormatName(format)) continue;
        effect.setAccumulation(format);
        return true;
    }
    return false;
}

/// True for a whole number not below `least`.
bool integer(const std::string& text, int least, int& value)
{
    char* end = nullptr;
    const long number = std::strtol(text.c_str(), &end, 10);
    value = static_cast<int>(number);
    return !text.empty() && *end == '\0' && number >= least && number <= 1000000;
}

/// True for one unit, "3", or for several, "3-5".
bool addUnits(const std::string& text, std::set<int>& units)
{
    const size_t dash = text.find('-');
    int first = 0, last = 0;
    if (!integer(text.substr(0, dash), 0, first)) return false;
    if (!integer(dash == std::string::npos ? text : text.substr(dash + 1), first, last))
        return false;
    if (last >= kMostTextureUnits) return false;
    for (int unit = first; unit <= last; ++unit) units.insert(unit);
    return true;
}

/// True for units and ranges between commas, "0,11-14".
bool parseUnits(const std::string& text, std::set<int>& units)
{
    std::istringstream ranges(text + ",");
    for (std::string range; std::getline(ranges, range, ',');)
        if (!addUnits(range, units)) return false;
    return true;
}

/// True for names of others too.
bool applyTextureOption(FactorizedBrdf& effect, const std::string& name, const std::string& text)
{
    ModelTextures textures = effect.getModelTextures();
    for (const auto& [option, unit] :
         {std::pair("tintUnit", &textures.tint), std::pair("alphaUnit", &textures.alpha),
          std::pair("normalUnit", &textures.normal)})
        if (name == option && (!integer(text, 0, *unit) || *unit >= kMostTextureUnits))
            return false;
    if (name == "tint" && text != "diffuse" && text != "all") return false;
    if (name == "tint") textures.tintsAll = text == "all";
    if (!(textures == effect.getModelTextures())) effect.setModelTextures(textures);
    return true;
}

/// True for names of others too.
bool applyOption(FactorizedBrdf& effect, const std::string& name, const std::string& text)
{
    int number = 0;
    if (name == "technique") return setTechnique(effect, text);
    if (name == "transfer") return setTransfer(effect, text);
    if (name == "accumulation") return setAccumulation(effect, text);
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
    } else if (name == "freeTextureUnits") {
        std::set<int> units;
        if (!parseUnits(text, units)) return false;
        effect.setFreeTextureUnits(units);
    } else if (name == "floatTarget" || name == "derivedTangents" || name == "preciseFiltering" ||
               name == "reload") {
        if (text != "0" && text != "1") return false;
        if (name == "floatTarget") effect.setFloatTarget(text == "1");
        if (name == "derivedTangents") effect.setDerivedTangents(text == "1");
        if (name == "preciseFiltering") effect.setPreciseFiltering(text == "1");
        if (name == "reload") effect.setReloading(text == "1");
    }
    return applyTextureOption(effect, name, text);
}

/// Sets one property of an environment, whose picture is set last.
bool applyEnvironmentOption(EnvironmentLight& light, const std::string& name,
                            const std::string& text, std::string& picture)
{
    double value = 0.0;
    int lobes = 0;
    if (name == "environment") {
        picture = text;
        return !text.empty();
    }
    if (name == "environmentRotation") {
        if (!fbrdf::parseNumber(text, value)) return false;
        light.setRotation(static_cast<float>(value * osg::PI / 180.0));
    } else if (name == "environmentIntensity") {
        if (!fbrdf::parseNumber(text, value) || !(value >= 0.0)) return false;
        const auto factor = static_cast<float>(value);
        light.setIntensity({factor, factor, factor});
    } else if (name == "environmentLobes") {
        if (!integer(text, 0, lobes)) return false;
        light.setLobes(lobes);
    }
    return true;
}

/// Calls use with each NAME and VALUE of "NAME=VALUE NAME=VALUE", and returns what it refuses.
template <class Use>
std::vector<std::string> refusedOf(const std::string& options, Use use)
{
    std::vector<std::string> problems;
    std::istringstream words(options);
    for (std::string word; words >> word;) {
        const size_t equals = word.find('=');
        if (equals == std::string::npos) continue;
        if (!use(word.substr(0, equals), word.substr(equals + 1)))
            problems.push_back("option '" + word + "': found a value out of range");
    }
    return problems;
}

}  // namespace

MaterialTable materialTable(const std::string& text, std::vector<std::string>& problems)
{
    MaterialTable table;
    std::istringstream entries(text);
    for (std::string entry; std::getline(entries, entry, ',');) {
        const size_t colon = entry.find(':');
        const bool isPart = colon != std::string::npos;
        const std::string part = isPart ? fbrdf::percentDecoded(entry.substr(0, colon)) : "",
                          file = fbrdf::percentDecoded(isPart ? entry.substr(colon + 1) : entry);
        if (file.empty() || (isPart && part.empty()) || (!isPart && !table.rest.empty()))
            problems.push_back("materials '" + text + "': found '" + entry +
                               "', expected PART:FILE,PART:FILE,...");
        else if (isPart)
            table.parts.push_back({part, file});
        else
            table.rest = file;
    }
    return table;
}

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
            {"freeTextureUnits=<n>-<n>,...",
             "Units that the maps leave to others, such as 11-14; default none"},
            {"floatTarget=0|1", "1 where the colour buffer is RGBA32F; default 0"},
            {"accumulation=RGBA32F|RGBA16F|RGBA8",
             "The format of surfaces in which passes add up; default RGBA32F"},
            {"derivedTangents=0|1", "1 derives tangents along texture coordinate s; default 0"},
            {"preciseFiltering=0|1", "1 filters maps in the shader, finer than a GPU; default 0"},
            {"transfer=linear|srgb|tone-map", "What is stored of the radiance; default linear"},
            {"reload=0|1", "1 reads the material again when its file changes; default 0"},
            {"tintUnit=<n>", "Unit of the model's colours, and of its alpha; default none"},
            {"tint=diffuse|all", "What the colours multiply; default diffuse"},
            {"alphaUnit=<n>", "Unit of a texture whose red is the model's alpha; default none"},
            {"normalUnit=<n>", "Unit of the model's normal map; default none"},
            {"materials=<part>:<file>,...",
             "Materials of parts, by the names of nodes, state sets or osg::Materials; default "
             "none"},
            {"environment=<file>|studio|overcast|clear",
             "Light from everywhere: a picture of latitude and longitude, or a sky; default none"},
            {"environmentRotation=<degrees>", "Turns it about the vertical; default 0"},
            {"environmentIntensity=<number>", "Multiplies its radiance; default 1"},
            {"environmentLobes=<n>",
             "The most lobes by which a material reflects it; default 0: all that it has"}};
}

std::vector<std::string> applyOptions(FactorizedBrdf& effect, const std::string& options)
{
    return refusedOf(options, [&](const std::string& name, const std::string& text) {
        return applyOption(effect, name, text);
    });
}

std::vector<std::string> applyMaterials(FactorizedBrdf& effect, const std::string& name,
                                        const std::string& options, const osgDB::Options* paths)
{
    std::vector<std::string> problems;
    // A name without a colon is a file, whatever else is in it.
    std::vector<MaterialTable> tables{name.find(':') == name.npos ? MaterialTable{name, {}}
                                                                  : materialTable(name, problems)};
    refusedOf(options, [&](const std::string& option, const std::string& text) {
        if (option == "materials") tables.push_back(materialTable(text, problems));
        return true;
    });
    for (const MaterialTable& table : tables) {
        if (!table.rest.empty()) effect.setMaterialFile(table.rest, paths);
        for (const PartFile& part : table.parts)
            effect.setPartMaterialFile(part.part, part.file, paths);
    }
    return problems;
}

osg::ref_ptr<EnvironmentLight> environmentOf(const std::string& options,
                                             const osgDB::Options* paths,
                                             std::vector<std::string>& problems)
{
    osg::ref_ptr<EnvironmentLight> light = new EnvironmentLight;
    std::string picture;
    const auto refused = refusedOf(options, [&](const std::string& name, const std::string& text) {
        return applyEnvironmentOption(*light, name, text, picture);
    });
    problems.insert(problems.end(), refused.begin(), refused.end());
    if (picture.empty()) return nullptr;
    light->setPictureFile(picture, paths);
    return light;
}

}  // namespace osgFbrdf
