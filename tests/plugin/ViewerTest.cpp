// The real osgviewer in a window (Xvfb): a scene file with 64 lights, in every threading model, by
// OSG_LIBRARY_PATH alone.
#include "OsgScene.h"

#include "support/DataDir.h"
#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>

#include <osg/MatrixTransform>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <sstream>

namespace fbrdf::test {
namespace {

// Of 160 x 160; the sphere covers some 8,000.
constexpr size_t kEnoughPixels = 3000;

std::string contents(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Pixels that are neither the root window's black nor osgviewer's background, of a screen that
/// Xvfb keeps in a file (X Window Dump: numbers are big-endian, 32 bits).
size_t drawnPixels(const std::string& dump)
{
    const auto number = [&dump](size_t index) {
        size_t value = 0;
        for (size_t i = 0; i < 4; ++i)
            value = value << 8 | static_cast<unsigned char>(dump.at(4 * index + i));
        return value;
    };
    if (dump.size() < 100) return 0;
    const size_t start = number(0) + 12 * number(19);
    size_t count = 0;
    for (size_t i = start; i + 4 <= dump.size(); i += 4) {
        const auto channel = [&](size_t c) { return static_cast<unsigned char>(dump[i + c]); };
        const bool background = channel(0) == 102 && channel(1) == 51 && channel(2) == 51;
        const bool black = channel(0) == 0 && channel(1) == 0 && channel(2) == 0;
        count += background || black ? 0 : 1;
    }
    return count;
}

class Viewer : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override
    {
        setenv("OSG_LIBRARY_PATH", FBRDF_OSG_LIBRARY_PATH, 1);
        osgDB::Registry::instance()->initLibraryFilePathList();
        if (std::system("command -v xvfb-run >/dev/null && command -v osgviewer >/dev/null") == 0)
            return;
        if (dataIsMandatory()) FAIL() << "needs xvfb-run and osgviewer";
        GTEST_SKIP() << "needs xvfb-run (xvfb, xauth) and osgviewer (openscenegraph)";
    }

    /// Shows the scene until something is on the screen, 60 s at most; says what osgviewer said.
    std::string show(const std::string& scene)
    {
        std::ofstream(folder_.file("run.sh"))
            << "env " FBRDF_OSG_ENVIRONMENT "osgviewer " << GetParam() << " --window 0 0 160 160 "
            << scene << " >" << folder_.file("log") << " 2>&1 & viewer=$!\nwhile [ ! -e "
            << folder_.file("stop")
            << " ] && kill -0 $viewer; do sleep 0.1; done\nkill $viewer; wait $viewer\n";
        const std::string command =
            std::string("env -u LD_LIBRARY_PATH -u WAYLAND_DISPLAY OSG_GL_ERROR_CHECKING=") +
            "ONCE_PER_ATTRIBUTE OSG_LIBRARY_PATH=" + FBRDF_OSG_LIBRARY_PATH +
            " xvfb-run -a -s '-screen 0 160x160x24 -fbdir " + folder_.file("") + "' sh " +
            folder_.file("run.sh") + " >/dev/null 2>&1";
        auto running =
            std::async(std::launch::async, [&command] { return std::system(command.c_str()); });
        const auto tick = std::chrono::milliseconds(200);
        for (int i = 0; i < 300 && running.wait_for(tick) == std::future_status::timeout; ++i) {
            screen_ = contents(folder_.file("Xvfb_screen0"));
            if (drawnPixels(screen_) > kEnoughPixels) break;
        }
        std::ofstream(folder_.file("stop")) << "stop";
        running.wait();
        return contents(folder_.file("log"));
    }

    std::string screen_;
    TemporaryDir folder_;
};

TEST_P(Viewer, ShowsASceneFileWith64Lights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (const size_t kind : {size_t(0), size_t(4)}) {  // a product and a sum
        const std::string file = folder_.file("noise" + std::to_string(kind) + ".fbrdf");
        writeMaterial(testMaterials()[kind], file);
        osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
        ASSERT_TRUE(effect->setMaterialFile(file));
        effect->setExposure(0.02f);
        effect->selectTechnique(osgFbrdf::kTwoLookups);  // 65 passes through a surface and more
        effect->addChild(osgMesh(sphereMesh(24)));
        osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(kind == 0 ? -0.8 : 0.8, 0.0, 0.0));
        place->addChild(effect);
        root->addChild(place);
    }
    root->addChild(osgLights(testLights(64)));
    ASSERT_TRUE(osgDB::writeNodeFile(*root, folder_.file("scene.osgt")));
    const std::string said = show(folder_.file("scene.osgt"));
    EXPECT_EQ(said.find("osgFbrdf"), std::string::npos) << said;  // a fallback would be reported
    EXPECT_EQ(said.find("GL error"), std::string::npos) << said;
    EXPECT_GT(drawnPixels(screen_), kEnoughPixels) << said;
    if (const char* keep = std::getenv("FBRDF_KEEP_SCREEN"))
        std::ofstream(keep, std::ios::binary) << screen_;
}

INSTANTIATE_TEST_SUITE_P(Threading, Viewer,
                         ::testing::Values("--SingleThreaded", "--CullDrawThreadPerContext",
                                           "--DrawThreadPerContext",
                                           "--CullThreadPerCameraDrawThreadPerContext"));

}  // namespace
}  // namespace fbrdf::test
