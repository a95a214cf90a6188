#include "ReceivedShadows.h"

#include "InheritedState.h"
#include "SceneLights.h"

#include <fbrdf/base/Found.h>

#include <osgShadow/ParallelSplitShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ShadowTexture>
#include <osgShadow/SoftShadowMap>
#include <osgShadow/ViewDependentShadowMap>
#include <osgUtil/CullVisitor>

#include <algorithm>

namespace osgFbrdf {
namespace {

/// The scene nearest to where the visitor is; null where there is none.
osgShadow::ShadowedScene* shadowedSceneOf(osgUtil::CullVisitor& visitor)
{
    const osg::NodePath& path = visitor.getNodePath();
    for (auto node = path.rbegin(); node != path.rend(); ++node)
        if (auto* scene = dynamic_cast<osgShadow::ShadowedScene*>(*node)) return scene;
    return nullptr;
}

ShadowFilter filterOf(const osgShadow::ShadowTechnique* technique)
{
    if (dynamic_cast<const osgShadow::SoftShadowMap*>(technique)) return ShadowFilter::jittered;
    if (dynamic_cast<const osgShadow::ParallelSplitShadowMap*>(technique))
        return ShadowFilter::split;
    if (dynamic_cast<const osgShadow::ShadowTexture*>(technique)) return ShadowFilter::colour;
    return ShadowFilter::plain;
}

bool hasGeneratedCoordinates(const InheritedState& inherited, int unit)
{
    for (const GLenum mode :
         {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
        if (!inherited.textureMode(unit, mode).value_or(false)) return false;
    return true;
}

/// The texture where it is a shadow map of the kind.
const osg::Texture* mapAt(const InheritedState& inherited, int unit, ShadowFilter filter)
{
    const auto* texture = dynamic_cast<const osg::Texture*>(
        inherited.textureAttribute(unit, osg::StateAttribute::TEXTURE));
    if (!texture || !hasGeneratedCoordinates(inherited, unit)) return nullptr;
    const bool compares = texture->getShadowComparison();
    return compares == (filter != ShadowFilter::colour) ? texture : nullptr;
}

void add(ReceivedShadows& shadows, int unit, const osg::Texture* texture)
{
    shadows.maps.units.push_back(unit);
    shadows.textures.emplace_back(const_cast<osg::Texture*>(texture));
    shadows.unitsTaken.insert(unit);
}

void addThoseAbove(ReceivedShadows& shadows, const InheritedState& inherited)
{
    for (int unit = 0; unit < inherited.textureUnits(); ++unit)
        if (const osg::Texture* map = mapAt(inherited, unit, shadows.maps.filter))
            add(shadows, unit, map);
}

/// The maps that ViewDependentShadowMap may have: it sets them after the cull, one or more for each
/// light with a number of its own. State above has those of the last frame.
void addViewDependent(ReceivedShadows& shadows, const osgShadow::ShadowSettings& settings,
                      const SceneLights& scene)
{
    std::set<int> numbers;
    for (const PlacedOsgLight& source : scene.sources) numbers.insert(source.light->getLightNum());
    if (scene.viewNumber >= 0) numbers.insert(scene.viewNumber);
    const auto lights = settings.getLightNum() < 0 ? numbers.size() : size_t{1};
    const auto maps = static_cast<int>(lights * settings.getNumShadowMapsPerLight());
    for (int i = 0; i < maps; ++i)
        add(shadows, static_cast<int>(settings.getBaseShadowTextureUnit()) + i, nullptr);
}

std::string nameOf(const osgShadow::ShadowTechnique& technique)
{
    return std::string(technique.libraryName()) + "::" + technique.className();
}

}  // namespace

std::string ShadowMaps::key() const
{
    if (empty()) return "";
    std::string key = "s" + std::to_string(static_cast<int>(filter));
    for (const int unit : units) key += '.' + std::to_string(unit);
    return key;
}

ReceivedShadows withoutShadows(const std::string& whyNot)
{
    ReceivedShadows shadows;
    shadows.whyNot = whyNot;
    return shadows;
}

ReceivedShadows shadowsOver(osgUtil::CullVisitor& visitor, const InheritedState& inherited,
                            const SceneLights& scene)
{
    osgShadow::ShadowedScene* shadowed = shadowedSceneOf(visitor);
    const auto* technique = shadowed ? shadowed->getShadowTechnique() : nullptr;
    ReceivedShadows shadows;
    shadows.maps.filter = filterOf(technique);
    if (dynamic_cast<const osgShadow::ViewDependentShadowMap*>(technique))
        addViewDependent(shadows, *shadowed->getShadowSettings(), scene);
    else
        addThoseAbove(shadows, inherited);
    // Under ShadowTexture what casts shadows is drawn without the texture.
    const bool expectsMaps = technique && shadows.maps.filter != ShadowFilter::colour;
    if (expectsMaps && shadows.maps.empty() && !scene.sources.empty())
        return withoutShadows(
            fbrdf::Found(nameOf(*technique) + " without a map of depths in its state")
                .expected("a technique of osgShadow that has maps"));
    if (const auto* soft = dynamic_cast<const osgShadow::SoftShadowMap*>(technique))
        shadows.unitsTaken.insert(static_cast<int>(soft->getJitterTextureUnit()));
    if (shadows.maps.units.size() > static_cast<size_t>(kMostShadowMaps))
        return withoutShadows(
            fbrdf::Found(std::to_string(shadows.maps.units.size()) + " shadow maps")
                .expected("at most " + std::to_string(kMostShadowMaps)));
    return shadows;
}

}  // namespace osgFbrdf
