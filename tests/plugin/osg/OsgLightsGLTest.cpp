// osg::Lights light the effect as OpenGL lights: OpenGL draws the same sphere beside ours.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/LOD>
#include <osg/Material>
#include <osg/MatrixTransform>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// OpenGL lights vertices and interpolates colours, here of a sphere of 192 columns.
constexpr double kAgainstVertices = 4e-3;

/// A material of 1 / pi everywhere: a white Lambertian.
Material white()
{
    Material material;
    material.name = "white";
    material.form = formHdio({4, 4, 4});
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.texels.assign(3 * static_cast<size_t>(texelCount(spec.domain)), 0.0f);
        material.tables.push_back(quantized(table, Storage::log8));
    }
    material.scales.emplace_back(static_cast<float>(1.0 / kPi));
    return material;
}

osg::ref_ptr<osg::LightSource> sourceOf(osg::Light* light)
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(light);
    return source;
}

/// The node under the modes that OpenGL needs.
osg::ref_ptr<osg::Group> lit(osg::Node* node, const std::vector<osg::ref_ptr<osg::Light>>& lights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(node);
    osg::StateSet& state = *root->getOrCreateStateSet();
    state.setMode(GL_LIGHTING, osg::StateAttribute::ON);
    osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
    model->setAmbientIntensity({0.0f, 0.0f, 0.0f, 1.0f});
    state.setAttributeAndModes(model);
    for (const auto& light : lights) {
        root->addChild(sourceOf(light));
        state.setMode(GL_LIGHT0 + static_cast<GLenum>(light->getLightNum()),
                      osg::StateAttribute::ON);
    }
    return root;
}

osg::ref_ptr<osg::Light> lightAt(unsigned int number, const osg::Vec4f& position)
{
    osg::ref_ptr<osg::Light> light = new osg::Light(number);
    light->setPosition(position);
    light->setAmbient({0.0f, 0.0f, 0.0f, 1.0f});
    light->setSpecular({0.0f, 0.0f, 0.0f, 1.0f});
    light->setDiffuse({0.4f, 0.3f, 0.2f, 1.0f});
    return light;
}

class OsgLights : public EffectTest {
protected:
    std::vector<float> ours(const std::vector<osg::ref_ptr<osg::Light>>& lights)
    {
        effect_ = osgEffect(white(), sphereMesh(96));
        view_->setScene(lit(effect_, lights));
        return view_->frame();
    }

    std::vector<float> openGls(const std::vector<osg::ref_ptr<osg::Light>>& lights)
    {
        osg::ref_ptr<osg::Geometry> sphere = osgMesh(sphereMesh(96));
        osg::ref_ptr<osg::Material> material = new osg::Material;
        material->setAmbient(osg::Material::FRONT_AND_BACK, {0.0f, 0.0f, 0.0f, 1.0f});
        material->setDiffuse(osg::Material::FRONT_AND_BACK, {1.0f, 1.0f, 1.0f, 1.0f});
        sphere->getOrCreateStateSet()->setAttributeAndModes(material);
        view_->setScene(lit(sphere, lights));
        return view_->frame();
    }

    void expectSame(const std::vector<osg::ref_ptr<osg::Light>>& lights, const std::string& what)
    {
        const auto expected = openGls(lights), found = ours(lights);
        EXPECT_GT(meanOf(expected, 0), 0.005) << what;
        double worst = 0.0;
        for (size_t i = 0; i < found.size(); ++i)
            worst = std::max(
                worst, std::abs(static_cast<double>(found[i]) - static_cast<double>(expected[i])));
        EXPECT_LT(worst, kAgainstVertices) << what;
        EXPECT_EQ(effect_->lastReport().lightsUsed, static_cast<int>(lights.size()));
    }

    osg::ref_ptr<FactorizedBrdf> effect_;
};

TEST_F(OsgLights, AttenuationIsThatOfOpenGl)
{
    for (const auto& [constant, linear, quadratic] : std::vector<std::array<float, 3>>{
             {1.0f, 0.0f, 0.0f}, {0.0f, 0.7f, 0.0f}, {0.0f, 0.0f, 0.5f}, {0.5f, 0.25f, 0.125f}}) {
        // The light is so close that the distance doubles over the sphere.
        const auto light = lightAt(0, {0.4f, 0.3f, 2.2f, 1.0f});
        light->setConstantAttenuation(constant);
        light->setLinearAttenuation(linear);
        light->setQuadraticAttenuation(quadratic);
        expectSame({light}, "attenuation " + std::to_string(constant) + ", " +
                                std::to_string(linear) + ", " + std::to_string(quadratic));
    }
}

TEST_F(OsgLights, ConesAreThoseOfOpenGl)
{
    for (const float exponent : {1.0f, 8.0f, 40.0f}) {
        const auto light = lightAt(2, {0.5f, 0.5f, 4.0f, 1.0f});
        light->setDirection({-0.125f, -0.05f, -1.0f});
        light->setSpotCutoff(80.0f);
        light->setSpotExponent(exponent);
        expectSame({light}, "exponent " + std::to_string(exponent));
    }
}

TEST_F(OsgLights, ADirectionalOneIsNotAttenuated)
{
    expectSame({lightAt(5, {1.0f, 1.0f, 2.0f, 0.0f})}, "directional");
}

TEST_F(OsgLights, EightOfThemAddUp)
{
    std::vector<osg::ref_ptr<osg::Light>> lights;
    for (unsigned int number = 0; number < 8; ++number) {
        const float angle = 0.8f * static_cast<float>(number);
        lights.push_back(
            lightAt(number, {2.5f * std::cos(angle), 2.5f * std::sin(angle), 2.0f, 1.0f}));
        lights.back()->setDiffuse({0.1f, 0.05f, 0.02f, 1.0f});
        lights.back()->setConstantAttenuation(0.3f * static_cast<float>(number));
        lights.back()->setLinearAttenuation(0.2f);
    }
    expectSame(lights, "eight");
    for (const int technique : {osgFbrdf::kBatched, osgFbrdf::kTwoLookups}) {
        const auto single = ours(lights);
        effect_->selectTechnique(technique);
        const auto d = compareImages(view_->frame(), single);
        EXPECT_LT(d.maxRelative, 1e-5) << describe(d);
    }
}

// Each batch of lights has the right attenuations.
TEST_F(OsgLights, AttenuationIsKeptAmongHundredsOfOthers)
{
    std::vector<Light> many;
    for (int i = 0; i < 300; ++i) {
        Light light;
        light.position = {std::cos(0.3f * static_cast<float>(i)), 2.0f, 3.0f};
        light.intensity = Vec3f(0.01f);
        many.push_back(light);
    }
    const auto plain = lightAt(0, {-2.0f, 0.5f, 3.0f, 1.0f});
    plain->setLinearAttenuation(0.3f);
    effect_ = osgEffect(white(), sphereMesh(24));
    effect_->setLookupsPerPass(100000);  // a limit that lists do not have: lights are in uniforms
    const auto root = lit(effect_, {plain});
    view_->setScene(root);
    const auto alone = view_->frame();
    const auto node = osgLights(many);
    root->addChild(node);
    const auto both = view_->frame();
    EXPECT_EQ(effect_->lastReport().passes, 2);  // an attenuated light needs more uniforms
    root->removeChild(1);
    auto sum = view_->frame();
    EXPECT_EQ(effect_->lastReport().passes, 1);
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) sum[i] += alone[i];
    const auto d = compareImages(both, sum);
    EXPECT_LT(d.maxRelative, 1e-4) << describe(d);
    root->addChild(sourceOf(plain));
    effect_->selectTechnique(osgFbrdf::kTwoLookups);
    const auto one = compareImages(view_->frame(), both);
    EXPECT_LT(one.maxRelative, 1e-4) << describe(one);
}

// A light for whose attenuation a program has no room is right in the middle of the object.
TEST_F(OsgLights, TheNinthIsTakenWhereTheObjectIs)
{
    std::vector<osg::ref_ptr<osg::Light>> eight, nine;
    for (unsigned int number = 0; number < 8; ++number)
        eight.push_back(lightAt(number, {0.0f, 0.0f, -50.0f, 1.0f}));
    osg::ref_ptr<osg::Group> root = lit(osgEffect(white(), sphereMesh(96)), eight);
    const auto ninth = lightAt(0, {0.0f, 0.0f, 30.0f, 1.0f});
    root->addChild(sourceOf(ninth));
    view_->setScene(root);
    const auto found = view_->frame();
    const auto expected = ours({ninth});
    EXPECT_GT(meanOf(expected, 0), 0.05);
    // No point of the sphere is farther from its middle than 2 of the 30 to the light.
    EXPECT_NEAR(meanOf(found, 0), meanOf(expected, 0), 0.1 * meanOf(expected, 0));
}

TEST_F(OsgLights, ALightWhoseModeIsOffIsOff)
{
    const auto key = lightAt(0, {1.0f, 1.0f, 4.0f, 1.0f}),
               fill = lightAt(1, {-3.0f, 0.0f, 2.0f, 1.0f});
    const auto both = ours({key, fill});
    effect_->getOrCreateStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::OFF);
    const auto one = view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed, 1);
    EXPECT_NE(one, both);
    effect_->selectTechnique(osgFbrdf::kDiffuseFallback);
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed, 1);
    EXPECT_EQ(one, ours({key}));
}

TEST_F(OsgLights, AreSeenThroughTheMaskOfTheView)
{
    const auto hidden = osgLights(testLights(2));
    hidden->setNodeMask(0x2);
    effect_ = osgEffect(testMaterials()[0], sphereMesh(24));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect_);
    root->addChild(hidden);
    root->addChild(osgLights(testLights(5)));
    view_->setScene(root);
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed + effect_->lastReport().lightsCulled, 7);
    view_->viewer().getCamera()->setCullMask(~0x2u);
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed + effect_->lastReport().lightsCulled, 5);
}

TEST_F(OsgLights, LevelsOfDetailOfLightsAreThoseOfTheView)
{
    osg::ref_ptr<osg::LOD> levels = new osg::LOD;
    levels->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
    levels->setCenter({0.0f, 0.0f, 0.0f});
    levels->setRadius(1.0f);
    levels->addChild(osgLights(testLights(5)), 0.0f, 20.0f);
    levels->addChild(osgLights(testLights(2)), 20.0f, 1000.0f);
    osg::ref_ptr<osg::MatrixTransform> aside = new osg::MatrixTransform;
    aside->addChild(levels);
    effect_ = osgEffect(testMaterials()[0], sphereMesh(24));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect_);
    root->addChild(aside);
    view_->setScene(root);
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed + effect_->lastReport().lightsCulled, 5);
    aside->setMatrix(osg::Matrixd::translate(0.0, 0.0, -100.0));
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed + effect_->lastReport().lightsCulled, 2);
}

// A light that cannot reach the object costs no pass.
TEST_F(OsgLights, LightsOutOfReachAreCulled)
{
    std::vector<Light> lights = testLights(3);
    for (Light& light : lights) light.radius = 0.0f;
    const int near = 3;
    for (int i = 0; i < 500; ++i) {
        Light far;
        far.position = {100.0f + static_cast<float>(i), 0.0f, 0.0f};
        far.radius = 50.0f;
        lights.push_back(far);
    }
    effect_ = osgEffect(testMaterials()[2], sphereMesh(24));
    effect_->selectTechnique(osgFbrdf::kTwoLookups);
    // A scale above the object makes it larger, and the light is still far away.
    osg::ref_ptr<osg::MatrixTransform> larger =
        new osg::MatrixTransform(osg::Matrixd::scale(2.0, 1.0, 1.5));
    larger->addChild(effect_);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(larger);
    root->addChild(osgLights(lights));
    view_->setScene(root);
    const auto culled = view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsUsed, near);
    EXPECT_EQ(effect_->lastReport().lightsCulled, 500);
    EXPECT_EQ(effect_->lastReport().lightsDropped, 0);
    lights.resize(near);
    osg::ref_ptr<osg::Group> few = new osg::Group;
    few->addChild(larger);
    few->addChild(osgLights(lights));
    view_->setScene(few);
    EXPECT_EQ(view_->frame(), culled);
}

}  // namespace
}  // namespace fbrdf::test
