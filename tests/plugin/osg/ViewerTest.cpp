// The real osgviewer in a window (Xvfb), set up by OSG_LIBRARY_PATH alone, shows a scene file with
// 64 lights in every threading model, with what real scenes have beside the effect, while a user
// acts.
#include "EnvironmentTest.h"
#include "OsgviewerTest.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Fog>
#include <osg/LightSource>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/PagedLOD>
#include <osg/Switch>
#include <osgDB/WriteFile>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ShadowMap>

#include <cmath>
#include <filesystem>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

constexpr int kWidth = 360, kHeight = 320;

class Threading : public OsgviewerTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(Threading, ShowsASceneFileWith64Lights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (const int kind : {0, 4}) {
        osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(kind == 0 ? -0.8 : 0.8, 0.0, 0.0));
        place->addChild(ball(kind));
        root->addChild(place);
    }
    Osgviewer::Options options;
    options.arguments = GetParam();
    Osgviewer viewer(written(root), options);
    EXPECT_TRUE(eventually([&] { return drawnPixels(viewer.screen()) > kEnoughPixels; }))
        << viewer.output();
    expectGoodEnd(viewer);
}

INSTANTIATE_TEST_SUITE_P(Models, Threading,
                         ::testing::Values("--SingleThreaded", "--CullDrawThreadPerContext",
                                           "--DrawThreadPerContext",
                                           "--CullThreadPerCameraDrawThreadPerContext"));

/// Lights around two spheres, each of which reaches a part of one.
std::vector<Light> manyLights(int count)
{
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        Light light;
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z),
                     phi = i * kPi * (3.0 - std::sqrt(5.0));
        light.position =
            Vec3f(1.3 * r * std::cos(phi) + (i % 2 ? 0.8 : -0.8), 1.3 * r * std::sin(phi), 1.3 * z);
        light.intensity = 0.1f * Vec3f(0.2f, 0.1f * static_cast<float>(i % 4), 0.3f);
        light.radius = 0.6f;
        lights.push_back(light);
    }
    return lights;
}

class ManyLights : public OsgviewerTest {};

// By lists in one pass, as the report of the same scene in this process says.
TEST_F(ManyLights, Show4096InTheRealOsgviewer)
{
    constexpr int kMany = 4096;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    std::vector<osg::ref_ptr<FactorizedBrdf>> balls;
    for (const int kind : {0, 4}) {
        osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(kind == 0 ? -0.8 : 0.8, 0.0, 0.0));
        balls.push_back(ball(kind, osgFX::Effect::AUTO_DETECT));
        balls.back()->setTransfer(Transfer::toneMap);
        place->addChild(balls.back());
        root->addChild(place);
    }
    root->addChild(osgLights(manyLights(kMany)));
    ASSERT_TRUE(osgDB::writeNodeFile(*root, path("many.osgt")));
    ViewerTwin twin(context().loader(), root, 160, 160);
    Osgviewer viewer(path("many.osgt"), {});
    expectSame(viewer, twin, "many-lights");
    for (const auto& effect : balls) {
        const osgFbrdf::DrawReport report = effect->lastReport();
        EXPECT_EQ(report.lightsUsed + report.lightsCulled, kMany);
        EXPECT_GT(report.lightsUsed, kMany / 2);
        EXPECT_EQ(report.lightsDropped, 0);
        EXPECT_GT(report.longestLightList, 0);
        EXPECT_EQ(report.technique, "single pass");
        EXPECT_EQ(report.passes, 1);
    }
    // The plain sum over all lights is the same.
    const Screen listed = twin.frame();
    balls[0]->selectTechnique(osgFbrdf::kBatched);
    balls[0]->setLightsPerPass(256);
    EXPECT_LT(pixelsApart(listed, twin.frame()), kEdges);
    EXPECT_EQ(balls[0]->lastReport().longestLightList, 0);
    expectGoodEnd(viewer);
}

void paint(osg::Geometry& geometry, const osg::Vec4f& colour)
{
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    colours->push_back(colour);
    geometry.setColorArray(colours, osg::Array::BIND_OVERALL);
}

osg::ref_ptr<osg::Geometry> pane(float y, const osg::Vec4f& colour)
{
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry({-1, y, -1}, {2, 0, 0}, {0, 0, 1.5f});
    paint(*quad, colour);
    osg::StateSet* state = quad->getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    if (colour.a() == 1.0f) return quad;
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    return quad;
}

osg::ref_ptr<osg::Node> inFog(osg::Node* node)
{
    const auto foggy = groupOf({node, pane(1.0f, {0.0f, 1.0f, 0.0f, 1.0f})});
    osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setMode(osg::Fog::LINEAR);
    fog->setStart(0.0f);
    fog->setEnd(50.0f);
    fog->setColor({1.0f, 0.0f, 0.0f, 1.0f});
    foggy->getOrCreateStateSet()->setAttributeAndModes(fog);
    return foggy;
}

osg::ref_ptr<osg::Node> inShadows(osg::Node* node)
{
    osg::ref_ptr<osg::Light> lamp = new osg::Light(1);
    lamp->setPosition({0.0f, -1.5f, 4.0f, 1.0f});
    lamp->setDiffuse({1.0f, 1.0f, 1.0f, 1.0f});
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(lamp);
    osg::ref_ptr<osgShadow::ShadowMap> technique = new osgShadow::ShadowMap;
    technique->setLight(lamp);
    osg::ref_ptr<osg::Group> shadowed = new osgShadow::ShadowedScene(technique);
    shadowed->addChild(source);
    shadowed->addChild(node);
    osg::ref_ptr<osg::Geometry> wall =
        osg::createTexturedQuadGeometry({-1.2f, 1.5f, -1.2f}, {2.4f, 0, 0}, {0, 0, 2.4f});
    paint(*wall, {1.0f, 1.0f, 1.0f, 1.0f});
    shadowed->addChild(wall);
    return shadowed;
}

osg::ref_ptr<osg::Node> farLevel(osg::Node* node)
{
    osg::ref_ptr<osg::LOD> levels = new osg::LOD;
    levels->addChild(pane(0.0f, {1.0f, 0.0f, 0.0f, 1.0f}), 0.0f, 10.0f);
    levels->addChild(node, 10.0f, 1000.0f);
    return levels;
}

osg::ref_ptr<osg::Node> switchedOn(osg::Node* node)
{
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(node, true);
    choice->addChild(pane(-1.0f, {1.0f, 0.0f, 0.0f, 1.0f}), false);
    return choice;
}

/// A thread adds this to the scene while frames are drawn.
osg::ref_ptr<osg::Node> paged(const std::string& folder)
{
    osg::ref_ptr<osg::PagedLOD> node = new osg::PagedLOD;
    node->setDatabasePath(folder);
    node->setFileName(0, "page.osgb");
    node->setRange(0, 0.0f, 1000.0f);
    node->setCenter({0.0f, 0.0f, 0.0f});
    node->setRadius(1.0f);
    return node;
}

class RealScene : public OsgviewerTest {
protected:
    void SetUp() override
    {
        OsgviewerTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        ASSERT_TRUE(osgDB::writeNodeFile(*osgMesh(sphereMesh(24)), path("ball.osgb")));
        ASSERT_TRUE(osgDB::writeNodeFile(*ball(0), path("page.osgb")));
    }

    /// Three rows of three.
    osg::ref_ptr<osg::Group> everything()
    {
        const osg::ref_ptr<osg::StateSet> shared = new osg::StateSet;
        shared->setAttributeAndModes(new osg::CullFace);
        const auto one = ball(0), other = ball(4);
        one->setStateSet(shared);
        other->setStateSet(shared);
        other->setMaterial(one->getMaterial());
        const osg::Vec4f glass{0.0f, 0.5f, 1.0f, 0.6f};
        const std::vector<osg::ref_ptr<osg::Node>> all{
            groupOf({pane(-1.2f, glass), ball(0)}),
            groupOf({pane(1.2f, glass), ball(4)}),
            inFog(ball(0)),
            inShadows(ball(4)),
            farLevel(ball(0)),
            switchedOn(ball(4, osgFbrdf::kSinglePass)),
            paged(path("")),
            groupOf({one, other}),
            ball(0, osgFbrdf::kDiffuseFallback),
        };
        osg::ref_ptr<osg::Group> root = new osg::Group;
        for (size_t i = 0; i < all.size(); ++i) {
            osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(
                osg::Matrixd::translate(2.6 * static_cast<double>(i % 3) - 2.6, 0.0,
                                        2.6 - 2.6 * static_cast<double>(i / 3)));
            place->addChild(all[i]);
            root->addChild(place);
        }
        return root;
    }
};

// In a window passes add up in surfaces, under lights and an environment.
TEST_F(RealScene, IsLitFromEverywhere)
{
    const auto sky = osgEnvironment(testPanorama(16));
    const auto ofProduct = ball(0), ofSum = ball(4, osgFX::Effect::AUTO_DETECT);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (const auto& [x, effect] : {std::pair(-1.1, ofProduct), std::pair(1.1, ofSum)}) {
        effect->setExposure(0.05f);
        osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(x, 0.0, 0.0));
        place->addChild(effect);
        root->addChild(place);
    }
    sky->setIntensity({5.0f, 10.0f, 5.0f});
    root->addChild(sky);
    const std::string scene = written(root);
    Osgviewer::Options options;
    options.width = kWidth;
    options.height = kHeight;
    Osgviewer viewer(scene, options);
    ViewerTwin twin(context().loader(), read(scene), kWidth, kHeight);
    expectSame(viewer, twin, "environment");
    expectGoodEnd(viewer);
}

TEST_F(RealScene, LooksAsItDoesWithoutADisplay)
{
    const std::string scene = written(everything());
    const auto twins = read(scene);
    ViewerTwin twin(context().loader(), twins, kWidth, kHeight);
    Osgviewer::Options options;
    options.width = kWidth;
    options.height = kHeight;
    Osgviewer viewer(scene, options);
    expectSame(viewer, twin, "scene");
    expectGoodEnd(viewer);
}

// The file is good first, then half a file, then another good one.
TEST_F(RealScene, TakesAChangedMaterialWhileItRuns)
{
    const auto effect = ball(0, osgFbrdf::kSinglePass);
    effect->setReloading(true);
    const std::string scene = written(groupOf({effect}));
    const auto node = read(scene);
    ViewerTwin twin(context().loader(), node, 160, 160);
    Osgviewer viewer(scene, {});
    expectSame(viewer, twin, "reload-before");
    EXPECT_EQ(viewer.output(), "");
    const Screen before = viewer.screen();
    std::filesystem::resize_file(path("noise0.fbrdf"), 100);
    EXPECT_TRUE(
        eventually([&] { return viewer.output().find("noise0.fbrdf") != std::string::npos; }));
    EXPECT_EQ(pixelsApart(viewer.screen(), before, 0), 0u);
    std::filesystem::copy_file(path("noise4.fbrdf"), path("noise0.fbrdf"),
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_TRUE(eventually([&] { return pixelsApart(viewer.screen(), before) > 1000; }));
    expectSame(viewer, twin, "reload-after");
    EXPECT_EQ(viewer.quit(), 0);
}

// Surfaces of the plugin's own take the new size.
TEST_F(RealScene, FollowsItsWindowToTheWholeScreen)
{
    const std::string scene = written(groupOf({ball(4)}));
    const auto node = read(scene);
    Osgviewer::Options options;
    options.width = kWidth;
    options.height = kHeight;
    options.window = "0 0 160 160";
    Osgviewer viewer(scene, options);
    EXPECT_TRUE(eventually([&] { return drawnPixels(viewer.screen()) > kEnoughPixels; }));
    const size_t before = drawnPixels(viewer.screen());
    viewer.does("key f");
    ViewerTwin twin(context().loader(), node, kWidth, kHeight);
    expectSame(viewer, twin, "whole-screen");
    EXPECT_GT(drawnPixels(viewer.screen()), before);
    expectGoodEnd(viewer);
}

// Without --window osgviewer opens one on every screen, each with a context and a thread: the right
// half of the left screen goes on in the left half of the right one.
TEST_F(RealScene, IsSeenByTwoViewsInTwoContexts)
{
    const std::string scene = written(groupOf({ball(0), ball(4)}));
    const auto node = read(scene);
    Osgviewer::Options options;
    options.screens = 2;
    Osgviewer viewer(scene, options);
    ViewerTwin twin(context().loader(), node, 2 * options.width, options.height);
    const Screen expected = twin.frame();
    Screen both;
    const bool same = eventually([&] {
        both = beside(viewer.screen(0), viewer.screen(1));
        return pixelsApart(both, expected) < kEdges;
    });
    EXPECT_TRUE(same) << pixelsApart(both, expected) << " pixels differ\n" << viewer.output();
    if (const char* keep = std::getenv("FBRDF_KEEP_SCREENS")) {
        both.save(keep + std::string("two.png"));
        expected.save(keep + std::string("two-expected.png"));
    }
    expectGoodEnd(viewer);
}

// The terrain manipulator zooms towards what a ray through the middle of the view hits.
TEST_F(RealScene, IsHitAsTheModelAloneIs)
{
    const std::string scene = written(groupOf({ball(0)}));
    const auto node = read(scene), plain = read(path("ball.osgb"));
    ViewerTwin twin(context().loader(), node, 160, 160);
    ViewerTwin withoutEffect(context().loader(), plain, 160, 160);
    Osgviewer viewer(scene, {});
    expectSame(viewer, twin, "before-zoom");
    const osg::Vec3d before = osg::Matrixd::inverse(twin.viewMatrix()).getTrans();
    for (ViewerTwin* each : {&twin, &withoutEffect}) each->zoomOverTerrain();
    viewer.does("key 4 click 5 click 5");
    expectSame(viewer, twin, "zoomed");
    const osg::Matrixd after = twin.viewMatrix(), there = withoutEffect.viewMatrix();
    // Twice a tenth of the way from the surface of the sphere, not from its middle.
    const double fromSurface = -before.y() - 1.0;
    EXPECT_NEAR(osg::Matrixd::inverse(after).getTrans().y(), -1.0 - 0.81 * fromSurface, 1e-3);
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(after(i / 4, i % 4), there(i / 4, i % 4), 1e-4) << i;
    expectGoodEnd(viewer);
}

}  // namespace
}  // namespace fbrdf::test
