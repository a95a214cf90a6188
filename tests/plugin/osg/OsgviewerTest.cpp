#include "OsgviewerTest.h"

#include "support/DataDir.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <fbrdf/io/MaterialFile.h>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <cstdlib>

namespace fbrdf::test {

void OsgviewerTest::SetUp()
{
    OsgTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    for (const size_t kind : {size_t(0), size_t(4)})
        writeMaterial(withLobes(testMaterials()[kind], testLobes(LobeAxes::tilted, 2)),
                      path("noise" + std::to_string(kind) + ".fbrdf"));
    if (Osgviewer::installed()) return;
    if (dataIsMandatory()) FAIL() << "needs xvfb-run, osgviewer, osgfxbrowser and xdotool";
    GTEST_SKIP() << "needs xvfb-run (xvfb, xauth), osgviewer and osgfxbrowser (openscenegraph) "
                    "and xdotool";
}

std::string OsgviewerTest::written(osg::Group* root)
{
    root->addChild(osgLights(testLights(64)));
    EXPECT_TRUE(osgDB::writeNodeFile(*root, path("scene.osgb")));
    return path("scene.osgb");
}

osg::ref_ptr<osg::Node> OsgviewerTest::read(const std::string& scene)
{
    const auto node = osgDB::readRefNodeFile(scene);
    EXPECT_TRUE(node);
    return node;
}

osg::ref_ptr<osgFbrdf::FactorizedBrdf> OsgviewerTest::ball(int kind, int technique)
{
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
    EXPECT_TRUE(effect->setMaterialFile(path("noise" + std::to_string(kind) + ".fbrdf")));
    effect->setExposure(0.02f);
    effect->selectTechnique(technique);
    effect->addChild(osgMesh(sphereMesh(24)));
    return effect;
}

void OsgviewerTest::expectSame(const Osgviewer& viewer, ViewerTwin& twin, const std::string& name,
                               size_t pixels)
{
    Screen found, expected;
    const bool same = eventually([&] {
        expected = twin.frame();
        found = viewer.screen();
        return drawnPixels(expected) > kEnoughPixels && pixelsApart(found, expected) < pixels;
    });
    EXPECT_TRUE(same) << name << ": " << pixelsApart(found, expected) << " pixels differ\n"
                      << viewer.output();
    if (const char* keep = std::getenv("FBRDF_KEEP_SCREENS")) {
        found.save(keep + name + ".png");
        expected.save(keep + name + "-expected.png");
    }
}

osg::ref_ptr<osg::Group> groupOf(const std::vector<osg::ref_ptr<osg::Node>>& nodes)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const auto& node : nodes) group->addChild(node);
    return group;
}

void expectGoodEnd(Osgviewer& viewer)
{
    EXPECT_EQ(viewer.quit(), 0);
    const std::string output = viewer.output();
    EXPECT_EQ(output.find("osgFbrdf"), std::string::npos) << output;
    EXPECT_EQ(output.find("GL error"), std::string::npos) << output;
}

}  // namespace fbrdf::test
