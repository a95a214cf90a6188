// What OGRE does beside lighting goes on: its own kinds of light, shadows, fog, skinning,
// instancing and normal maps. A Lambertian material is drawn as OGRE draws a diffuse surface.
#include "OgreTest.h"

#include <OgreShaderExHardwareSkinning.h>
#include <OgreShaderExIntegratedPSSM3.h>
#include <OgreShadowCameraSetupPSSM.h>

namespace fbrdf::test {
namespace {

// OGRE normalizes vectors in another order, in floats; values are below 1. A spot's edge is a power
// of a difference of cosines, which was 3e-5 apart.
constexpr double kSame = 1e-4;
// The bounds of PicturesGLTest.cpp.
constexpr double kMean = 5e-6;

Material lambertian(const Vec3f& albedo)
{
    Material material = noiseMaterial(formIo(), Storage::half);
    for (Table& table : material.tables) std::fill(table.texels.begin(), table.texels.end(), 0.0f);
    material.scales = {albedo / static_cast<float>(kPi)};
    return material;
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double largest = a.size() == b.size() ? 0.0 : 1e30;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
    return largest;
}

float largest(const std::vector<float>& pixels)
{
    float most = 0.0f;
    for (size_t i = 0; i < pixels.size(); ++i)
        if (i % 4 < 3) most = std::max(most, pixels[i]);
    return most;
}

class OgreEngine : public OgreTest {
protected:
    void SetUp() override
    {
        OgreTest::SetUp();
        const Vec3f albedo(0.8f, 0.6f, 0.4f);
        addMaterial("ours", lambertian(albedo));
        auto theirs = Ogre::MaterialManager::getSingleton().create("theirs", "General");
        theirs->getTechnique(0)->getPass(0)->setDiffuse(albedo.x, albedo.y, albedo.z, 1.0f);
        host().addMesh("sphere", sphereMesh(24));
        Ogre::Camera& camera = host().camera();
        camera.getParentNode()->setPosition(0.0f, 1.5f, 3.5f);
        camera.getParentSceneNode()->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        camera.setNearClipDistance(0.5f);
        camera.setFarClipDistance(20.0f);
        camera.setFOVy(Ogre::Degree(45.0f));
        camera.setAspectRatio(1.0f);
    }
    Ogre::Light* light(Ogre::Light::LightTypes type, const Ogre::Vector3& position, float power)
    {
        Ogre::Light* result = host().scene().createLight();
        result->setType(type);
        Ogre::SceneNode* node = host().scene().getRootSceneNode()->createChildSceneNode(position);
        node->attachObject(result);
        node->setDirection((-position).normalisedCopy(), Ogre::Node::TS_WORLD);
        result->setDiffuseColour(0.9f, 0.7f, 0.8f);
        result->setPowerScale(power);
        return result;
    }
    std::vector<float> drawn(const std::string& material)
    {
        Ogre::Entity* entity = host().addEntity("sphere", material);
        auto pixels = host().picture();
        host().scene().destroyEntity(entity);
        return pixels;
    }
    void expectOursAsTheirs()
    {
        const auto ours = drawn("ours"), theirs = drawn("theirs");
        EXPECT_LT(largestDifference(ours, theirs), kSame);
        EXPECT_GT(largest(theirs), 0.05f);
        EXPECT_LT(largest(theirs), 0.99f) << "OGRE clamps here";
    }
    /// A floor under the sphere, whose shadow falls on it, both of the material.
    void addFloor(const std::string& material)
    {
        Ogre::MeshManager::getSingleton().createPlane(
            "floor", "General", Ogre::Plane(Ogre::Vector3::UNIT_Y, -1.1f), 5.0f, 5.0f, 20, 20, true,
            1, 1.0f, 1.0f, Ogre::Vector3::UNIT_Z);
        floor_ = host().addEntity("floor", material);
        ball_ = host().addEntity("sphere", material);
    }
    void useShadows()
    {
        Ogre::SceneManager& scene = host().scene();
        scene.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
        scene.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
        scene.setShadowTextureSettings(256, 3, Ogre::PF_DEPTH16);
        scene.setShadowFarDistance(20.0f);
        scene.setShadowTextureSelfShadow(false);
        auto* camera = new Ogre::PSSMShadowCameraSetup;
        camera->calculateSplitPoints(3, 0.5f, 20.0f);
        scene.setShadowCameraSetup(Ogre::ShadowCameraSetupPtr(camera));
        auto& generator = host().generator();
        auto* state = generator.createSubRenderState(Ogre::RTShader::IntegratedPSSM3::Type);
        static_cast<Ogre::RTShader::IntegratedPSSM3*>(state)->setSplitPoints(
            camera->getSplitPoints());
        generator.getRenderState(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME)
            ->addTemplateSubRenderState(state);
        generator.invalidateScheme(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME);
    }

    Ogre::Entity *floor_ = nullptr, *ball_ = nullptr;
};
FBRDF_ON_BOTH_SYSTEMS(OgreEngine);

TEST_P(OgreEngine, DirectionalLightsAreOgres)
{
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    expectOursAsTheirs();
}

TEST_P(OgreEngine, AttenuationAndRangeAreOgres)
{
    light(Ogre::Light::LT_POINT, {0.0f, 2.0f, 2.0f}, 1.5f)->setAttenuation(9.0f, 1.0f, 0.3f, 0.2f);
    // This range ends on the sphere.
    light(Ogre::Light::LT_POINT, {1.5f, 0.0f, 1.0f}, 0.3f)->setAttenuation(1.3f, 1.0f, 0.0f, 0.1f);
    expectOursAsTheirs();
}

TEST_P(OgreEngine, SpotsAreOgres)
{
    Ogre::Light* spot = light(Ogre::Light::LT_SPOTLIGHT, {1.0f, 2.5f, 1.5f}, 0.8f);
    spot->setAttenuation(20.0f, 1.0f, 0.1f, 0.0f);
    spot->setSpotlightRange(Ogre::Degree(12.0f), Ogre::Degree(30.0f), 1.3f);
    // Of this one the whole cone has no soft edge.
    spot = light(Ogre::Light::LT_SPOTLIGHT, {-1.0f, 1.5f, 2.5f}, 0.4f);
    spot->setSpotlightRange(Ogre::Degree(0.0f), Ogre::Degree(25.0f), 0.5f);
    expectOursAsTheirs();
}

TEST_P(OgreEngine, OnlyTheLightsThatReachAnObjectAreInItsList)
{
    const auto far = [&](float x) {
        light(Ogre::Light::LT_POINT, {x, 0.0f, -3.0f}, 5.0f)
            ->setAttenuation(1.0f, 1.0f, 0.0f, 0.0f);
    };
    far(-2.0f);
    light(Ogre::Light::LT_POINT, {0.0f, 2.0f, 2.0f}, 1.5f)->setAttenuation(9.0f, 1.0f, 0.3f, 0.2f);
    far(2.0f);
    // A light of another mask is in reach and lights nothing.
    Ogre::Light* masked = light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    masked->setLightMask(2);
    Ogre::Entity* entity = host().addEntity("sphere", "ours");
    entity->setLightMask(1);
    const auto ours = host().picture();
    entity->setMaterialName("theirs", "General");
    const auto theirs = host().picture();
    EXPECT_LT(largestDifference(ours, theirs), kSame);
    EXPECT_GT(largest(theirs), 0.05f);
}

TEST_P(OgreEngine, MoreLightsThanAListHasObserveTheirRanges)
{
    for (int i = 0; i < 300; ++i)
        light(Ogre::Light::LT_POINT, {0.02f * static_cast<float>(i % 100) - 1.0f, 2.0f, 2.0f},
              0.01f)
            ->setAttenuation(9.0f, 1.0f, 0.3f, 0.2f);
    const auto reached = drawn("ours");
    light(Ogre::Light::LT_POINT, {2.0f, 0.0f, -3.0f}, 5.0f)->setAttenuation(1.0f, 1.0f, 0.0f, 0.0f);
    EXPECT_LT(largestDifference(drawn("ours"), reached), kSame);
    EXPECT_GT(largest(reached), 0.05f);
}

TEST_P(OgreEngine, FogIsOgres)
{
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    const auto clear = drawn("ours");
    for (const Ogre::FogMode mode : {Ogre::FOG_LINEAR, Ogre::FOG_EXP, Ogre::FOG_EXP2}) {
        host().scene().setFog(mode, Ogre::ColourValue(0.2f, 0.5f, 0.3f), 0.2f, 2.0f, 6.0f);
        expectOursAsTheirs();
        EXPECT_GT(largestDifference(drawn("ours"), clear), 0.1);
    }
}

TEST_P(OgreEngine, IntegratedShadowsFallOnTheMaterial)
{
    addFloor("ours");
    light(Ogre::Light::LT_DIRECTIONAL, {1.0f, 3.0f, 0.5f}, 0.7f);
    const auto lit = host().picture();
    useShadows();
    const auto ours = host().picture();
    EXPECT_GT(largestDifference(ours, lit), 0.3) << "there is no shadow";
    for (Ogre::Entity* entity : {floor_, ball_}) entity->setMaterialName("theirs", "General");
    EXPECT_LT(largestDifference(ours, host().picture()), kSame);
}

TEST_P(OgreEngine, AShadowDimsItsOwnLightAlone)
{
    addFloor("ours");
    useShadows();
    Ogre::Light* caster = light(Ogre::Light::LT_DIRECTIONAL, {1.0f, 3.0f, 0.5f}, 0.4f);
    host().picture();  // the shadow cameras follow what the frame before saw
    const auto one = host().picture();
    caster->setVisible(false);
    light(Ogre::Light::LT_DIRECTIONAL, {-1.0f, 2.0f, 2.0f}, 0.3f)->setCastShadows(false);
    const auto other = host().picture();
    caster->setVisible(true);
    const auto both = host().picture();
    std::vector<float> sum = one;
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 < 3) sum[i] += other[i];
    EXPECT_LT(largestDifference(both, sum), kSame);
}

TEST_P(OgreEngine, TexturesOfThePassTint)
{
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    const Ogre::uint8 texel[] = {255, 128, 0};
    auto texture = Ogre::TextureManager::getSingleton().createManual(
        "tint", "General", Ogre::TEX_TYPE_2D, 1, 1, 0, Ogre::PF_BYTE_RGB);
    Ogre::uint8 copy[] = {texel[0], texel[1], texel[2]};
    texture->getBuffer()->blitFromMemory(Ogre::PixelBox(1, 1, 1, Ogre::PF_BYTE_RGB, copy));
    for (const char* name : {"ours", "theirs"})
        Ogre::MaterialManager::getSingleton()
            .getByName(name)
            ->getTechnique(0)
            ->getPass(0)
            ->createTextureUnitState("tint");
    const auto ours = drawn("ours");
    EXPECT_LT(largestDifference(ours, drawn("theirs")), kSame);
    for (size_t i = 2; i < ours.size(); i += 4) ASSERT_EQ(ours[i], 0.0f);
}

TEST_P(OgreEngine, EmissionAndAlphaAreOgres)
{
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    host().viewport().setBackgroundColour(Ogre::ColourValue(0.1f, 0.3f, 0.2f, 1.0f));
    const auto opaque = drawn("ours");
    for (const char* name : {"ours", "theirs"}) {
        Ogre::Pass* pass =
            Ogre::MaterialManager::getSingleton().getByName(name)->getTechnique(0)->getPass(0);
        pass->setSelfIllumination(0.1f, 0.0f, 0.05f);
        Ogre::ColourValue diffuse = pass->getDiffuse();
        diffuse.a = 0.5f;
        pass->setDiffuse(diffuse);
        pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
        host().generator().invalidateMaterial(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME,
                                              name, "General");
    }
    expectOursAsTheirs();
    EXPECT_GT(largestDifference(drawn("ours"), opaque), 0.1);
}

TEST_P(OgreEngine, ViewsOfOneFrameSeeTheirOwnLights)
{
    light(Ogre::Light::LT_POINT, {0.0f, 2.0f, 2.0f}, 1.0f)->setAttenuation(9.0f, 1.0f, 0.1f, 0.1f);
    host().addEntity("sphere", "ours");
    const auto alone = host().picture();
    // Another camera draws into half of the target, before and after the first.
    Ogre::Camera* other = host().scene().createCamera("other");
    Ogre::SceneNode* node = host().scene().getRootSceneNode()->createChildSceneNode();
    node->attachObject(other);
    node->setPosition(3.0f, -1.0f, 2.0f);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    Ogre::RenderTarget* target = host().viewport().getTarget();
    Ogre::Viewport* half = target->addViewport(other, 1, 0.5f, 0.0f, 0.5f, 1.0f);
    half->setMaterialScheme(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME);
    half->setOverlaysEnabled(false);
    for (int frame = 0; frame < 2; ++frame) {
        const auto both = host().picture();
        double left = 0.0, right = 0.0;
        for (size_t i = 0; i < both.size(); ++i) {
            double& side = i / 4 % kOgrePicture < kOgrePicture / 2 ? left : right;
            side = std::max(side, static_cast<double>(std::abs(both[i] - alone[i])));
        }
        EXPECT_EQ(left, 0.0);
        EXPECT_GT(right, 0.05);
    }
}

TEST_P(OgreEngine, InstancesAreDrawnAsEntities)
{
    host().addScript(
        "material many\n{\ntechnique\n{\npass\n{\nrtshader_system\n{\nfbrdf "
        "ours.fbrdf\ntransform_stage instanced\n}\n}\n}\n}\n");
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    light(Ogre::Light::LT_POINT, {0.0f, 2.0f, 2.0f}, 0.5f);
    std::vector<Ogre::Entity*> entities;
    Ogre::InstanceManager* instances = host().scene().createInstanceManager(
        "instances", "sphere", "General", Ogre::InstanceManager::HWInstancingBasic, 4);
    std::vector<Ogre::InstancedEntity*> instanced;
    for (int i = 0; i < 3; ++i) {
        const Ogre::Vector3 place(0.8f * static_cast<float>(i - 1), 0.0f,
                                  0.3f * static_cast<float>(i));
        entities.push_back(host().addEntity("sphere", "ours"));
        entities.back()->getParentNode()->setPosition(place);
        entities.back()->getParentNode()->setScale(0.4f, 0.4f, 0.4f);
    }
    const auto apart = host().picture();
    for (Ogre::Entity* entity : entities) {
        instanced.push_back(instances->createInstancedEntity("many"));
        entity->getParentSceneNode()->attachObject(instanced.back());
        entity->setVisible(false);
    }
    EXPECT_LT(largestDifference(host().picture(), apart), kSame);
    EXPECT_GT(largest(apart), 0.05f);
}

/// A skeleton of two bones, and the sphere on it, bent.
Ogre::MeshPtr boneMesh(OgreHost& host)
{
    auto skeleton = Ogre::SkeletonManager::getSingleton().create("bones", "General", true);
    Ogre::Bone *root = skeleton->createBone("root", 0), *tip = skeleton->createBone("tip", 1);
    root->addChild(tip);
    tip->setPosition(0.0f, 0.2f, 0.0f);
    skeleton->setBindingPose();
    const gl::MeshData data = sphereMesh(24);
    Ogre::MeshPtr mesh = host.addMesh("bent", data);
    mesh->setSkeletonName("bones");
    for (unsigned i = 0; i < data.positions.size(); ++i) {
        const float upper = std::clamp(0.5f + data.positions[i].y, 0.0f, 1.0f);
        mesh->getSubMesh(0)->addBoneAssignment({i, 0, 1.0f - upper});
        mesh->getSubMesh(0)->addBoneAssignment({i, 1, upper});
    }
    mesh->_updateCompiledBoneAssignments();
    return mesh;
}

TEST_P(OgreEngine, SkinningOnTheGpuIsThatOfTheCpu)
{
    light(Ogre::Light::LT_DIRECTIONAL, {2.0f, 3.0f, 1.0f}, 0.7f);
    boneMesh(host());
    const auto bent = [&] {
        Ogre::Entity* entity = host().addEntity("bent", "ours");
        Ogre::Bone* bone = entity->getSkeleton()->getBone(1);
        bone->setManuallyControlled(true);
        bone->roll(Ogre::Degree(40.0f));
        return entity;
    };
    Ogre::Entity* entity = bent();
    const auto cpu = host().picture();
    host().scene().destroyEntity(entity);
    EXPECT_GT(largestDifference(cpu, drawn("ours")), 0.1) << "nothing is bent";

    auto& generator = host().generator();
    generator.getRenderState(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME)
        ->addTemplateSubRenderState(
            generator.createSubRenderState(Ogre::RTShader::HardwareSkinning::Type));
    entity = bent();
    Ogre::RTShader::HardwareSkinningFactory::getSingleton().prepareEntityForSkinning(entity);
    generator.invalidateScheme(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME);
    const auto gpu = host().picture();
    EXPECT_TRUE(entity->isHardwareAnimationEnabled());
    EXPECT_LT(largestDifference(gpu, cpu), 1e-3);
}

TEST_P(OgreEngine, NormalMapsAreThoseOfTheRuntime)
{
    gl::MeshData mesh = sphereMesh(24);
    for (const Vec3f& p : mesh.positions)
        mesh.textureCoordinates.emplace_back(0.5f + 0.4f * p.x, 0.5f + 0.4f * p.y);
    host().addMesh("mapped", mesh);
    std::vector<Ogre::uint8> texels;
    for (int i = 0; i < 16; ++i)
        for (const int value : {128 + 16 * (i % 4 - 2), 128 + 20 * (i / 4 - 2), 240})
            texels.push_back(static_cast<Ogre::uint8>(value));
    auto texture = Ogre::TextureManager::getSingleton().createManual(
        "bumps", "General", Ogre::TEX_TYPE_2D, 4, 4, 0, Ogre::PF_BYTE_RGB);
    texture->getBuffer()->blitFromMemory(Ogre::PixelBox(4, 4, 1, Ogre::PF_BYTE_RGB, texels.data()));
    addMaterial("noise", everythingMaterial(), "normalMap bumps");
    host().addEntity("mapped", "noise");
    host().setView(perspectiveView());
    for (const Light& each : unlimitedLights(9)) host().addLight(each);
    const auto found = host().picture();
    Ogre::uint name = 0;
    texture->getCustomAttribute("GLID", &name);
    // OGRE has filters beside its textures.
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    const auto flat =
        runtimePicture(everythingMaterial(), mesh, unlimitedLights(9), perspectiveView());
    const auto expected = runtimePicture(everythingMaterial(), mesh, unlimitedLights(9),
                                         perspectiveView(), glm::mat4(1.0f), name);
    EXPECT_GT(compareImages(flat, expected).meanRelative, 1e-2) << "the map changes nothing";
    const auto d = compareImages(found, expected);
    EXPECT_TRUE(d.comparable && d.meanRelative < kMean) << describe(d);
}

}  // namespace
}  // namespace fbrdf::test
