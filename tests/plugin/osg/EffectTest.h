// EffectTest.h - compares a view of the effect with what the plain runtime draws of the same scene.
#pragma once
#include "OsgScene.h"

#include <fbrdf/environment/Panorama.h>
#include <fbrdf/plan/AreaLight.h>

#include <memory>
#include <vector>

namespace fbrdf::test {

/// How the runtime's renderer has an environment.
struct RuntimeEnvironment {
    Panorama panorama;
    int faceSize = 32;
    float rotation = 0.0f;  ///< radians about +y
    Vec3f intensity{1.0f};
    int lobes = 0;
};

class EffectTest : public OsgTest {
protected:
    void SetUp() override;
    void TearDown() override
    {
        if (view_) context().makeCurrent();
        view_.reset();
        map_.reset();
        renderer_.reset();
    }

    /// One item for each of `places`.
    std::vector<float> runtimeImage(const Material& material, const gl::MeshData& mesh,
                                    const std::vector<Light>& lights,
                                    const std::vector<glm::mat4>& places = {glm::mat4(1.0f)},
                                    const RuntimeEnvironment* environment = nullptr,
                                    const std::vector<AreaLight>& areaLights = {});
    /// True where the context filters textures so coarsely that two programs, which round
    /// coordinates differently, draw different pictures: effect and runtime then filter in shaders.
    bool filtersCoarsely();
    /// The lights come after the effect in the graph, as their order must not matter.
    osg::ref_ptr<osg::Group> scene(osgFbrdf::FactorizedBrdf* effect, osg::Node* lights);

    /// An effect over a model, for a target of floats.
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effectOver(osg::Node* model, const Material& material);
    /// The second picture of a scene of both.
    std::vector<float> pictureOf(osg::Node* node, osg::Node* lights);

    std::unique_ptr<OsgView> view_;

private:
    gl::Renderer& renderer();
    gl::GpuEnvironment& mapOf(const RuntimeEnvironment& environment);

    std::unique_ptr<gl::Renderer> renderer_;
    std::shared_ptr<gl::GpuEnvironment> map_;
    Panorama panorama_;  ///< that map_ is made of
};

}  // namespace fbrdf::test
