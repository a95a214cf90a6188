// osgFX chooses a technique while it draws, so an effect that comes after realize() is left out of
// the first frame, its children too. Ours is drawn: the test looks at every frame of the real
// osgviewer while a page with an effect replaces a plain model.
#include "OsgviewerTest.h"

#include "support/gl/Scenes.h"

#include <osg/PagedLOD>
#include <osgDB/WriteFile>
#include <osgFX/Scribe>

#include <filesystem>

namespace fbrdf::test {
namespace {

namespace fs = std::filesystem;

// JPEG blurs edges; a ball covers some 4,000 pixels.
constexpr size_t kBall = 1500;

/// Pixels that are red or, if not `red`, neither that nor background.
size_t pixelsOf(const Screen& frame, bool red)
{
    size_t count = 0;
    for (size_t i = 0; i < frame.rgb.size(); i += 3) {
        const int r = frame.rgb[i], g = frame.rgb[i + 1], b = frame.rgb[i + 2];
        const bool isRed = r > 180 && g < 60 && b < 60;
        const bool background =
            std::abs(r - 51) + std::abs(g - 51) + std::abs(b - 102) < 60;  // JPEG's noise
        count += (red ? isRed : !isRed && !background) ? 1 : 0;
    }
    return count;
}

struct Frames {
    int old = 0, page = 0, empty = 0;
};

class NoVanishedFrame : public OsgviewerTest {
protected:
    /// A red ball, and from nearer than the first view the contents of page.osgb.
    std::string pagedScene()
    {
        osg::ref_ptr<osg::Geometry> ball = osgMesh(sphereMesh(24));
        osg::ref_ptr<osg::Vec4Array> red = new osg::Vec4Array;
        red->push_back({1.0f, 0.0f, 0.0f, 1.0f});
        ball->setColorArray(red, osg::Array::BIND_OVERALL);
        ball->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        osg::ref_ptr<osg::PagedLOD> levels = new osg::PagedLOD;
        levels->setDatabasePath(path(""));
        levels->setCenter({0.0f, 0.0f, 0.0f});
        levels->setRadius(1.0f);
        const float change = 0.95f * 3.5f;  // osgGA looks from 3.5 radii
        levels->addChild(ball, change, 1000.0f);
        levels->setFileName(1, "page.osgb");
        levels->setRange(1, 0.0f, change);
        return written(groupOf({levels}));
    }

    /// Goes nearer until the page is seen; osgviewer itself writes every frame.
    Frames framesUntilThePageIsThere(const std::string& scene, const std::string& threading)
    {
        Osgviewer::Options options;
        options.arguments = threading;
        Osgviewer viewer(scene, options);
        EXPECT_TRUE(eventually([&] { return pixelsOf(viewer.screen(), true) > kBall; }));
        viewer.does("keydown shift key c keyup shift");
        const auto frame = [&viewer](int number) {
            return viewer.file("screen_shot_0_" + std::to_string(number) + ".jpg");
        };
        EXPECT_TRUE(eventually([&] { return fs::exists(frame(1)); })) << viewer.output();
        viewer.does("click 5 click 5");
        EXPECT_TRUE(eventually([&] { return pixelsOf(viewer.screen(), false) > kBall; }));
        EXPECT_EQ(viewer.quit(), 0);
        Frames frames;
        for (int i = 0; fs::exists(frame(i)); ++i) {
            const Screen picture = Screen::ofFile(frame(i));
            const bool old = pixelsOf(picture, true) > kBall,
                       page = pixelsOf(picture, false) > kBall;
            frames.old += old ? 1 : 0;
            frames.page += page ? 1 : 0;
            frames.empty += old || page ? 0 : 1;
        }
        return frames;
    }
};

class Threads : public NoVanishedFrame, public ::testing::WithParamInterface<const char*> {};

TEST_P(Threads, WhenAnEffectComesInLater)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*ball(0, osgFX::Effect::AUTO_DETECT), path("page.osgb")));
    const Frames frames = framesUntilThePageIsThere(pagedScene(), GetParam());
    EXPECT_GT(frames.old, 0);
    EXPECT_GT(frames.page, 0);
    EXPECT_EQ(frames.empty, 0);
}

INSTANTIATE_TEST_SUITE_P(NoVanishedFrame, Threads,
                         ::testing::Values("--SingleThreaded", "--DrawThreadPerContext"));

// This tests the test: one of osgFX's own effects is left out of a frame.
TEST_F(NoVanishedFrame, IsNotWhatOsgFxDoes)
{
    const osg::ref_ptr<osgFX::Effect> scribe = new osgFX::Scribe;
    scribe->addChild(osgMesh(sphereMesh(24)));
    ASSERT_TRUE(osgDB::writeNodeFile(*scribe, path("page.osgb")));
    const Frames frames = framesUntilThePageIsThere(pagedScene(), "--SingleThreaded");
    EXPECT_GT(frames.empty, 0);
}

}  // namespace
}  // namespace fbrdf::test
