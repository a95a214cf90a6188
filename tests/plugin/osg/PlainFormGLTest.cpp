// Scenes saved for programs without the plugin.
#include "FilesTest.h"

#include <osgFbrdf/PlainForm.h>

#include <osg/LightSource>
#include <osg/ValueObject>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::PointLights;

using PlainFormFiles = FilesTest;
class PlainForm : public FilesTest, public ::testing::WithParamInterface<const char*> {};

/// Counts what a scene is made of.
struct Census : public osg::NodeVisitor {
    Census() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Node& node) override
    {
        if (auto* found = dynamic_cast<FactorizedBrdf*>(&node)) effect = found;
        if (auto* found = dynamic_cast<PointLights*>(&node)) lights = found;
        ours += std::string(node.libraryName()) == "osgFbrdf" ? 1 : 0;
        traverse(node);
    }
    void apply(osg::LightSource& source) override
    {
        ++sources;
        traverse(source);
    }
    FactorizedBrdf* effect = nullptr;
    PointLights* lights = nullptr;
    int ours = 0, sources = 0;
};

Census censusOf(osg::Node& scene)
{
    Census census;
    scene.accept(census);
    return census;
}

TEST_P(PlainForm, IsReadWithoutThePluginAndRestoredWithIt)
{
    const auto before = scene();
    const std::string plain = path(std::string("scene.") + GetParam());
    ASSERT_TRUE(osgDB::writeNodeFile(*before, plain + ".fbrdf"));
    EXPECT_EQ(censusOf(*before).sources, 0);  // the scene itself is untouched
    EXPECT_EQ(censusOf(*before).ours, 2);

    const std::string text = runWith("/nowhere", "osgconv " + plain + " " + path("other.osgb"));
    EXPECT_EQ(status_, 0) << text;
    const auto other = osgDB::readRefNodeFile(path("other.osgb"));
    ASSERT_TRUE(other) << text;
    EXPECT_EQ(censusOf(*other).ours, 0);
    EXPECT_EQ(censusOf(*other).sources, 8);
    EXPECT_GT(meanOf(imageOf(other), 0), 0.01);

    const auto after = osgDB::readRefNodeFile(path("other.osgb.fbrdf"));
    ASSERT_TRUE(after);
    const Census found = censusOf(*after);
    EXPECT_EQ(found.ours, 2);
    EXPECT_EQ(found.sources, 0);
    ASSERT_TRUE(found.effect && found.lights);
    EXPECT_TRUE(found.effect->getMaterial());
    EXPECT_EQ(found.effect->getMaterialFile(), path("noise.fbrdf"));
    EXPECT_EQ(found.effect->getExposure(), 1.5f);
    EXPECT_EQ(found.effect->getTransfer(), Transfer::srgb);
    EXPECT_EQ(found.effect->getSelectedTechnique(), osgFbrdf::kBatched);
    EXPECT_EQ(found.effect->getNumChildren(), 1u);
    EXPECT_EQ(found.lights->getLights().size(), 64u);
}

INSTANTIATE_TEST_SUITE_P(Formats, PlainForm, ::testing::Values("osgt", "osgb", "osgx"));

TEST_F(PlainFormFiles, OsgconvWritesAndRestoresThem)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*scene(), path("scene.osgt")));
    std::string text = run("osgconv " + path("scene.osgt") + " " + path("plain.osgt.fbrdf"));
    EXPECT_EQ(status_, 0) << text;
    const auto plain = osgDB::readRefNodeFile(path("plain.osgt"));
    ASSERT_TRUE(plain) << text;
    EXPECT_EQ(censusOf(*plain).ours, 0);
    text = run("osgconv " + path("plain.osgt.fbrdf") + " " + path("again.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto again = osgDB::readRefNodeFile(path("again.osgt"));
    ASSERT_TRUE(again) << text;
    EXPECT_EQ(censusOf(*again).ours, 2);
}

TEST_F(PlainFormFiles, OsgconvReadsAModelWithAMaterial)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*osgMesh(sphereMesh(6)), path("ball.osgt")));
    const std::string text =
        run("osgconv '" + path("ball.osgt") + ".[noise.fbrdf].fbrdf' " + path("out.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto node = osgDB::readRefNodeFile(path("out.osgt"));
    ASSERT_TRUE(node) << text;
    ASSERT_TRUE(censusOf(*node).effect);
    EXPECT_TRUE(censusOf(*node).effect->getMaterial());
}

// A program without the plugin reads the plain form.
TEST_F(PlainFormFiles, WithoutItAReaderWithoutThePluginLosesTheModel)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*scene(), path("scene.osgt")));
    const std::string text =
        runWith("/nowhere", "osgconv " + path("scene.osgt") + " " + path("other.osgb"));
    EXPECT_NE(text.find("Unsupported wrapper class"), std::string::npos) << text;
    const auto other = osgDB::readRefNodeFile(path("other.osgb"));
    EXPECT_EQ(meanOf(imageOf(other ? other : new osg::Group), 3), 0.0);
}

TEST_F(PlainFormFiles, AnEffectAtTheRootIsReplacedToo)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    effect->setMaterialFile(path("noise.fbrdf"));
    effect->addChild(osgMesh(sphereMesh(6)));
    const auto plain = osgFbrdf::plainForm(*effect);
    EXPECT_EQ(censusOf(*plain).ours, 0);
    const auto again = osgFbrdf::restored(*plain);
    EXPECT_TRUE(dynamic_cast<FactorizedBrdf*>(again.get()));
}

TEST_F(PlainFormFiles, ADamagedRecordStaysPlainWithAWarning)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setUserValue("osgFbrdf", std::string("#Ascii Scene #Version 162 nonsense { 3"));
    group->addChild(osgMesh(sphereMesh(6)));
    const Notices notices;
    EXPECT_EQ(osgFbrdf::restored(*group).get(), group.get());
    EXPECT_NE(notices.text().find("record"), std::string::npos) << notices.text();
}

}  // namespace
}  // namespace fbrdf::test
