// In the real osgfxbrowser the effect is in the list, is chosen by keys and drawn with its demo
// material, and the program ends cleanly.
#include "OsgviewerTest.h"

#include "support/gl/Scenes.h"

#include <osgDB/WriteFile>

namespace fbrdf::test {
namespace {

using Browser = OsgviewerTest;

constexpr int kSize = 320;  // the panel covers the lower part
constexpr size_t kMetal = 1000;

/// Pixels of the demo's brushed metal, which is yellow; neither the plain model nor the panel is.
size_t metalPixels(const Screen& screen)
{
    size_t count = 0;
    for (size_t i = 0; i < screen.rgb.size() / 2; i += 3)
        count += screen.rgb[i] > screen.rgb[i + 2] + 25 ? 1 : 0;
    return count;
}

TEST_F(Browser, ShowsTheEffectThatIsChosenByKeys)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*osgMesh(sphereMesh(24)), path("ball.osgb")));
    // Its name in a scene file is how the browser, which knows no option for that, loads a library.
    const osg::ref_ptr<osgFbrdf::PointLights> lights = new osgFbrdf::PointLights;
    lights->addPoint({3.0f, -3.0f, 3.0f}, {40.0f, 40.0f, 40.0f});
    lights->addPoint({-3.0f, -3.0f, 1.0f}, {40.0f, 40.0f, 40.0f});
    ASSERT_TRUE(osgDB::writeNodeFile(*lights, path("lights.osgb")));
    Osgviewer::Options options;
    options.width = options.height = kSize;
    options.program = "osgfxbrowser";
    Osgviewer browser(path("ball.osgb") + ' ' + path("lights.osgb"), options);
    EXPECT_TRUE(eventually([&] { return drawnPixels(browser.screen()) > kEnoughPixels; }));
    // Anisotropic Lighting, Bump Mapping and Cartoon come before it in the list.
    browser.does("key Right key Right key Right");
    EXPECT_TRUE(eventually([&] { return metalPixels(browser.screen()) > kMetal; }))
        << metalPixels(browser.screen());
    if (const char* keep = std::getenv("FBRDF_KEEP_SCREENS"))
        browser.screen().save(keep + std::string("browser.png"));
    browser.does("key Delete");  // effects off
    EXPECT_TRUE(eventually([&] { return metalPixels(browser.screen()) < 10; }));
    browser.does("key Delete");
    EXPECT_TRUE(eventually([&] { return metalPixels(browser.screen()) > kMetal; }));
    expectGoodEnd(browser);
    EXPECT_NE(browser.output().find("Factorized BRDF"), std::string::npos) << browser.output();
}

}  // namespace
}  // namespace fbrdf::test
