// Materials that are in no file: saved in the scene, streamed, and written to files of their own.
#include "FilesTest.h"

#include "io/TestMaterials.h"

#include <osgFbrdf/PlainForm.h>

#include <osg/MatrixTransform>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::MaterialObject;

osg::ref_ptr<FactorizedBrdf> ballOf(MaterialObject* material)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    effect->setMaterial(material);
    effect->setFloatTarget(true);
    effect->addChild(osgMesh(sphereMesh(12)));
    return effect;
}

struct Collector : public osg::NodeVisitor {
    Collector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Group& group) override
    {
        if (auto* effect = dynamic_cast<FactorizedBrdf*>(&group)) effects.push_back(effect);
        traverse(group);
    }
    std::vector<FactorizedBrdf*> effects;
};

std::vector<FactorizedBrdf*> effectsOf(osg::Node& node)
{
    Collector found;
    node.accept(found);
    return found.effects;
}

void expectMaterial(const FactorizedBrdf* effect, const Material& expected)
{
    ASSERT_TRUE(effect && effect->getMaterial());
    EXPECT_EQ(firstDifference(effect->getMaterial()->material(), expected), "");
    EXPECT_EQ(effect->getMaterialFile(), "");
}

class EmbeddedMaterial : public FilesTest {
protected:
    /// Two effects that share a material, one with another, and lights.
    osg::ref_ptr<osg::Group> threeBalls()
    {
        osg::ref_ptr<osg::Group> root = new osg::MatrixTransform;
        const osg::ref_ptr<MaterialObject> shared = new MaterialObject(testMaterials()[0]);
        root->addChild(ballOf(shared));
        root->addChild(ballOf(shared));
        root->addChild(ballOf(new MaterialObject(testMaterials()[4])));
        root->addChild(osgLights(testLights(9)));
        return root;
    }
    std::string contents(const std::string& name) const
    {
        std::ostringstream bytes;
        bytes << std::ifstream(path(name), std::ios::binary).rdbuf();
        return bytes.str();
    }
};

/// Finds OpenEXR's first bytes, either as bytes of a binary file or as a number.
size_t bytesIn(const std::string& scene)
{
    return std::min(scene.find("v/1\x01"), scene.find("20000630"));
}

class EmbeddedIn : public EmbeddedMaterial, public ::testing::WithParamInterface<const char*> {};

TEST_P(EmbeddedIn, ComesBackWholeAndShared)
{
    const std::string file = path(std::string("scene.") + GetParam());
    const Notices notices;
    const auto before = threeBalls();
    ASSERT_TRUE(osgDB::writeNodeFile(*before, file));
    const auto node = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(node);
    const auto effects = effectsOf(*node);
    ASSERT_EQ(effects.size(), 3u);
    for (size_t i = 0; i < 3; ++i) expectMaterial(effects[i], testMaterials()[i < 2 ? 0 : 4]);
    EXPECT_EQ(effects[0]->getMaterial(), effects[1]->getMaterial());
    EXPECT_NE(effects[0]->getMaterial(), effects[2]->getMaterial());
    EXPECT_TRUE(effects[2]->getFloatTarget());  // what comes after it in the file
    EXPECT_EQ(notices.text(), "");
    EXPECT_GT(meanOf(imageOf(node), 3), 0.3);
    EXPECT_EQ(effects[0]->lastReport().technique, "single pass");
}

TEST_P(EmbeddedIn, ThePlainFormKeepsItToo)
{
    const std::string plain = path(std::string("plain.") + GetParam());
    const Notices notices;
    ASSERT_TRUE(osgDB::writeNodeFile(*threeBalls(), plain + ".fbrdf"));
    const auto node = osgDB::readRefNodeFile(plain + ".fbrdf");
    ASSERT_TRUE(node);
    const auto effects = effectsOf(*node);
    ASSERT_EQ(effects.size(), 3u);
    expectMaterial(effects[0], testMaterials()[0]);
    expectMaterial(effects[2], testMaterials()[4]);
    EXPECT_EQ(effects[0]->getMaterial(), effects[1]->getMaterial());
    EXPECT_EQ(notices.text(), "");
}

// A material of which bytes are missing is not read, even where it is in the scene itself.
TEST_P(EmbeddedIn, DamageGivesAWarningAndTheModelStays)
{
    const std::string name = std::string("scene.") + GetParam();
    ASSERT_TRUE(osgDB::writeNodeFile(*ballOf(new MaterialObject(testMaterials()[0])), path(name)));
    std::string text = contents(name);
    const size_t start = bytesIn(text);
    ASSERT_NE(start, std::string::npos);
    text[start] = text[start] == '2' ? '1' : 'x';
    std::ofstream(path(name), std::ios::binary) << text;
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(path(name));
    ASSERT_TRUE(node);
    EXPECT_NE(notices.text().find("expected those of a .fbrdf"), std::string::npos)
        << notices.text();
    const auto effects = effectsOf(*node);
    ASSERT_EQ(effects.size(), 1u);
    EXPECT_TRUE(effects[0]->getFloatTarget());
    EXPECT_GT(meanOf(imageOf(node), 3), 0.3);
    EXPECT_EQ(effects[0]->lastReport().technique, "diffuse fallback");
}

// Where a file ends within a string in quotes, OSG's reader of text never ends.
TEST_P(EmbeddedIn, ASceneThatEndsWithinItIsReadToItsEnd)
{
    const std::string name = std::string("scene.") + GetParam();
    ASSERT_TRUE(osgDB::writeNodeFile(*ballOf(new MaterialObject(testMaterials()[0])), path(name)));
    const std::string whole = contents(name);
    for (size_t size = bytesIn(whole); size < whole.size(); size += whole.size() / 20) {
        std::ofstream(path(name), std::ios::binary) << whole.substr(0, size);
        const Notices notices;
        const auto node = osgDB::readRefNodeFile(path(name));
        EXPECT_FALSE(notices.text().empty()) << size;
        if (!node) continue;
        for (const auto* effect : effectsOf(*node)) EXPECT_FALSE(effect->getMaterial());
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, EmbeddedIn, ::testing::Values("osgt", "osgb", "osgx"));

TEST_F(EmbeddedMaterial, OnlyItsScenesAreOfFormat2)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*threeBalls(), path("embedded.osgt")));
    EXPECT_NE(contents("embedded.osgt").find("Format 2"), std::string::npos);
    ASSERT_TRUE(osgDB::writeNodeFile(*scene(), path("named.osgt")));
    EXPECT_NE(contents("named.osgt").find("Format 1"), std::string::npos);
    EXPECT_EQ(contents("named.osgt").find("MaterialObject"), std::string::npos);
}

TEST_F(EmbeddedMaterial, AFreshProcessConvertsItsScenes)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*threeBalls(), path("scene.osgt")));
    const std::string text = run("osgconv " + path("scene.osgt") + " " + path("scene.osgb"));
    EXPECT_EQ(status_, 0) << text;
    const auto node = osgDB::readRefNodeFile(path("scene.osgb"));
    ASSERT_TRUE(node) << text;
    expectMaterial(effectsOf(*node).at(2), testMaterials()[4]);
}

TEST_F(EmbeddedMaterial, IsAnObjectOfAFileOfItsOwn)
{
    const osg::ref_ptr<MaterialObject> material = new MaterialObject(testMaterials()[4]);
    ASSERT_TRUE(osgDB::writeObjectFile(*material, path("sum.fbrdf")));
    const auto named = osgFbrdf::readMaterialObject(path("sum.fbrdf"));
    ASSERT_TRUE(named);
    EXPECT_EQ(firstDifference(named->material(), material->material()), "");
    EXPECT_EQ(named->fileName(), path("sum.fbrdf"));
    ASSERT_TRUE(osgDB::writeObjectFile(*material, path("sum.osgb")));
    const auto object = osgDB::readRefObjectFile(path("sum.osgb"));
    const auto* read = dynamic_cast<MaterialObject*>(object.get());
    ASSERT_TRUE(read);
    EXPECT_EQ(firstDifference(read->material(), material->material()), "");
}

TEST_F(EmbeddedMaterial, AnEffectIsWrittenAsItsMaterial)
{
    const Notices notices;
    ASSERT_TRUE(
        osgDB::writeNodeFile(*ballOf(new MaterialObject(testMaterials()[1])), path("ball.fbrdf")));
    const auto read = osgFbrdf::readMaterialObject(path("ball.fbrdf"));
    ASSERT_TRUE(read);
    EXPECT_EQ(firstDifference(read->material(), testMaterials()[1]), "");
    EXPECT_EQ(notices.text(), "");
    EXPECT_FALSE(osgDB::writeNodeFile(*threeBalls(), path("several.fbrdf")));
    EXPECT_FALSE(osgDB::writeNodeFile(*osgMesh(sphereMesh(4)), path("none.fbrdf")));
    for (const char* words : {"several.fbrdf: found 2 materials", "none.fbrdf: found 0 materials"})
        EXPECT_NE(notices.text().find(words), std::string::npos) << notices.text();
    EXPECT_FALSE(std::ifstream(path("none.fbrdf")).good());
}

TEST_F(EmbeddedMaterial, OsgconvCopiesAMaterialAndMakesAScene)
{
    std::string text = run("osgconv " + path("noise.fbrdf") + " " + path("copy.fbrdf"));
    EXPECT_EQ(status_, 0) << text;
    EXPECT_EQ(contents("copy.fbrdf"), contents("noise.fbrdf")) << text;
    text = run("osgconv " + path("noise.fbrdf") + " " + path("ball.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto node = osgDB::readRefNodeFile(path("ball.osgt"));
    ASSERT_TRUE(node) << text;
    EXPECT_GT(meanOf(imageOf(node), 3), 0.3);
}

TEST_F(EmbeddedMaterial, StreamsCarryObjectsAndNodes)
{
    auto* format = osgDB::Registry::instance()->getReaderWriterForExtension("fbrdf");
    ASSERT_TRUE(format);
    std::stringstream stream;
    const osg::ref_ptr<MaterialObject> material = new MaterialObject(testMaterials()[0]);
    ASSERT_TRUE(format->writeObject(*material, stream).success());
    EXPECT_EQ(stream.str(), materialFileBytes(testMaterials()[0]));
    auto result = format->readNode(stream);
    const osg::ref_ptr<osg::Node> node = result.takeNode();
    auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
    expectMaterial(effect, testMaterials()[0]);
    EXPECT_EQ(effect->getNumChildren(), 1u);
    std::istringstream other("nothing");
    EXPECT_FALSE(format->readObject(other).success());
    const osg::ref_ptr<MaterialObject> none = new MaterialObject;
    EXPECT_FALSE(format->writeObject(*none, stream).success());
}

}  // namespace
}  // namespace fbrdf::test
