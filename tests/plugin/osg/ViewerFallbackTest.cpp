// Where something keeps the real osgviewer from drawing a material, the log names the file and the
// reason, and the fallback draws the model.
#include "OsgviewerTest.h"

#include "support/NewerFile.h"

#include <osgDB/FileNameUtils>

#include <filesystem>
#include <functional>

namespace fbrdf::test {
namespace {

namespace fs = std::filesystem;

class ViewerFallback : public OsgviewerTest {
protected:
    /// Both reasons are in the log, the screen shows `expected`, and OpenGL has no objections.
    void expectFallback(Osgviewer& viewer, osg::Node* expected, const std::string& file,
                        const std::string& reason)
    {
        const Notices silence;  // the twin has no material either
        ViewerTwin twin(context().loader(), expected, 160, 160);
        expectSame(viewer, twin, osgDB::getNameLessExtension(file));
        EXPECT_EQ(viewer.quit(), 0);
        const std::string output = viewer.output();
        EXPECT_NE(output.find(file), std::string::npos) << output;
        EXPECT_NE(output.find(reason), std::string::npos) << output;
        EXPECT_NE(output.find("diffuse fallback is drawn"), std::string::npos) << output;
        EXPECT_EQ(output.find("GL error"), std::string::npos) << output;
    }

    osg::ref_ptr<osg::Node> withoutMaterial()
    {
        const auto effect = ball(0, osgFX::Effect::AUTO_DETECT);
        effect->setMaterial(nullptr);
        return withLights(effect);
    }
    osg::ref_ptr<osg::Node> withLights(osg::Node* node) { return read(written(groupOf({node}))); }
    std::string sceneOf(const osg::ref_ptr<osgFbrdf::FactorizedBrdf>& effect)
    {
        return written(groupOf({effect}));
    }
};

// Mesa's extensions alone would do: the language is OpenGL 2.0's or GL_ARB_shading_language_100.
TEST_F(ViewerFallback, IsDrawnWithoutGlsl)
{
    const auto twin = withLights(ball(0, osgFbrdf::kDiffuseFallback));
    Osgviewer::Options options;
    options.environment =
        "MESA_GL_VERSION_OVERRIDE=1.5 OSG_GL_EXTENSION_DISABLE=GL_ARB_shading_language_100";
    Osgviewer viewer(sceneOf(ball(0, osgFX::Effect::AUTO_DETECT)), options);
    expectFallback(viewer, twin, "noise0.fbrdf", "found no GLSL, expected 1.20");
}

class Units : public ViewerFallback, public ::testing::WithParamInterface<const char*> {};

TEST_P(Units, AreTooFew)
{
    const auto twin = withLights(ball(0, osgFbrdf::kDiffuseFallback));
    const auto effect = ball(0, osgFX::Effect::AUTO_DETECT);
    effect->setFirstTextureUnit(1000);
    Osgviewer::Options options;
    options.arguments = GetParam();
    Osgviewer viewer(sceneOf(effect), options);
    expectFallback(viewer, twin, "noise0.fbrdf", "texture units: found ");
}

INSTANTIATE_TEST_SUITE_P(ViewerFallback, Units,
                         ::testing::Values("--SingleThreaded", "--DrawThreadPerContext"));

TEST_F(ViewerFallback, IsDrawnWithoutTheMaterial)
{
    const auto twin = withoutMaterial();
    const std::string scene = sceneOf(ball(4, osgFX::Effect::AUTO_DETECT));
    fs::remove(path("noise4.fbrdf"));
    Osgviewer viewer(scene, {});
    expectFallback(viewer, twin, "noise4.fbrdf", "found no such file");
}

TEST_F(ViewerFallback, IsDrawnForAMaterialOfANewerVersion)
{
    const auto twin = withoutMaterial();
    const std::string scene = sceneOf(ball(4, osgFX::Effect::AUTO_DETECT));
    writeNewerVersion(path("noise0.fbrdf"), path("noise4.fbrdf"));
    Osgviewer viewer(scene, {});
    expectFallback(viewer, twin, "noise4.fbrdf", "version 9");
}

// The node kit and its serializers are there, but nothing that reads materials.
TEST_F(ViewerFallback, IsDrawnWithoutThePluginThatReadsMaterials)
{
    const auto twin = withoutMaterial();
    fs::copy(FBRDF_OSG_LIBRARY_PATH, path("lib"),
             fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    const fs::path plugins = fs::path(FBRDF_OSG_PLUGIN_FILE).parent_path().filename();
    ASSERT_TRUE(fs::remove(path("lib") / plugins / "osgdb_fbrdf.so"));
    Osgviewer::Options options;
    options.libraryPath = path("lib");
    Osgviewer viewer(sceneOf(ball(4, osgFX::Effect::AUTO_DETECT)), options);
    expectFallback(viewer, twin, "noise4.fbrdf", "found no plugin osgdb_fbrdf");
}

}  // namespace
}  // namespace fbrdf::test
