// Sums add up in surfaces of the plugin before their last factor, whatever the host draws to.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/MatrixTransform>
#include <osg/Texture2D>

#include <algorithm>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// The same programs run on the same numbers as where passes add up in the target.
constexpr double kAgainstRuntime = 1e-4;

class SurfacesOf : public EffectTest {
protected:
    void compare(const Material& material, int technique, bool floatTarget)
    {
        const auto effect = osgEffect(material, sphereMesh(24));
        effect->setFloatTarget(floatTarget);
        effect->setLightsPerPass(4);
        effect->selectTechnique(technique);
        scene(effect, osgLights(testLights(9)));
        const Notices notices;
        const auto d =
            compareImages(view_->frame(), runtimeImage(material, sphereMesh(24), testLights(9)));
        EXPECT_LT(d.maxRelative, kAgainstRuntime)
            << material.name << ", technique " << technique << ": " << describe(d);
        EXPECT_EQ(effect->lastReport().reason, "");
        EXPECT_EQ(notices.text(), "");
    }
};

TEST_F(SurfacesOf, SumsOfTermsEqualTheRuntime)
{
    for (const Material& material : testMaterials())
        for (int technique = 0; technique < kTechniqueCount; ++technique)
            compare(material, technique, false);
    compare(testMaterials()[4], osgFbrdf::kTwoLookups, true);
}

TEST_F(SurfacesOf, AreDrawnToInTurnByEffectsThatOverlap)
{
    const Material material = testMaterials()[4];
    osg::ref_ptr<osg::Group> root = new osg::Group;
    std::vector<glm::mat4> places(2, glm::mat4(1.0f));
    places[1][3] = {0.5f, 0.25f, 0.75f, 1.0f};
    for (const glm::mat4& place : places) {
        osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(osgMatrix(place));
        const auto effect = osgEffect(material, sphereMesh(24));
        effect->setFloatTarget(false);
        effect->selectTechnique(osgFbrdf::kTwoLookups);
        above->addChild(effect);
        root->addChild(above);
    }
    root->addChild(osgLights(testLights(3)));
    view_->setScene(root);
    // Moved vertices are rounded elsewhere: a wrong order would be off by 1.
    constexpr double kMoved = 1e-3;
    const auto d = compareImages(view_->frame(),
                                 runtimeImage(material, sphereMesh(24), testLights(3), places));
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
}

// A draw callback of ours on a bin of the host's would take all that is in it off the target.
TEST_F(SurfacesOf, StandInBinsOfTheirOwnWhereTheHostOverridesBins)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const auto root = scene(effect, osgLights(testLights(9)));
    root->addChild(osg::createTexturedQuadGeometry({-4, -4, -1.5f}, {8, 0, 0}, {0, 8, 0}));
    const auto before = view_->frame();
    root->getOrCreateStateSet()->setRenderBinDetails(0, "RenderBin",
                                                     osg::StateSet::OVERRIDE_RENDERBIN_DETAILS);
    EXPECT_EQ(view_->frame(), before);
}

TEST_F(SurfacesOf, FollowTheViewport)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    scene(effect, osgLights(testLights(9)));
    const auto whole = view_->frame();
    view_->viewer().getCamera()->setViewport(16, 8, 32, 32);
    view_->offscreen().clear();  // OSG clears the viewport alone
    const auto part = view_->frame();
    EXPECT_GT(meanOf(part, 3), 0.15 * meanOf(whole, 3));
    EXPECT_NEAR(4.0 * meanOf(part, 1), meanOf(whole, 1), 0.05 * meanOf(whole, 1));
    view_->viewer().getCamera()->setViewport(0, 0, kSize, kSize);
    EXPECT_EQ(view_->frame(), whole);
}

/// The effect seen by a camera of its own, and what that camera drew laid over the view.
osg::ref_ptr<osg::Group> throughCamera(osg::Node* scene, const gl::View& view, int samples)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(kSize, kSize);
    texture->setInternalFormat(GL_RGBA32F_ARB);
    texture->setSourceFormat(GL_RGBA);
    texture->setSourceType(GL_FLOAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::COLOR_BUFFER0, texture, 0, 0, false,
                   static_cast<unsigned int>(samples), static_cast<unsigned int>(samples));
    camera->setViewport(0, 0, kSize, kSize);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewMatrix(osgMatrix(view.view));
    camera->setProjectionMatrix(osgMatrix(view.projection));
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setClearColor({0.0f, 0.0f, 0.0f, 0.0f});
    camera->addChild(scene);
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    quad->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    quad->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    osg::ref_ptr<osg::Camera> overlay = new osg::Camera;
    overlay->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    overlay->setRenderOrder(osg::Camera::POST_RENDER);
    overlay->setClearMask(0);
    overlay->setProjectionMatrix(osg::Matrixd::ortho(-1, 1, -1, 1, -1, 1));
    overlay->setViewMatrix(osg::Matrixd::identity());
    overlay->addChild(quad);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(camera);
    root->addChild(overlay);
    return root;
}

// The cull visitor comes back from the camera to the view, and must not begin its bins anew.
TEST_F(SurfacesOf, AreDrawnToInTurnWithACameraInBetween)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (const int lightsPerPass : {1, 2}) {  // what writes where differs from pass to pass
        const auto effect = osgEffect(testMaterials()[4], sphereMesh(24));
        effect->setFloatTarget(false);
        effect->setLightsPerPass(lightsPerPass);
        effect->setLookupsPerPass(lightsPerPass == 1 ? 2 : 5);
        effect->selectTechnique(osgFbrdf::kBatched);
        osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(
            osg::Matrixd::translate(0.2 * static_cast<double>(lightsPerPass), 0.0, 0.0));
        above->addChild(effect);
        root->addChild(above);
    }
    root->addChild(osgLights(testLights(3)));
    view_->setScene(root);
    const auto expected = view_->frame();
    const auto seen = osgEffect(testMaterials()[0], sphereMesh(6));
    root->insertChild(1, throughCamera(seen, perspectiveView(), 0)->getChild(0));
    EXPECT_EQ(view_->frame(), expected);
}

TEST_F(SurfacesOf, WorkWithinACameraThatDrawsToATexture)
{
    const Material material = testMaterials()[4];
    const auto effect = osgEffect(material, sphereMesh(24));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    osg::ref_ptr<osg::Group> inner = new osg::Group;
    inner->addChild(effect);
    inner->addChild(osgLights(testLights(3)));
    view_->setScene(throughCamera(inner, perspectiveView(), 0));
    auto found = view_->frame(), expected = runtimeImage(material, sphereMesh(24), testLights(3));
    for (auto* image : {&found, &expected})  // the overlay is opaque
        for (size_t i = 3; i < image->size(); i += 4) (*image)[i] = 1.0f;
    const auto d = compareImages(found, expected);
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
}

GLenum GL_APIENTRY drawsToNothing(GLenum)
{
    return GL_FRAMEBUFFER_UNSUPPORTED_EXT;
}

// There a pass has as many lights as it has uniforms for, as a sum could not be followed by a
// curve.
TEST_F(SurfacesOf, WhereThereAreNoneTheStrongestLightsAreDrawnInOnePass)
{
    const Material material = testMaterials()[0];
    const auto effect = osgEffect(material, sphereMesh(24));
    effect->setFloatTarget(false);
    effect->setTransfer(Transfer::toneMap);
    effect->setLookupsPerPass(100000);  // a limit that lists do not have: lights are in uniforms
    std::vector<Light> lights = testLights(9), weak;
    for (int i = 0; i < 500; ++i) {
        Light light;
        light.position = {0.01f * static_cast<float>(i), 3.0f, 4.0f};
        light.intensity = Vec3f(1e-6f);
        weak.push_back(light);
    }
    weak.insert(weak.end(), lights.begin(), lights.end());
    const auto node = osgLights(weak);
    view_->draw();
    const unsigned int id =
        view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    osg::GLExtensions::Get(id, true)->glCheckFramebufferStatus = drawsToNothing;
    scene(effect, node);
    const Notices notices;
    view_->frame();
    const auto many = view_->frame();
    EXPECT_EQ(effect->lastReport().technique, "single pass");
    EXPECT_EQ(effect->lastReport().passes, 1);
    EXPECT_GT(effect->lastReport().lightsUsed, 200);
    EXPECT_EQ(effect->lastReport().lightsUsed + effect->lastReport().lightsDropped +
                  effect->lastReport().lightsCulled,
              509);
    EXPECT_NE(notices.text().find("lights are left out"), std::string::npos) << notices.text();
    node->setLights(lights);
    const auto d = compareImages(many, view_->frame());
    EXPECT_LT(d.maxRelative, 1e-2) << describe(d);
    EXPECT_EQ(effect->lastReport().lightsDropped, 0);
    osg::GLExtensions::Set(id, nullptr);
}

bool takesMeans(OsgView& view)
{
    const auto* state = view.viewer().getCamera()->getGraphicsContext()->getState();
    const unsigned int id = state->getContextID();
    return osg::GLExtensions::Get(id, true)->glVersion >= 3.0f ||
           osg::isGLExtensionSupported(id, "GL_ARB_framebuffer_object");
}

/// The effect under three lights, seen with so many samples a pixel.
osg::ref_ptr<osg::Group> sampled(FactorizedBrdf& effect, int samples)
{
    osg::ref_ptr<osg::Group> inner = new osg::Group;
    inner->addChild(&effect);
    inner->addChild(osgLights(testLights(3)));
    return throughCamera(inner, perspectiveView(), samples);
}

/// The largest distance of two pictures that end at 1.
double furthest(const std::vector<float>& a, const std::vector<float>& b)
{
    double most = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(std::min(a[i], 1.0f)) -
                                       static_cast<double>(std::min(b[i], 1.0f))));
    return most;
}

// Samples are shaded at the centre of a pixel, as in a single pass, which needs no surface. Where
// several triangles meet in a pixel their sums are mixed before the last factor and the curve.
constexpr double kNearly = 0.01, kMixed = 0.08;

TEST_F(SurfacesOf, SmoothEdgesWhereTheTargetIsMultisampled)
{
    view_->draw();
    if (!takesMeans(*view_)) GTEST_SKIP() << "needs blits between framebuffers";
    haveSamples(*view_->viewer().getCamera()->getGraphicsContext());
    for (const Form& form : {formPqp(8, 0.5), sumOf(formIo(), formPqp(8, 0.5))})
        for (const Transfer transfer : {Transfer::linear, Transfer::toneMap}) {
            const auto effect = osgEffect(calmMaterial(form), sphereMesh(24));
            effect->setFloatTarget(false);
            effect->setTransfer(transfer);
            effect->setExposure(0.5f);
            effect->selectTechnique(osgFbrdf::kSinglePass);
            effect->setFloatTarget(transfer == Transfer::linear);
            view_->setScene(sampled(*effect, 4));
            const Notices notices;
            const auto expected = view_->frame();
            view_->setScene(sampled(*effect, 0));
            const auto jagged = view_->frame();
            view_->setScene(sampled(*effect, 4));
            effect->setFloatTarget(false);
            for (const int technique : {int(osgFbrdf::kTwoLookups), int(osgFbrdf::kBatched)}) {
                effect->selectTechnique(technique);
                effect->setLightsPerPass(2);
                const auto image = view_->frame();
                EXPECT_EQ(effect->lastReport().accumulation, "RGBA32F");
                EXPECT_EQ(effect->lastReport().reason, "");
                EXPECT_GT(effect->lastReport().passes, 1);
                EXPECT_LT(furthest(image, expected), isCurved(transfer) ? kMixed : kNearly)
                    << form.name << ", technique " << technique;
            }
            EXPECT_EQ(notices.text(), "");
            // This tests the test: without samples edges are elsewhere.
            EXPECT_GT(furthest(jagged, expected), 0.1);
        }
}

TEST_F(SurfacesOf, AreRefusedBesideAMultisampledTargetWhereNothingTakesMeans)
{
    view_->draw();
    if (takesMeans(*view_)) GTEST_SKIP() << "takes means: see osg_as_gl_2.1";
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    view_->setScene(sampled(*effect, 4));
    const Notices notices;
    EXPECT_GT(meanOf(view_->frame(), 0), 0.01);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_NE(notices.text().find("RGBA8"), std::string::npos) << notices.text();
}

}  // namespace
}  // namespace fbrdf::test
