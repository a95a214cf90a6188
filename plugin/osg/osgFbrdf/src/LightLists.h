// LightLists.h - the lights of a view by the parts of the picture that they reach, for scenes with
// more lights than uniforms hold: the lists of the runtime (fbrdf/plan/LightClusters.h) in buffer
// textures. Programs that read them need GLSL 1.40.
#pragma once
#include "OsgLights.h"
#include "SceneLights.h"

#include <fbrdf/plan/LightClusters.h>

#include <osg/TextureBuffer>
#include <osg/Viewport>

#include <array>
#include <memory>
#include <vector>

namespace osgFbrdf {

/// Scenes with so many lights have lists; fewer fit into the uniforms of one pass.
constexpr size_t kFewestListedLights = 257;

/// Samplers of the lists, in the order of their texture units; the last one of programs with a hook
/// only.
constexpr std::array<const char*, 4> kListSamplers{"fbrdfLightBuffer", "fbrdfLightIndices",
                                                   "fbrdfLightLists", "fbrdfLightNumbers"};

/// What the frames draw with until a light or the view moves; it does not change.
struct LightLists : osg::Referenced {
    std::array<osg::ref_ptr<osg::TextureBuffer>, kListSamplers.size()> textures;
    std::vector<Attenuation> attenuations;  ///< of the osg::Lights
    fbrdf::ClusterGrid grid;
    osg::Vec4f scale;    ///< the uniform fbrdfClusterScale
    int everywhere = 0;  ///< lights that are in no list, as all parts have them
    int lights = 0, culled = 0;
    int longest = 0;    ///< lights of the longest list
    size_t texels = 0;  ///< of the largest texture

protected:
    ~LightLists() override = default;
};

/// Makes the lists of one view, frame after frame.
class LightListMaker {
public:
    /// Null where the scene has few lights, or osg::Lights that lists cannot have. All its sources
    /// are on. toEye: from the coordinates of the lights. The result is that of the last call where
    /// nothing has moved.
    const LightLists* listsOf(const SceneLights& scene, const osg::Matrixd& toEye,
                              const osg::Matrixd& projection, const osg::Viewport& viewport);

private:
    bool addSources(const SceneLights& scene, const osg::Matrixd& toEye);
    void makeLists(const osg::Viewport& viewport);
    /// Null where no light can be seen.
    const LightLists* visibleLists() const;

    fbrdf::ClusterBuilder builder_;
    unsigned int serial_ = 0;  ///< of the lights that are in eye space; 0: none
    osg::Matrixd toEye_, projection_;
    osg::Vec4d viewport_;
    size_t pointLights_ = 0;                    ///< vectors of PointLights, which come first
    std::vector<fbrdf::LightVectors> vectors_;  ///< of all lights
    std::vector<int> numbers_;                  ///< attenuations of all lights
    std::vector<Attenuation> attenuations_;
    osg::ref_ptr<LightLists> lists_;
};

}  // namespace osgFbrdf
