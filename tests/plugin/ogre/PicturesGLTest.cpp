// OGRE with Plugin_Fbrdf draws what the runtime draws.
#include "OgreTest.h"

#include <glm/gtc/matrix_transform.hpp>

#include <set>

namespace fbrdf::test {
namespace {

// The same functions on the same numbers, but texels of 16 bits where the runtime may have floats,
// and lights that went through OGRE's quaternions, which are good to 1e-7: next to the pole of a
// table of noise such a direction moves a single pixel by 4e-4. The mean is 6e-7.
constexpr double kWorstPixel = 1e-3, kMean = 5e-6;

bool isRuntimes(const ImageDifference& d)
{
    return d.comparable && d.maxRelative < kWorstPixel && d.meanRelative < kMean;
}

class OgrePictures : public OgreTest {
protected:
    /// Puts the material on the mesh, under a view.
    void show(const Material& material, const gl::MeshData& mesh, const gl::View& view)
    {
        addMaterial("m" + std::to_string(shown_), material);
        host().addMesh("mesh" + std::to_string(shown_), mesh);
        if (entity_) entity_->setVisible(false);
        entity_ = host().addEntity("mesh" + std::to_string(shown_), "m" + std::to_string(shown_));
        ++shown_;
        host().setView(view);
    }
    void addLights(int count)
    {
        const std::vector<Light> all = unlimitedLights(count);
        for (; lights_ < count; ++lights_) host().addLight(all[static_cast<size_t>(lights_)]);
    }
    void compare(const Material& material, const gl::MeshData& mesh, const gl::View& view)
    {
        const auto expected = runtimePicture(material, mesh, unlimitedLights(lights_), view);
        const auto d = compareImages(host().picture(), expected);
        EXPECT_TRUE(isRuntimes(d))
            << material.name << ", " << lights_ << " lights: " << describe(d);
    }
    Ogre::Entity* entity_ = nullptr;

private:
    int lights_ = 0, shown_ = 0;
};
FBRDF_ON_BOTH_SYSTEMS(OgrePictures);

TEST_P(OgrePictures, AnyNumberOfLightsEqualsTheRuntime)
{
    const Material material = testMaterials()[0];
    const gl::MeshData mesh = sphereMesh(24);
    show(material, mesh, perspectiveView());
    std::set<std::string> programs;
    for (const int count : {1, 9, 64, 200}) {
        addLights(count);
        compare(material, mesh, perspectiveView());
        programs.insert(programOf(*entity_));
    }
    EXPECT_EQ(programs.size(), 1u) << "the number of lights changed the shader";
}

TEST_P(OgrePictures, EveryFormEqualsTheRuntime)
{
    addLights(9);
    const gl::MeshData mesh = knotMesh(48, 12);
    for (const Material& material : testMaterials()) {
        show(material, mesh, perspectiveView());
        compare(material, mesh, perspectiveView());
    }
}

TEST_P(OgrePictures, ParallelProjectionsEqualTheRuntime)
{
    addLights(9);
    const gl::MeshData mesh = sphereMesh(24);
    show(everythingMaterial(), mesh, orthographicView());
    compare(everythingMaterial(), mesh, orthographicView());
}

TEST_P(OgrePictures, ALostLightIsNoticed)
{
    const gl::MeshData mesh = sphereMesh(24);
    show(testMaterials()[0], mesh, perspectiveView());
    addLights(9);
    host().scene().destroyLight(host().addLight(unlimitedLights(10)[9]));
    const auto expected =
        runtimePicture(testMaterials()[0], mesh, unlimitedLights(10), perspectiveView());
    EXPECT_GT(compareImages(host().picture(), expected).maxRelative, 10.0 * kWorstPixel);
}

TEST_P(OgrePictures, ObjectsMoveScaleAndMirror)
{
    const gl::MeshData mesh = knotMesh(48, 12);
    show(everythingMaterial(), mesh, perspectiveView());
    addLights(9);
    Ogre::Node* node = entity_->getParentNode();
    node->setPosition(0.2f, -0.1f, 0.3f);
    node->setOrientation(Ogre::Quaternion(Ogre::Radian(0.5f), Ogre::Vector3(0.6f, 0.8f, 0.0f)));
    node->setScale(-0.7f, 0.9f, 0.6f);
    glm::mat4 model = glm::translate(glm::mat4(1.0f), Vec3f(0.2f, -0.1f, 0.3f));
    model = glm::rotate(model, 0.5f, Vec3f(0.6f, 0.8f, 0.0f));
    model = glm::scale(model, Vec3f(-0.7f, 0.9f, 0.6f));
    const auto expected =
        runtimePicture(everythingMaterial(), mesh, unlimitedLights(9), perspectiveView(), model);
    const auto d = compareImages(host().picture(), expected);
    EXPECT_TRUE(isRuntimes(d)) << describe(d);
}

class LatePlugin : public OgrePictures {
protected:
    void SetUp() override { start(true); }
};
FBRDF_ON_BOTH_SYSTEMS(LatePlugin);

TEST_P(LatePlugin, ComesAndGoesWhileOgreRuns)
{
    const gl::MeshData mesh = sphereMesh(24);
    show(testMaterials()[0], mesh, perspectiveView());
    addLights(9);
    compare(testMaterials()[0], mesh, perspectiveView());
    host().root().unloadPlugin(OgreHost::pluginFile());
    host().picture();  // by OGRE's own lighting
    host().root().loadPlugin(OgreHost::pluginFile());
    show(testMaterials()[0], mesh, perspectiveView());
    compare(testMaterials()[0], mesh, perspectiveView());
}

}  // namespace
}  // namespace fbrdf::test
