// Environments in scene files, in option strings, and in scenes for programs without the plugin.
#include "EnvironmentTest.h"
#include "FilesTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"

#include <Arguments.h>

#include <osg/LightModel>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <fstream>

namespace fbrdf::test {
namespace {

using osgFbrdf::EnvironmentLight;
using osgFbrdf::FactorizedBrdf;

// The text formats write six digits of the vertices.
constexpr double kFewDigits = 1e-3;

struct Finder : public osg::NodeVisitor {
    Finder() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Group& group) override
    {
        if (auto* found = dynamic_cast<EnvironmentLight*>(&group)) environment = found;
        if (auto* found = dynamic_cast<FactorizedBrdf*>(&group)) effect = found;
        traverse(group);
    }
    osg::ref_ptr<EnvironmentLight> environment;
    osg::ref_ptr<FactorizedBrdf> effect;
};

Finder foundIn(osg::Node* node)
{
    Finder finder;
    if (node) node->accept(finder);
    return finder;
}

class EnvironmentFiles : public FilesTest {
protected:
    void SetUp() override
    {
        FilesTest::SetUp();
        material_ = withLobes(material_, testLobes(LobeAxes::tilted, 2));
        writeMaterial(material_, path("noise.fbrdf"));
    }
    /// A picture of 4 x 2 pixels, upper row first: 2, 1, 0.5 in its first pixel and 0 elsewhere.
    std::string picture(const std::string& name) const
    {
        const std::string bright("\x80\x40\x20\x82", 4), black(28, '\0');
        std::ofstream(path(name), std::ios::binary)
            << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n"
            << bright << black;
        return path(name);
    }
    osg::ref_ptr<osg::Group> litBall(EnvironmentLight* environment) const
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        effect->setMaterialFile(path("noise.fbrdf"));
        effect->addChild(osgMesh(sphereMesh(12)));
        effect->setFloatTarget(true);
        // A plain Group above would be taken for the node that turns plain lights on.
        osg::ref_ptr<osg::Group> root = new osg::MatrixTransform;
        root->addChild(effect);
        root->addChild(environment);
        return root;
    }
    static osg::ref_ptr<EnvironmentLight> turned(EnvironmentLight* environment)
    {
        environment->setFaceSize(kFaceSize);
        environment->setRotation(0.5f);
        environment->setIntensity({0.5f, 1.0f, 2.0f});
        environment->setLobes(1);
        environment->setName("sky");
        return environment;
    }
    static void expectTurned(const EnvironmentLight* environment)
    {
        ASSERT_TRUE(environment);
        EXPECT_EQ(environment->getFaceSize(), kFaceSize);
        EXPECT_EQ(environment->getRotation(), 0.5f);
        EXPECT_EQ(environment->getIntensity(), osg::Vec3f(0.5f, 1.0f, 2.0f));
        EXPECT_EQ(environment->getLobes(), 1);
        EXPECT_EQ(environment->getName(), "sky");
        EXPECT_TRUE(environment->valid());
    }
};

class EnvironmentIn : public EnvironmentFiles, public ::testing::WithParamInterface<const char*> {};

TEST_P(EnvironmentIn, ComesBackByTheNameOfItsPicture)
{
    const std::string sky = picture("sky.hdr"), file = path(std::string("scene.") + GetParam());
    const auto environment = turned(new EnvironmentLight);
    ASSERT_TRUE(environment->setPictureFile(sky));
    const Notices notices;
    ASSERT_TRUE(osgDB::writeNodeFile(*litBall(environment), file));
    const auto node = osgDB::readRefNodeFile(file);
    const auto read = foundIn(node).environment;
    expectTurned(read);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->getPictureFile(), sky);
    EXPECT_EQ(read->getPanorama()->texels, environment->getPanorama()->texels);
    EXPECT_EQ(notices.text(), "");
    EXPECT_GT(meanOf(imageOf(node), 0), 0.01);
    EXPECT_EQ(foundIn(node).effect->lastReport().whyNoEnvironment, "");
}

TEST_P(EnvironmentIn, OfAPictureFromMemoryComesBackWhole)
{
    const std::string file = path(std::string("scene.") + GetParam());
    const auto environment = turned(osgEnvironment(testPanorama(16)));
    const Notices notices;
    const auto before = litBall(environment);
    ASSERT_TRUE(osgDB::writeNodeFile(*before, file));
    const auto node = osgDB::readRefNodeFile(file);
    const auto read = foundIn(node).environment;
    expectTurned(read);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->getPictureFile(), "");
    EXPECT_EQ(read->getPanorama()->width, 16);
    EXPECT_EQ(read->getPanorama()->texels, environment->getPanorama()->texels);
    EXPECT_EQ(notices.text(), "");
    EXPECT_LT(compareImages(imageOf(node), imageOf(before)).maxRelative, kFewDigits);
}

TEST_P(EnvironmentIn, WhosePictureIsGoneGivesAWarningAndTheSceneStays)
{
    const std::string sky = picture("sky.hdr"), file = path(std::string("scene.") + GetParam());
    const auto environment = turned(new EnvironmentLight);
    ASSERT_TRUE(environment->setPictureFile(sky));
    ASSERT_TRUE(osgDB::writeNodeFile(*litBall(environment), file));
    std::remove(sky.c_str());
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(file);
    const Finder found = foundIn(node);
    ASSERT_TRUE(found.environment && found.effect);
    EXPECT_FALSE(found.environment->valid());
    EXPECT_EQ(found.environment->getPictureFile(), sky);
    EXPECT_EQ(found.environment->getRotation(), 0.5f);  // what comes after it in the file
    EXPECT_NE(notices.text().find("sky.hdr: found no such file"), std::string::npos)
        << notices.text();
    EXPECT_GT(meanOf(imageOf(node), 3), 0.3);
}

TEST_P(EnvironmentIn, ThePlainFormIsAmbientLightAndComesBack)
{
    const std::string plain = path(std::string("plain.") + GetParam());
    const auto environment = turned(osgEnvironment(whitePanorama()));
    ASSERT_TRUE(osgDB::writeNodeFile(*litBall(environment), plain + ".fbrdf"));
    const auto without = osgDB::readRefNodeFile(plain);
    ASSERT_TRUE(without);
    EXPECT_FALSE(foundIn(without).environment);
    const auto* state = without->getStateSet();
    ASSERT_TRUE(state);
    const auto* model =
        dynamic_cast<const osg::LightModel*>(state->getAttribute(osg::StateAttribute::LIGHTMODEL));
    ASSERT_TRUE(model);
    EXPECT_NEAR(double(model->getAmbientIntensity().z()), 2.0, 1e-4);
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(plain + ".fbrdf");
    expectTurned(foundIn(node).environment);
    EXPECT_FALSE(node->getStateSet() &&
                 node->getStateSet()->getAttribute(osg::StateAttribute::LIGHTMODEL));
    EXPECT_EQ(notices.text(), "");
}

// A text that ends early, a number of texels that cannot be: a warning, and no crash.
TEST_P(EnvironmentIn, DamageIsSurvived)
{
    const std::string file = path(std::string("scene.") + GetParam());
    ASSERT_TRUE(osgDB::writeNodeFile(*litBall(osgEnvironment(testPanorama(8))), file));
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    const std::string whole = bytes.str();
    const Notices notices;
    for (const double share : {0.5, 0.9, 0.97}) {
        std::ofstream(file, std::ios::binary)
            << whole.substr(0, static_cast<size_t>(share * static_cast<double>(whole.size())));
        const auto node = osgDB::readRefNodeFile(file);
        if (const auto read = foundIn(node).environment) {
            EXPECT_TRUE(!read->valid() || read->getPanorama()->texels.size() == 32u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, EnvironmentIn, ::testing::Values("osgt", "osgb", "osgx"));

TEST_F(EnvironmentFiles, OptionsNameOneForMaterialsAndModels)
{
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("exposure=2 environment=" + picture("sky.hdr") +
                           " environmentRotation=90 environmentIntensity=0.5 environmentLobes=1");
    osgDB::writeNodeFile(*osgMesh(sphereMesh(12)), path("ball.osgt"));
    for (const std::string& file :
         {path("noise.fbrdf"), path("ball.osgt") + ".[" + path("noise.fbrdf") + "].fbrdf"}) {
        const Notices notices;
        const auto node = osgDB::readRefNodeFile(file, options);
        const Finder found = foundIn(node);
        ASSERT_TRUE(found.effect && found.environment) << file;
        EXPECT_EQ(found.effect->getExposure(), 2.0f);
        EXPECT_NEAR(double(found.environment->getRotation()), 0.5 * osg::PI, 1e-6);
        EXPECT_EQ(found.environment->getIntensity(), osg::Vec3f(0.5f, 0.5f, 0.5f));
        EXPECT_EQ(found.environment->getLobes(), 1);
        EXPECT_TRUE(found.environment->valid());
        EXPECT_EQ(notices.text(), "");
    }
}

TEST_F(EnvironmentFiles, OptionsOutOfRangeAreRefusedByName)
{
    std::vector<std::string> problems;
    const auto read = [&](const std::string& options) {
        problems.clear();
        return osgFbrdf::environmentOf(options, nullptr, problems);
    };
    EXPECT_FALSE(read("exposure=2 environmentRotation=30"));
    EXPECT_TRUE(problems.empty());
    EXPECT_FALSE(read("environment="));
    EXPECT_EQ(problems.size(), 1u);
    EXPECT_FALSE(read("environmentRotation=left environmentIntensity=-1 environmentLobes=x"));
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_NE(problems[0].find("environmentRotation=left"), std::string::npos);
}

TEST_F(EnvironmentFiles, APictureThatIsNoneLeavesTheMaterialUnlitByIt)
{
    std::ofstream(path("text.hdr")) << "no picture";
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("floatTarget=1 environment=" + path("text.hdr"));
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(path("noise.fbrdf"), options);
    ASSERT_TRUE(foundIn(node).effect);
    EXPECT_GT(meanOf(imageOf(node), 0), 0.01);
    EXPECT_EQ(notices.text(), "osgFbrdf: " + path("text.hdr") +
                                  ": found a file of another kind, expected Radiance HDR from the "
                                  "top\n");
}

TEST_F(EnvironmentFiles, TheExampleSavesASceneWithASky)
{
    const std::string text = run(std::string(FBRDF_OSG_KNOT) + " --environment overcast " +
                                 path("noise.fbrdf") + " " + path("knot.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto found = foundIn(osgDB::readRefNodeFile(path("knot.osgt")));
    ASSERT_TRUE(found.environment);
    EXPECT_EQ(found.environment->getPictureFile(), "overcast");
    EXPECT_TRUE(found.environment->valid());
    run(std::string(FBRDF_OSG_KNOT) + " --environment gone.hdr " + path("noise.fbrdf") + " " +
        path("none.osgt"));
    EXPECT_NE(status_, 0);
}

}  // namespace
}  // namespace fbrdf::test
