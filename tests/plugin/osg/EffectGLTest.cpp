// The effect in OpenSceneGraph against the plain runtime, and the traps of osgFX.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/BlendFunc>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Optimizer>

#include <cstdio>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// The plugin runs the same programs on the same numbers; only the order differs in which a matrix
// product is rounded.
constexpr double kAgainstRuntime = 1e-4;
// The same view comes of other matrices here: rounding moves positions by some 1e-7.
constexpr double kMoved = 1e-3;

class Effect : public EffectTest {
protected:
    void compareWithRuntime(const Material& material, const gl::MeshData& mesh,
                            const std::vector<int>& counts);
};

void Effect::compareWithRuntime(const Material& material, const gl::MeshData& mesh,
                                const std::vector<int>& counts)
{
    const auto effect = osgEffect(material, mesh);
    const auto lights = osgLights({});
    scene(effect, lights);
    double worst = 0.0;
    const Notices notices;
    for (const int count : counts) {
        const auto expected = runtimeImage(material, mesh, testLights(count));
        lights->setLights(testLights(count));
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            effect->selectTechnique(technique);
            const auto d = compareImages(view_->frame(), expected);
            EXPECT_TRUE(d.comparable);
            EXPECT_LT(d.maxRelative, kAgainstRuntime)
                << count << " lights, technique " << technique << ": " << describe(d);
            EXPECT_EQ(effect->lastReport().lightsUsed + effect->lastReport().lightsCulled, count);
            EXPECT_GE(effect->lastReport().lightsUsed, 1);
            EXPECT_EQ(effect->lastReport().reason, "");
            const int limit = kTechniques[static_cast<size_t>(technique)].maxLookups;
            EXPECT_TRUE(limit == 0 || effect->lastReport().maxLookups <= limit);
            worst = std::max(worst, d.maxRelative);
        }
    }
    std::printf("%s: max relative difference to the runtime %.2e\n", material.name.c_str(), worst);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(notices.text(), "");  // OSG_GL_ERROR_CHECKING writes here
}

TEST_F(Effect, PqpEqualsTheRuntime)
{
    compareWithRuntime(testMaterials()[0], sphereMesh(24), {1, 9, 64, 200});
}

TEST_F(Effect, PqprWithKnotsInUniformsEqualsTheRuntime)
{
    compareWithRuntime(testMaterials()[1], knotMesh(96, 16), {1, 9, 64, 200});
}

TEST_F(Effect, HdioEqualsTheRuntime)
{
    compareWithRuntime(testMaterials()[2], sphereMesh(24), {1, 9, 64, 200});
}

TEST_F(Effect, ALostLightIsNoticed)
{
    const Material material = testMaterials()[0];
    const auto expected = runtimeImage(material, sphereMesh(24), testLights(9));
    const auto effect = osgEffect(material, sphereMesh(24));
    auto lights = testLights(9);
    lights.pop_back();
    scene(effect, osgLights(lights));
    EXPECT_GT(compareImages(view_->frame(), expected).maxRelative, 10.0 * kAgainstRuntime);
}

// osgFX chooses a technique while it draws: an effect added to a running viewer would vanish for
// one frame.
TEST_F(Effect, AddedLateItIsThereAtOnce)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(osgLights(testLights(9)));
    view_->setScene(root);
    EXPECT_EQ(meanOf(view_->frame(), 3), 0.0);
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    root->addChild(effect);
    const auto first = view_->frame(), second = view_->frame();
    EXPECT_GT(meanOf(first, 3), 0.1);
    EXPECT_EQ(first, second);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
}

osg::ref_ptr<osg::Node> filter(float z)
{
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry({-5, -5, z}, {10, 0, 0}, {0, 10, 0});
    osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array;
    colour->push_back({0.0f, 0.0f, 0.0f, 0.75f});
    quad->setColorArray(colour, osg::Array::BIND_OVERALL);
    osg::StateSet* state = quad->getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setAttributeAndModes(new osg::BlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA));
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    return quad;
}

// Pass i of osgFX is drawn in bin i, and what is transparent in bin 10.
TEST_F(Effect, ManyPassesComeBeforeWhatIsTransparent)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const auto root = scene(effect, osgLights(testLights(40)));
    auto plain = view_->frame();
    EXPECT_GT(effect->lastReport().passes, 40);
    root->insertChild(0, filter(1.5f));
    const auto before = view_->frame();
    for (float& value : plain) value *= 0.25f;
    EXPECT_LT(compareImages(before, plain).maxRelative, 1e-5);
    root->replaceChild(root->getChild(0), filter(-1.5f));
    const auto behind = view_->frame();
    for (float& value : plain) value *= 4.0f;
    EXPECT_LT(compareImages(behind, plain).maxRelative, 1e-5);
}

TEST_F(Effect, LightsFollowTransforms)
{
    const Material material = testMaterials()[2];
    const auto lights = testLights(9);
    const auto expected = runtimeImage(material, sphereMesh(24), lights);
    const osg::Matrixd move =
        osg::Matrixd::rotate(0.7, 0.2, 0.9, 0.1) * osg::Matrixd::translate(1.0, -2.0, 3.0);
    // Object and lights are moved together, each under a transform of its own; so is the camera.
    osg::ref_ptr<osg::MatrixTransform> object = new osg::MatrixTransform(move),
                                       above = new osg::MatrixTransform(move),
                                       root = new osg::MatrixTransform;
    object->addChild(osgEffect(material, sphereMesh(24)));
    above->addChild(osgLights(lights));
    root->addChild(object);
    root->addChild(above);
    view_->setScene(root);
    view_->viewer().getCamera()->setViewMatrix(osg::Matrixd::inverse(move) *
                                               osgMatrix(perspectiveView().view));
    const auto d = compareImages(view_->frame(), expected);
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
    above->setMatrix(osg::Matrixd::identity());
    EXPECT_GT(compareImages(view_->frame(), expected).maxRelative, 10.0 * kMoved);
}

TEST_F(Effect, LightSourcesAreSeen)
{
    const Material material = testMaterials()[2];
    Light light;
    light.position = {1.0f, 2.0f, 3.0f};
    light.intensity = Vec3f(0.5f, 0.25f, 1.0f) * static_cast<float>(kPi);
    osg::ref_ptr<osg::Light> plain = new osg::Light(0);
    plain->setPosition({1.0f, 2.0f, 3.0f, 1.0f});
    plain->setDiffuse({0.5f, 0.25f, 1.0f, 1.0f});
    plain->setConstantAttenuation(0.0f);
    plain->setQuadraticAttenuation(1.0f);
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(plain);
    scene(osgEffect(material, sphereMesh(24)), source);
    const auto d = compareImages(view_->frame(), runtimeImage(material, sphereMesh(24), {light}));
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
}

TEST_F(Effect, ExposureIsAFactor)
{
    const auto effect = osgEffect(testMaterials()[1], sphereMesh(24));
    scene(effect, osgLights(testLights(9)));
    auto expected = view_->frame();
    for (size_t i = 0; i < expected.size(); ++i) expected[i] *= i % 4 == 3 ? 1.0f : 4.0f;
    effect->setExposure(4.0f);
    EXPECT_LT(compareImages(view_->frame(), expected).maxRelative, 1e-6);
}

TEST_F(Effect, TwoContextsDrawTheSame)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto first = view_->frame();
    {
        const auto other = newContext();
        OsgView second(other->loader());
        second.setView(perspectiveView());
        second.setScene(root);
        EXPECT_EQ(second.frame(), first);
        root->releaseGLObjects(second.viewer().getCamera()->getGraphicsContext()->getState());
    }
    context().makeCurrent();
    EXPECT_EQ(view_->frame(), first);
}

// With tangents OSG 3.6.5 alone crashes here: it takes arrays that it dispatched before for arrays
// that OpenGL still has.
TEST_F(Effect, GlObjectsCanBeReleasedAndMadeAnew)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto first = view_->frame();
    root->releaseGLObjects();
    root->resizeGLObjectBuffers(4);
    EXPECT_EQ(view_->frame(), first);
}

TEST_F(Effect, WithoutMaterialTheFallbackIsDrawnWithAWarning)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    const Notices notices;
    EXPECT_FALSE(effect->setMaterialFile("no-such-material.fbrdf"));
    EXPECT_NE(notices.text().find("no-such-material.fbrdf"), std::string::npos) << notices.text();
    effect->addChild(osgMesh(sphereMesh(24)));
    const auto lights = osgLights({});
    scene(effect, lights);
    for (int i = 0; i < 20; ++i) lights->addDirectional({0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f});
    EXPECT_GT(meanOf(view_->frame(), 0), 0.05);
    EXPECT_GT(meanOf(view_->frame(), 0), 0.05);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_EQ(effect->lastReport().lightsUsed, 8);
    EXPECT_EQ(effect->lastReport().lightsDropped, 12);
}

/// The sphere with a texture coordinate s that increases along its tangents.
osg::ref_ptr<FactorizedBrdf> wrappedSphere(const Material& material, bool derived)
{
    const auto effect = osgEffect(material, sphereMesh(24));
    osg::Geometry& sphere = *effect->getChild(0)->asGeometry();
    osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (int i = 0; i <= 24; ++i)
        for (int j = 0; j <= 48; ++j)
            coordinates->push_back(
                {static_cast<float>(j) / 48.0f, 1.0f - static_cast<float>(i) / 24.0f});
    sphere.setTexCoordArray(0, coordinates, osg::Array::BIND_PER_VERTEX);
    if (derived) sphere.setVertexAttribArray(osgFbrdf::kTangentAttribute, nullptr);
    effect->setDerivedTangents(derived);
    return effect;
}

TEST_F(Effect, FilteringInTheShaderDrawsTheSame)
{
    for (const int index : {0, 4}) {
        const Material material = testMaterials()[static_cast<size_t>(index)];
        const auto expected = runtimeImage(material, sphereMesh(24), testLights(9));
        const auto effect = osgEffect(material, sphereMesh(24));
        effect->setPreciseFiltering(true);
        scene(effect, osgLights(testLights(9)));
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            effect->selectTechnique(technique);
            const auto d = compareImages(view_->frame(), expected);
            EXPECT_LT(d.maxRelative, kAgainstRuntime) << technique << ": " << describe(d);
            EXPECT_EQ(effect->lastReport().reason, "");
        }
        // And off again: the texture filters once more.
        if (filtersCoarsely()) continue;
        effect->setPreciseFiltering(false);
        EXPECT_LT(compareImages(view_->frame(), expected).maxRelative, kAgainstRuntime);
    }
}

TEST_F(Effect, TangentsAreDerivedFromTextureCoordinates)
{
    const Material material = testMaterials()[0];
    const auto expected = runtimeImage(material, sphereMesh(24), testLights(9));
    scene(wrappedSphere(material, true), osgLights(testLights(9)));
    // A tangent is that of a triangle here and not interpolated over it, and another one at the
    // seam and the poles, so the pictures are close on average only.
    EXPECT_LT(compareImages(view_->frame(), expected).meanRelative, 0.03);
    const auto without = osgEffect(material, sphereMesh(24));
    without->getChild(0)->asGeometry()->setVertexAttribArray(osgFbrdf::kTangentAttribute, nullptr);
    scene(without, osgLights(testLights(9)));
    EXPECT_GT(compareImages(view_->frame(), expected).meanRelative, 0.1);
}

TEST_F(Effect, IntersectionsSeeTheModelOnce)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const auto root = scene(effect, osgLights(testLights(9)));
    view_->frame();
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line = new osgUtil::LineSegmentIntersector(
        osg::Vec3d(0.01, 0.02, 5.0), osg::Vec3d(0.01, 0.02, -5.0));
    osgUtil::IntersectionVisitor visitor(line);
    root->accept(visitor);
    EXPECT_EQ(line->getIntersections().size(), 2u);
}

TEST_F(Effect, TheOptimizerLeavesItIntact)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto before = view_->frame();
    osgUtil::Optimizer().optimize(root, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS);
    EXPECT_EQ(view_->frame(), before);
}

TEST_F(Effect, InvalidLightsAreCounted)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    auto lights = testLights(4);
    lights.push_back({Light::Type::directional, Vec3f(0.0f), Vec3f(1.0f), 0.0f});
    scene(effect, osgLights(lights));
    view_->frame();
    EXPECT_EQ(effect->lastReport().lightsUsed, 4);
    EXPECT_EQ(effect->lastReport().lightsDropped, 1);
}

}  // namespace
}  // namespace fbrdf::test
