// EffectTest.h - compares a view of the effect with what the plain runtime draws of the same scene.
#pragma once
#include "OsgScene.h"

#include <memory>
#include <vector>

namespace fbrdf::test {

class EffectTest : public OsgTest {
protected:
    void SetUp() override;
    void TearDown() override { view_.reset(); }

    /// One item for each of `places`.
    std::vector<float> runtimeImage(const Material& material, const gl::MeshData& mesh,
                                    const std::vector<Light>& lights,
                                    const std::vector<glm::mat4>& places = {glm::mat4(1.0f)});
    /// True where the context filters textures so coarsely that two programs, which round
    /// coordinates differently, draw different pictures: effect and runtime then filter in shaders.
    bool filtersCoarsely();
    /// The lights come after the effect in the graph, as their order must not matter.
    osg::ref_ptr<osg::Group> scene(osgFbrdf::FactorizedBrdf* effect, osg::Node* lights);

    std::unique_ptr<OsgView> view_;

private:
    gl::Renderer renderer();
};

}  // namespace fbrdf::test
