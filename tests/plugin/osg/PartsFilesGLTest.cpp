// Parts of a model with materials of their own in names, options and files.
#include "FilesTest.h"
#include "PartsTest.h"

#include <Arguments.h>

#include <osgFbrdf/PlainForm.h>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::MaterialObject;

TEST(MaterialTable, HasPartsAndTheRest)
{
    std::vector<std::string> problems;
    const auto table = osgFbrdf::materialTable(
        "body:paint.fbrdf,Car%20Paint%2c%3a:maps/red%25.fbrdf,gold.fbrdf,100%:a:b.fbrdf", problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(table.rest, "gold.fbrdf");
    ASSERT_EQ(table.parts.size(), 3u);
    EXPECT_EQ(table.parts[0].part, "body");
    EXPECT_EQ(table.parts[0].file, "paint.fbrdf");
    EXPECT_EQ(table.parts[1].part, "Car Paint,:");
    EXPECT_EQ(table.parts[1].file, "maps/red%.fbrdf");
    EXPECT_EQ(table.parts[2].part, "100%");
    EXPECT_EQ(table.parts[2].file, "a:b.fbrdf");
    EXPECT_TRUE(osgFbrdf::materialTable("", problems).parts.empty());
    EXPECT_TRUE(problems.empty());
}

TEST(MaterialTable, IsRefusedWhereItIsNone)
{
    for (const char* text : {":paint.fbrdf", "body:", "a.fbrdf,b.fbrdf", "body:p.fbrdf,,"}) {
        std::vector<std::string> problems;
        osgFbrdf::materialTable(text, problems);
        ASSERT_EQ(problems.size(), 1u) << text;
        EXPECT_NE(problems[0].find(text), std::string::npos) << problems[0];
    }
}

class PartFiles : public FilesTest {
protected:
    void SetUp() override
    {
        FilesTest::SetUp();
        writeMaterial(testMaterials()[0], path("paint.fbrdf"));
        writeMaterial(testMaterials()[4], path("glass.fbrdf"));
        osgDB::writeNodeFile(*fourBalls(), path("car.osgt"));
    }

    /// An effect with the materials of the files; embedded: without their names.
    osg::ref_ptr<FactorizedBrdf> effect(bool embedded = false) const
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        for (const auto& [part, file] :
             {std::pair("paint", "paint.fbrdf"), std::pair("rims", "noise.fbrdf"),
              std::pair("glass", "glass.fbrdf")}) {
            if (embedded)
                effect->setPartMaterial(part, new MaterialObject(readMaterial(path(file))));
            else
                effect->setPartMaterialFile(part, path(file));
        }
        effect->addChild(fourBalls());
        return effect;
    }
    std::string table() const
    {
        return "paint:" + path("paint.fbrdf") + ",rims:noise.fbrdf,glass:glass.fbrdf";
    }
};

// Six digits of every number are in text files.
void expectAlike(const std::vector<float>& found, const std::vector<float>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    size_t differ = 0;
    for (size_t i = 0; i < found.size(); ++i)
        differ += std::abs(found[i] - expected[i]) > 1e-3f * (0.1f + std::abs(expected[i])) ? 1 : 0;
    EXPECT_LT(differ, found.size() / 500);  // edges of balls
    EXPECT_GT(meanOf(expected, 0), 0.05);
}

TEST_F(PartFiles, AreNamedByPseudoFilesAndOptions)
{
    const Notices notices;
    const auto expected = imageOf(effect());
    const auto named = osgDB::readRefNodeFile(path("car.osgt") + ".[" + table() + "].fbrdf");
    ASSERT_TRUE(dynamic_cast<FactorizedBrdf*>(named.get())) << notices.text();
    expectAlike(imageOf(named), expected);
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("materials=" + table());
    const auto byOption = osgDB::readRefNodeFile(path("car.osgt") + ".[].fbrdf", options);
    ASSERT_TRUE(dynamic_cast<FactorizedBrdf*>(byOption.get())) << notices.text();
    expectAlike(imageOf(byOption), expected);
    const auto both = osgDB::readRefNodeFile(path("car.osgt") + ".[noise.fbrdf].fbrdf", options);
    auto* effect = dynamic_cast<FactorizedBrdf*>(both.get());
    ASSERT_TRUE(effect) << notices.text();
    EXPECT_TRUE(effect->getMaterial());
    EXPECT_EQ(effect->getParts().size(), 3u);
    EXPECT_GT(meanOf(imageOf(both), 3), 0.3);
    EXPECT_EQ(notices.text(), "");
}

TEST_F(PartFiles, OfFilesThatAreNotThereGiveALineWithFileAndPart)
{
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(path("car.osgt") + ".[rims:gone.fbrdf].fbrdf");
    ASSERT_TRUE(node);
    EXPECT_GT(meanOf(imageOf(node), 3), 0.3);
    // The test's scene has one light more than the fallback, which has a line too.
    EXPECT_EQ(notices.text().find("diffuse fallback is drawn"), std::string::npos);
    EXPECT_EQ(std::count(notices.text().begin(), notices.text().end(), '\n'), 2) << notices.text();
    EXPECT_NE(notices.text().find("'rims', gone.fbrdf: "), std::string::npos) << notices.text();
}

class PartsRoundTrip : public PartFiles, public ::testing::WithParamInterface<const char*> {};

TEST_P(PartsRoundTrip, KeepsPartsAndTheirMaterials)
{
    for (const bool embedded : {false, true}) {
        const auto before = effect(embedded);
        before->setPreciseFiltering(embedded);
        before->setExposure(2.0f);
        before->getParts()[1].effect->setExposure(0.5f);
        before->setPart("spare wheel", before->getParts()[1].effect);
        const std::string file = path(std::string("scene.") + GetParam());
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(before);
        scene->addChild(osgLights(testLights(3)));
        ASSERT_TRUE(osgDB::writeNodeFile(*scene, file));
        const Notices notices;
        const auto node = osgDB::readRefNodeFile(file);
        ASSERT_TRUE(node && node->asGroup()->getNumChildren() == 2) << notices.text();
        auto* after = dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0));
        ASSERT_TRUE(after) << notices.text();
        EXPECT_EQ(after->getPreciseFiltering(), embedded);
        ASSERT_EQ(after->getParts().size(), 4u);
        for (size_t i = 0; i < 3; ++i) {
            const FactorizedBrdf& part = *after->getParts()[i].effect;
            EXPECT_EQ(after->getParts()[i].name, kPartNames[i]);
            ASSERT_TRUE(part.getMaterial());
            EXPECT_EQ(part.getMaterialFile(), before->getParts()[i].effect->getMaterialFile());
            EXPECT_EQ(part.getExposure(), i == 1 ? 0.5f : 2.0f);
        }
        EXPECT_EQ(after->getParts()[3].effect, after->getParts()[1].effect);
        expectAlike(imageOf(after), imageOf(before));
    }
}

TEST_P(PartsRoundTrip, HasAPlainFormThatIsRestored)
{
    const auto before = effect();
    before->setMaterialFile(path("noise.fbrdf"));
    const auto expected = imageOf(before);
    const std::string plain = path(std::string("plain.") + GetParam());
    ASSERT_TRUE(osgDB::writeNodeFile(*before, plain + ".fbrdf"));
    EXPECT_EQ(imageOf(before), expected);  // the scene itself is untouched
    const auto bare = osgDB::readRefNodeFile(plain);
    ASSERT_TRUE(bare);
    EXPECT_FALSE(dynamic_cast<FactorizedBrdf*>(bare.get()));
    const auto after = osgDB::readRefNodeFile(plain + ".fbrdf");
    ASSERT_TRUE(dynamic_cast<FactorizedBrdf*>(after.get()));
    expectAlike(imageOf(after), expected);
    struct : osg::NodeVisitor {
        void apply(osg::Node& node) override
        {
            EXPECT_FALSE(node.getUserDataContainer()) << node.getName();
            traverse(node);
        }
    } leftovers;
    leftovers.setTraversalMode(osg::NodeVisitor::TRAVERSE_ALL_CHILDREN);
    dynamic_cast<osg::Group&>(*after).getChild(0)->accept(leftovers);
}

INSTANTIATE_TEST_SUITE_P(Formats, PartsRoundTrip, ::testing::Values("osgt", "osgb", "osgx"));

// Each part of the plain form has the colour of its material, and what is in none its own.
TEST_F(PartFiles, HaveColoursInThePlainForm)
{
    const auto effect = this->effect();
    const auto plain = osgFbrdf::plainForm(*effect);
    struct : osg::NodeVisitor {
        void apply(osg::Node& node) override
        {
            const auto* state = node.getStateSet();
            const auto* pair =
                state ? state->getAttributePair(osg::StateAttribute::MATERIAL) : nullptr;
            if (pair && (pair->second & osg::StateAttribute::OVERRIDE))
                colours.push_back(static_cast<const osg::Material&>(*pair->first)
                                      .getDiffuse(osg::Material::FRONT));
            traverse(node);
        }
        std::vector<osg::Vec4f> colours;
    } found;
    found.setTraversalMode(osg::NodeVisitor::TRAVERSE_ALL_CHILDREN);
    plain->accept(found);
    ASSERT_EQ(found.colours.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        const osg::Vec3f albedo = effect->getParts()[i].effect->getMaterial()->albedo();
        EXPECT_EQ(found.colours[i], osg::Vec4f(albedo, 1.0f)) << i;
    }
}

TEST_F(PartFiles, AreMaterialsInUse)
{
    const auto one = osgFbrdf::readMaterialObject(path("paint.fbrdf"));
    const auto effect = this->effect();
    EXPECT_EQ(effect->getParts()[0].effect->getMaterial(), one.get());
    // A scene of several materials is none; with one alone it is written.
    EXPECT_FALSE(osgDB::writeNodeFile(*effect, path("taken.fbrdf")));
    effect->setPart("rims", nullptr);
    effect->setPart("glass", nullptr);
    EXPECT_TRUE(osgDB::writeNodeFile(*effect, path("taken.fbrdf")));
    EXPECT_EQ(readMaterial(path("taken.fbrdf")).form.name, testMaterials()[0].form.name);
}

TEST_F(PartFiles, AreReadAgainWhenTheyChange)
{
    const auto effect = this->effect();
    effect->setReloading(true);
    osg::NodeVisitor update(osg::NodeVisitor::UPDATE_VISITOR,
                            osg::NodeVisitor::TRAVERSE_ALL_CHILDREN);
    const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    update.setFrameStamp(stamp);
    const auto at = [&](double seconds) {
        stamp->setReferenceTime(seconds);
        effect->accept(update);
        return effect->getParts()[0].effect->getMaterial();
    };
    EXPECT_EQ(at(2.0)->material().form.name, testMaterials()[0].form.name);
    writeMaterial(testMaterials()[4], path("paint.fbrdf"));
    EXPECT_EQ(at(4.0)->material().form.name, testMaterials()[4].form.name);
}

}  // namespace
}  // namespace fbrdf::test
