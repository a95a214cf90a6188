// ShadowTechniques.h - every technique of osgShadow in Debian's package of OSG 3.6.5, which lacks
// ShadowVolume.
#pragma once
#include <osg/ref_ptr>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ShadowTechnique>

#include <vector>

namespace fbrdf::test {

struct ShadowKind {
    const char* name;
    osgShadow::ShadowTechnique* (*make)();
    float shade = 0.7f;         ///< shadows on other objects are darker than that part of the light
    bool shadowsAll = false;    ///< every osg::Light, not only the last
    bool dividesScene = false;  ///< what casts shadows must not receive them
    bool isSoft = false;
    bool aims = false;  ///< shadows of lamps nearby are those of their direction
};

std::vector<ShadowKind> shadowKinds();

/// Node masks of what receives shadows and of what casts them, where the technique divides the
/// scene.
constexpr unsigned int kReceives = 1, kCasts = 2;

/// A scene of the technique, which is put among `techniques`: osg::Identifier deadlocks where a
/// cull visitor is deleted after the technique that knew it.
osg::ref_ptr<osgShadow::ShadowedScene> shadowedScene(
    const ShadowKind& kind, std::vector<osg::ref_ptr<osgShadow::ShadowTechnique>>& techniques);

}  // namespace fbrdf::test
