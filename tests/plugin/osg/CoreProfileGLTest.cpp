// Contexts without fixed function (macOS, osgEarth) show what others show, beside them or alone, in
// every technique; where nothing can be drawn, one line of the log says why.
#include "AreaLightsTest.h"
#include "EffectTest.h"
#include "EglWindow.h"
#include "EnvironmentTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/DisplaySettings>
#include <osg/Fog>
#include <osg/LightSource>
#include <osgShadow/ShadowedScene>
#include <osgShadow/StandardShadowMap>
#include <osgViewer/CompositeViewer>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using Picture = std::vector<float>;
using Profile = EglWindow::Profile;

// The same formulas in another version of GLSL, with matrices that come another way.
constexpr double kSame = 1e-5;
// OpenGL's own fog, of the fallback, interpolates the distance, ours the position; its lights have
// powers of their own.
constexpr double kAgainstOpenGl = 3e-4;

osg::ref_ptr<EglWindow> windowOf(Profile profile, bool osgInputs = true)
{
    osg::ref_ptr<EglWindow> window = new EglWindow(kSize, nullptr, profile);
    const bool own = profile == Profile::core && osgInputs;
    window->getState()->setUseModelViewAndProjectionUniforms(own);
    window->getState()->setUseVertexAttributeAliasing(own);
    return window;
}

/// What the second frame of the scene shows in windows that are open at the same time.
std::vector<Picture> shownIn(osg::Node* scene, const std::vector<osg::ref_ptr<EglWindow>>& windows)
{
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    for (const auto& window : windows) viewer.addView(viewIn(*window, scene));
    viewer.realize();
    for (int frame = 0; frame < 2; ++frame) viewer.frame();
    std::vector<Picture> pictures;
    for (const auto& window : windows) pictures.push_back(window->picture(1));
    return pictures;
}

/// Lines without what differs from run to run.
std::set<std::string> linesOf(const std::string& text)
{
    std::set<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.insert(std::regex_replace(line, std::regex(" 0x[0-9a-f]{6,}$"), ""));
    return lines;
}

class CoreProfile : public OsgTest {
protected:
    void SetUp() override
    {
        OsgTest::SetUp();
        hint_ = osg::DisplaySettings::instance()->getVertexBufferHint();
        osg::DisplaySettings::instance()->setVertexBufferHint(
            osg::DisplaySettings::VERTEX_ARRAY_OBJECT);
    }
    void TearDown() override { osg::DisplaySettings::instance()->setVertexBufferHint(hint_); }

    osg::ref_ptr<FactorizedBrdf> effect(size_t material = 0)
    {
        const auto effect = osgEffect(testMaterials()[material], sphereMesh(16));
        root_->addChild(effect);
        return effect;
    }

    /// Both kinds of windows show the same, beside each other and the core profile alone.
    void expectSame(FactorizedBrdf& effect, const std::string& what, double bound = kSame)
    {
        const Notices notices;  // OpenSceneGraph's own errors: see LogsNothingOfOurs
        const auto both =
            shownIn(root_, {windowOf(Profile::compatibility), windowOf(Profile::core)});
        EXPECT_GT(meanOf(both[0], 0), 0.01) << what;
        const auto d = compareImages(both[1], both[0]);
        EXPECT_LT(d.maxRelative, bound) << what << ": " << describe(d);
        EXPECT_EQ(effect.lastReport().reason, "") << what;
        EXPECT_EQ(effect.lastReport().whyNoEnvironment, "") << what;
        effect.releaseGLObjects();  // the choice of technique, too
        EXPECT_TRUE(shownIn(root_, {windowOf(Profile::core)})[0] == both[1]) << what;
    }

    /// The lines of the log, and a picture, of a core profile alone.
    std::set<std::string> log(osg::Node* scene, bool osgInputs = true)
    {
        const Notices notices;
        picture_ = shownIn(scene, {windowOf(Profile::core, osgInputs)})[0];
        return linesOf(notices.text());
    }

    const osg::ref_ptr<osg::Group> root_ = new osg::Group;
    Picture picture_;

private:
    osg::DisplaySettings::VertexBufferHint hint_ = osg::DisplaySettings::NO_PREFERENCE;
};

TEST_F(CoreProfile, ShowsEveryTechniqueWithSurfacesAndWithout)
{
    root_->addChild(osgLights(testLights(9)));
    for (const size_t material : {size_t(0), size_t(2), size_t(4)}) {
        const auto effect = this->effect(material);
        for (int technique = 0; technique < osgFbrdf::kDiffuseFallback; ++technique)
            for (const bool floatTarget : {true, false}) {
                effect->selectTechnique(technique);
                effect->setFloatTarget(floatTarget);
                effect->setTransfer(floatTarget ? Transfer::linear : Transfer::toneMap);
                expectSame(*effect, std::to_string(material) + effect->lastReport().technique);
            }
        root_->removeChild(effect);
    }
}

// This tests the test.
TEST_F(CoreProfile, OfAnotherExposureIsNoticed)
{
    root_->addChild(osgLights(testLights(9)));
    const auto effect = this->effect();
    const Notices notices;
    const Picture expected = shownIn(root_, {windowOf(Profile::compatibility)})[0];
    effect->setExposure(1.0001f);
    EXPECT_GT(compareImages(shownIn(root_, {windowOf(Profile::core)})[0], expected).maxRelative,
              5.0 * kSame);
}

TEST_F(CoreProfile, ShowsTheFallback)
{
    root_->addChild(osgLights(testLights(9)));
    const auto effect = this->effect();
    effect->selectTechnique(osgFbrdf::kDiffuseFallback);
    expectSame(*effect, "lights", kAgainstOpenGl);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_EQ(effect->lastReport().lightsUsed, 8);
    root_->addChild(uprightFor(osgEnvironment(testPanorama(8))));
    expectSame(*effect, "environment", kAgainstOpenGl);
}

osg::ref_ptr<osg::LightSource> coneSource(int number)
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    osg::Light& light = *source->getLight();
    light.setLightNum(number);
    light.setPosition({number == 0 ? 2.0f : -1.5f, 1.5f, 2.0f, 1.0f});
    light.setDirection({number == 0 ? -2.0f : 1.5f, -1.5f, -2.0f});
    light.setSpotCutoff(number == 0 ? 20.0f : 60.0f);
    light.setSpotExponent(number == 0 ? 0.0f : 3.0f);
    light.setDiffuse({0.9f, 0.7f, 0.4f, 1.0f});
    light.setConstantAttenuation(0.5f);
    light.setLinearAttenuation(0.2f);
    return source;
}

TEST_F(CoreProfile, ShowsLightsOfOpenSceneGraph)
{
    osg::StateSet& state = *root_->getOrCreateStateSet();
    for (int number = 0; number < 2; ++number) {
        root_->addChild(coneSource(number));
        state.setMode(GL_LIGHT0 + static_cast<GLenum>(number), osg::StateAttribute::ON);
    }
    const auto effect = this->effect();
    for (const int technique : {0, int(osgFbrdf::kTwoLookups), int(osgFbrdf::kDiffuseFallback)}) {
        effect->selectTechnique(technique);
        expectSame(*effect, std::to_string(technique), technique < 3 ? kSame : kAgainstOpenGl);
        EXPECT_EQ(effect->lastReport().lightsUsed, 2);
    }
}

TEST_F(CoreProfile, ShowsFog)
{
    root_->addChild(osgLights(testLights(3)));
    const osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setStart(2.0f);
    fog->setEnd(5.0f);
    fog->setDensity(0.2f);
    fog->setColor({0.5f, 0.25f, 1.0f, 1.0f});
    root_->getOrCreateStateSet()->setAttributeAndModes(fog);
    const auto effect = this->effect();
    for (const auto mode : {osg::Fog::LINEAR, osg::Fog::EXP, osg::Fog::EXP2})
        for (const int technique : {int(osgFbrdf::kSinglePass), int(osgFbrdf::kDiffuseFallback)}) {
            fog->setMode(mode);
            effect->selectTechnique(technique);
            expectSame(*effect, "fog", kAgainstOpenGl);
        }
}

TEST_F(CoreProfile, ShowsEnvironmentsAreaLightsAndDerivedTangents)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto effect = osgEffect(material, sphereMesh(16));
    osg::Geometry& sphere = *effect->getChild(0)->asGeometry();
    const osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (unsigned int i = 0; i < sphere.getVertexArray()->getNumElements(); ++i)
        coordinates->push_back({static_cast<float>(i % 33), static_cast<float>(i / 33)});
    sphere.setTexCoordArray(0, coordinates, osg::Array::BIND_PER_VERTEX);
    root_->addChild(effect);
    root_->addChild(osgLights(testLights(3)));
    root_->addChild(uprightFor(osgEnvironment(testPanorama(16))));
    root_->addChild(osgAreaLights({areaLightOf(AreaLight::Shape::sphere)}));
    for (const bool derived : {false, true})
        for (const int technique : {int(osgFbrdf::kSinglePass), int(osgFbrdf::kTwoLookups)}) {
            effect->setDerivedTangents(derived);
            effect->selectTechnique(technique);
            expectSame(*effect, derived ? "derived" : "attribute");
        }
}

// Textures of OpenSceneGraph compare no depths there.
TEST_F(CoreProfile, ShowsNoShadowsAndSaysWhy)
{
    const osg::ref_ptr<osgShadow::ShadowTechnique> technique = new osgShadow::StandardShadowMap;
    const osg::ref_ptr<osg::Group> scene = new osgShadow::ShadowedScene(technique);
    scene->addChild(coneSource(0));
    const auto effect = this->effect();
    scene->addChild(effect);
    const auto lines = log(scene);
    EXPECT_GT(meanOf(picture_, 0), 0.01);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
    EXPECT_EQ(effect->lastReport().whyNoShadows,
              "found no textures that compare depths, expected a compatibility profile");
    EXPECT_EQ(lines.count("osgFbrdf: an effect without a name: drawn without shadows: " +
                          effect->lastReport().whyNoShadows),
              1u);
}

// Debian's OpenSceneGraph makes errors of its own there; the effect adds none.
TEST_F(CoreProfile, LogsNothingOfOurs)
{
    root_->getOrCreateStateSet()->setAttributeAndModes(new osg::Fog);
    root_->addChild(osgMesh(sphereMesh(4)));
    const auto ordinary = log(root_);
    EXPECT_GT(ordinary.size(), 0u);  // it is fixed function that is not there
    root_->addChild(osgLights(testLights(9)));
    root_->addChild(uprightFor(osgEnvironment(testPanorama(8))));
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(8));
    effect->setFloatTarget(false);
    root_->addChild(effect);
    for (int technique = 0; technique <= osgFbrdf::kDiffuseFallback; ++technique) {
        effect->selectTechnique(technique);
        for (const std::string& line : log(root_))
            EXPECT_TRUE(ordinary.count(line)) << "technique " << technique << ": " << line;
        EXPECT_GT(meanOf(picture_, 3), 0.3) << "technique " << technique;
    }
}

// Models are display lists by default, which core profiles do not have.
TEST_F(CoreProfile, ShowsModelsThatAreDisplayListsAndSaysSo)
{
    root_->addChild(osgLights(testLights(9)));
    const auto effect = this->effect();
    log(root_);
    const Picture expected = picture_;
    osg::DisplaySettings::instance()->setVertexBufferHint(osg::DisplaySettings::NO_PREFERENCE);
    osg::Geometry& sphere = *effect->getChild(0)->asGeometry();
    sphere.setUseVertexBufferObjects(false);
    sphere.setUseDisplayList(true);
    const auto lines = log(root_);
    EXPECT_TRUE(picture_ == expected);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const std::string& line) {
                                return line.find("found a core profile") != std::string::npos;
                            }),
              1);
}

TEST_F(CoreProfile, ShowsAnEffectThatIsAddedLateAtOnce)
{
    osg::DisplaySettings::instance()->setVertexBufferHint(osg::DisplaySettings::NO_PREFERENCE);
    root_->addChild(osgLights(testLights(9)));
    const Notices notices;
    const osg::ref_ptr<EglWindow> window = windowOf(Profile::core);
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer.addView(viewIn(*window, root_));
    viewer.realize();
    viewer.frame();
    const auto effect = this->effect();
    for (int frame = 1; frame < 3; ++frame) viewer.frame();
    EXPECT_EQ(meanOf(window->picture(0), 3), 0.0);
    EXPECT_GT(meanOf(window->picture(1), 3), 0.3);
    EXPECT_TRUE(window->picture(1) == window->picture(2));
}

TEST_F(CoreProfile, WithoutOsgsInputsShowsNothingAndSaysWhy)
{
    root_->addChild(osgLights(testLights(9)));
    const auto effect = this->effect();
    effect->setName("ball");
    const auto lines = log(root_, false);
    EXPECT_EQ(meanOf(picture_, 3), 0.0);
    EXPECT_EQ(effect->lastReport().technique, "nothing");
    EXPECT_EQ(effect->lastReport().passes, 0);
    EXPECT_NE(effect->lastReport().reason.find("found a core profile"), std::string::npos);
    EXPECT_EQ(lines.count("osgFbrdf: 'ball': nothing is drawn: " + effect->lastReport().reason),
              1u);
    // Other contexts have the fallback then, as techniques are chosen for all.
    const Notices notices;
    const auto pictures =
        shownIn(root_, {windowOf(Profile::core, false), windowOf(Profile::compatibility)});
    EXPECT_EQ(meanOf(pictures[0], 3), 0.0);
    EXPECT_GT(meanOf(pictures[1], 3), 0.3);
}

}  // namespace
}  // namespace fbrdf::test
