// ShadowPlacement.h - tells the passes of an effect, when drawing begins, where the shadow maps lie
// and which lights they shadow.
//
// A map shadows the lights that are where it is drawn from: whichever light a technique chose, and
// whatever it did to the projection, every ray to that light meets the map in one point. But
// ParallelSplitShadowMap follows osg::Light::getDirection(), wherever the light is.
#pragma once
#include "EffectInternals.h"
#include "EyeLights.h"
#include "ReceivedShadows.h"

#include <osg/StateAttribute>
#include <osg/Uniform>

#include <vector>

namespace osgUtil {
class RenderStage;
}

namespace osgFbrdf {

/// What shadows.glsl is told of a light: the number of its attenuation, and times this the set of
/// its maps, one bit each.
constexpr int kShadowBit = 16;

/// Goes the way of positional state: OSG applies it once before it draws the stage, when all of
/// the stage has been culled. One frame, view and effect has one.
class ShadowPlacement : public osg::StateAttribute {
public:
    ShadowPlacement() = default;
    /// about: the middle of the object, in eye space. internals: of the effect, told of a map that
    /// belongs to no light of the scene.
    ShadowPlacement(const ShadowMaps& maps, const std::vector<fbrdf::Light>& lights,
                    const osg::Vec3d& about, osgUtil::RenderStage& stage,
                    EffectInternals& internals);
    ShadowPlacement(const ShadowPlacement& other,
                    const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_StateAttribute(osgFbrdf, ShadowPlacement, VALIDATOR)

    /// From eye space to the coordinates of each map.
    osg::Uniform* matrices() const { return matrices_; }
    /// numbers: of lights from firstLight on, to which the bits of their maps are added.
    void place(osg::Uniform* numbers, int firstLight);

    int compare(const osg::StateAttribute& other) const override;
    void apply(osg::State& state) const override;

private:
    struct Numbers {
        osg::ref_ptr<osg::Uniform> uniform;
        std::vector<int> before;  ///< without the maps
        size_t firstLight = 0;
    };
    /// False where the map is drawn from where the scene has no light.
    bool addMap(unsigned int map, std::vector<int>& mapsOfLights) const;

    ShadowMaps maps_;
    std::vector<fbrdf::Light> lights_;
    osg::Vec3d about_;
    osgUtil::RenderStage* stage_ = nullptr;  ///< is drawn while this is applied
    osg::ref_ptr<osg::Uniform> matrices_;
    std::vector<Numbers> numbers_;
    osg::ref_ptr<EffectInternals> internals_;
};

}  // namespace osgFbrdf
