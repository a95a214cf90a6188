#include "ShadowTechniques.h"

#include <osgShadow/LightSpacePerspectiveShadowMap>
#include <osgShadow/MinimalCullBoundsShadowMap>
#include <osgShadow/MinimalDrawBoundsShadowMap>
#include <osgShadow/ParallelSplitShadowMap>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowTexture>
#include <osgShadow/SoftShadowMap>
#include <osgShadow/StandardShadowMap>
#include <osgShadow/ViewDependentShadowMap>

#include <string>

namespace fbrdf::test {
namespace {

template <class Technique>
osgShadow::ShadowTechnique* made()
{
    return new Technique;
}

osgShadow::ShadowTechnique* madeSoft()
{
    auto* technique = new osgShadow::SoftShadowMap;
    technique->setSoftnessWidth(0.01f);
    technique->setJitteringScale(16.0f);
    return technique;
}

}  // namespace

std::vector<ShadowKind> shadowKinds()
{
    using namespace osgShadow;
    std::vector<ShadowKind> kinds{
        {"ShadowMap", made<ShadowMap>},
        {"SoftShadowMap", madeSoft},
        {"StandardShadowMap", made<StandardShadowMap>},
        {"MinimalShadowMap", made<MinimalShadowMap>},
        {"MinimalCullBounds", made<MinimalCullBoundsShadowMap>},
        {"MinimalDrawBounds", made<MinimalDrawBoundsShadowMap>},
        {"LightSpaceViewBounds", made<LightSpacePerspectiveShadowMapVB>},
        {"LightSpaceCullBounds", made<LightSpacePerspectiveShadowMapCB>},
        {"LightSpaceDrawBounds", made<LightSpacePerspectiveShadowMapDB>},
        {"ParallelSplit", made<ParallelSplitShadowMap>},
        {"ViewDependent", made<ViewDependentShadowMap>},
        {"ShadowTexture", made<osgShadow::ShadowTexture>},
    };
    for (ShadowKind& kind : kinds) {
        const std::string name = kind.name;
        kind.isSoft = name == "SoftShadowMap";
        kind.aims = name == "ParallelSplit";
        kind.shade = kind.aims ? 0.9f : 0.7f;
        kind.shadowsAll = name == "ViewDependent";
        kind.dividesScene = name == "ShadowTexture";
    }
    return kinds;
}

osg::ref_ptr<osgShadow::ShadowedScene> shadowedScene(
    const ShadowKind& kind, std::vector<osg::ref_ptr<osgShadow::ShadowTechnique>>& techniques)
{
    techniques.emplace_back(kind.make());
    osg::ref_ptr<osgShadow::ShadowedScene> scene = new osgShadow::ShadowedScene(techniques.back());
    if (kind.dividesScene) {
        scene->setReceivesShadowTraversalMask(kReceives);
        scene->setCastsShadowTraversalMask(kCasts);
    }
    return scene;
}

}  // namespace fbrdf::test
