// What osgDB does with materials and scenes: plugin, options, pseudo-loader, serializers.
#include "OsgScene.h"

#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <Arguments.h>

#include <fbrdf/io/MaterialFile.h>

#include <osg/MatrixTransform>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::PointLights;

TEST(PseudoName, SplitsModelAndMaterial)
{
    const std::vector<std::array<std::string, 3>> cases{
        {"cow.osgt.[gold.fbrdf].fbrdf", "cow.osgt", "gold.fbrdf"},
        {"a/cow.osgt.[maps/gold.json].fbrdf", "a/cow.osgt", "maps/gold.json"},
        {"cow.osgt.90,0,0.rot.[gold.fbrdf].fbrdf", "cow.osgt.90,0,0.rot", "gold.fbrdf"},
        {"cow.osgt.gold.fbrdf", "cow.osgt", "gold.fbrdf"},
        {"gold.fbrdf", "", ""},
        {"gold.v2.fbrdf", "", ""},
        {"[gold].fbrdf", "", ""},
        {"cow].fbrdf", "", ""}};
    for (const auto& [file, model, material] : cases) {
        EXPECT_EQ(osgFbrdf::pseudoName(file).model, model) << file;
        EXPECT_EQ(osgFbrdf::pseudoName(file).material, material) << file;
    }
}

TEST(Options, AreAppliedOrRefusedByName)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    EXPECT_TRUE(osgFbrdf::applyOptions(*effect,
                                       "exposure=2.5 technique=two-lookup lightsPerPass=4 "
                                       "lookupsPerPass=3 firstTextureUnit=2 floatTarget=1 "
                                       "somebodyElses=1 word")
                    .empty());
    EXPECT_EQ(effect->getExposure(), 2.5f);
    EXPECT_EQ(effect->getSelectedTechnique(), osgFbrdf::kTwoLookups);
    EXPECT_EQ(effect->getLightsPerPass(), 4);
    EXPECT_EQ(effect->getLookupsPerPass(), 3);
    EXPECT_EQ(effect->getFirstTextureUnit(), 2);
    EXPECT_TRUE(effect->getFloatTarget());
    const std::string bad =
        "exposure=-1 exposure= technique=best lightsPerPass=0 "
        "lookupsPerPass=2x firstTextureUnit=-1 floatTarget=yes";
    EXPECT_EQ(osgFbrdf::applyOptions(*effect, bad).size(), 7u);
    EXPECT_EQ(effect->getExposure(), 2.5f);
}

class Files : public OsgTest {
protected:
    void SetUp() override
    {
        OsgTest::SetUp();
        writeMaterial(material_, path("noise.fbrdf"));
    }

    std::string path(const std::string& name) const { return folder_.file(name); }

    /// What a scene of the files looks like.
    std::vector<float> imageOf(osg::Node* node)
    {
        OsgView view(context().loader());
        view.setView(perspectiveView());
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(node);
        root->addChild(osgLights(testLights(9)));
        view.setScene(root);
        return view.frame();
    }

    osg::ref_ptr<osg::Group> scene() const
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        effect->setMaterialFile(path("noise.fbrdf"));
        effect->setExposure(1.5f);
        effect->setLightsPerPass(3);
        effect->setLookupsPerPass(7);
        effect->setFirstTextureUnit(2);
        effect->setFloatTarget(true);
        effect->selectTechnique(osgFbrdf::kBatched);
        effect->addChild(osgMesh(sphereMesh(12)));
        osg::ref_ptr<osg::MatrixTransform> root =
            new osg::MatrixTransform(osg::Matrixd::rotate(0.3, 0.0, 1.0, 0.0));
        root->addChild(effect);
        root->addChild(osgLights(testLights(64)));
        return root;
    }

    /// Runs a program that knows the plugins by OSG_LIBRARY_PATH and nothing else.
    std::string run(const std::string& command) const
    {
        const std::string whole = std::string("env -u LD_LIBRARY_PATH " FBRDF_OSG_ENVIRONMENT
                                              "OSG_LIBRARY_PATH=" FBRDF_OSG_LIBRARY_PATH) +
                                  " " + command + " >" + path("log") + " 2>&1";
        status_ = std::system(whole.c_str());
        std::ostringstream text;
        text << std::ifstream(path("log")).rdbuf();
        return text.str();
    }

    Material material_ = testMaterials()[2];
    mutable int status_ = 0;

private:
    TemporaryDir folder_;
};

TEST_F(Files, AMaterialIsAnObject)
{
    const auto object = osgDB::readRefObjectFile(path("noise.fbrdf"));
    const auto* material = dynamic_cast<osgFbrdf::MaterialObject*>(object.get());
    ASSERT_TRUE(material);
    EXPECT_TRUE(material->valid());
    EXPECT_EQ(material->material().form.name, material_.form.name);
    for (unsigned int c = 0; c < 3; ++c) EXPECT_GT(material->albedo()[c], 0.0f);
}

TEST_F(Files, AMaterialIsANodeASphere)
{
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("floatTarget=1 exposure=2");
    const auto node = osgDB::readRefNodeFile(path("noise.fbrdf"), options);
    auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
    ASSERT_TRUE(effect);
    EXPECT_EQ(effect->getExposure(), 2.0f);
    EXPECT_NEAR(static_cast<double>(effect->getBound().radius()), 1.0, 0.8);
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.3);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
}

TEST_F(Files, APseudoFileIsAModelWithAMaterial)
{
    osgDB::writeNodeFile(*osgMesh(sphereMesh(12)), path("ball.osgt"));
    const auto node =
        osgDB::readRefNodeFile(path("ball.osgt") + ".[" + path("noise.fbrdf") + "].fbrdf");
    auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
    ASSERT_TRUE(effect);
    ASSERT_TRUE(effect->getMaterial());
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.3);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
}

TEST_F(Files, APseudoFileWithoutItsMaterialIsStillAModel)
{
    osgDB::writeNodeFile(*osgMesh(sphereMesh(12)), path("ball.osgt"));
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(path("ball.osgt") + ".[gone.fbrdf].fbrdf");
    auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
    ASSERT_TRUE(effect);
    EXPECT_NE(notices.text().find("gone.fbrdf"), std::string::npos) << notices.text();
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.3);
}

TEST_F(Files, ADamagedMaterialIsRefusedWithItsReason)
{
    std::ifstream whole(path("noise.fbrdf"), std::ios::binary);
    std::ostringstream bytes;
    bytes << whole.rdbuf();
    std::ofstream(path("half.fbrdf"), std::ios::binary)
        << bytes.str().substr(0, bytes.str().size() / 2);
    const Notices notices;
    EXPECT_FALSE(osgFbrdf::readMaterialObject(path("half.fbrdf")));
    EXPECT_NE(notices.text().find("half.fbrdf"), std::string::npos) << notices.text();
}

TEST_F(Files, ReloadingABrokenFileKeepsTheMaterial)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    ASSERT_TRUE(effect->setMaterialFile(path("noise.fbrdf")));
    const osg::ref_ptr<osgFbrdf::MaterialObject> good = effect->getMaterial();
    EXPECT_TRUE(effect->reloadMaterial());
    EXPECT_NE(effect->getMaterial(), good.get());
    const osg::ref_ptr<osgFbrdf::MaterialObject> again = effect->getMaterial();
    std::ofstream(path("noise.fbrdf")) << "nothing";
    const Notices notices;
    EXPECT_FALSE(effect->reloadMaterial());
    EXPECT_EQ(effect->getMaterial(), again.get());
    EXPECT_FALSE(notices.text().empty());
}

class RoundTrip : public Files, public ::testing::WithParamInterface<const char*> {};

TEST_P(RoundTrip, KeepsEverything)
{
    const auto before = scene();
    const std::string file = path(std::string("scene.") + GetParam());
    ASSERT_TRUE(osgDB::writeNodeFile(*before, file));
    const auto node = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(node);
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    auto* effect = dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0));
    auto* lights = dynamic_cast<PointLights*>(node->asGroup()->getChild(1));
    ASSERT_TRUE(effect && lights);
    EXPECT_EQ(effect->getMaterialFile(), path("noise.fbrdf"));
    ASSERT_TRUE(effect->getMaterial());
    EXPECT_EQ(effect->getExposure(), 1.5f);
    EXPECT_EQ(effect->getLightsPerPass(), 3);
    EXPECT_EQ(effect->getLookupsPerPass(), 7);
    EXPECT_EQ(effect->getFirstTextureUnit(), 2);
    EXPECT_TRUE(effect->getFloatTarget());
    EXPECT_EQ(effect->getSelectedTechnique(), osgFbrdf::kBatched);
    const auto expected = testLights(64);
    ASSERT_EQ(lights->getLights().size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(lights->getLights()[i].type, expected[i].type);
        // The text formats write few digits.
        EXPECT_LT(glm::distance(lights->getLights()[i].position, expected[i].position), 1e-4f);
        EXPECT_LT(glm::distance(lights->getLights()[i].intensity, expected[i].intensity), 1e-4f);
        if (expected[i].type != fbrdf::Light::Type::point) continue;  // only they have a radius
        EXPECT_NEAR(static_cast<double>(lights->getLights()[i].radius),
                    static_cast<double>(expected[i].radius), 1e-4);
    }
    EXPECT_GT(meanOf(imageOf(node), 0), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::Values("osgt", "osgb", "osgx"));

TEST_F(Files, ASceneFindsItsMaterialBesideIt)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setDatabasePath(osgDB::getFilePath(path("x")));
    ASSERT_TRUE(effect->setMaterialFile("noise.fbrdf", options));
    effect->addChild(osgMesh(sphereMesh(6)));
    ASSERT_TRUE(osgDB::writeNodeFile(*effect, path("scene.osgt")));
    const auto node = osgDB::readRefNodeFile(path("scene.osgt"));
    const auto* read = dynamic_cast<FactorizedBrdf*>(node.get());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->getMaterialFile(), "noise.fbrdf");
    EXPECT_TRUE(read->getMaterial());
}

TEST_F(Files, OsgconvShowsThePluginAndItsOptions)
{
    const std::string text = run(std::string("osgconv --plugin ") + FBRDF_OSG_PLUGIN_FILE);
    EXPECT_EQ(status_, 0) << text;
    for (const char* word : {"fbrdf", "exposure=<number>", "technique=", "lightsPerPass="})
        EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST_F(Files, AFreshProcessConvertsASceneByTheEnvironmentAlone)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*scene(), path("scene.osgt")));
    const std::string text = run("osgconv " + path("scene.osgt") + " " + path("converted.osgb"));
    EXPECT_EQ(status_, 0) << text;
    const auto node = osgDB::readRefNodeFile(path("converted.osgb"));
    ASSERT_TRUE(node) << text;
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u) << text;
    EXPECT_TRUE(dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0)));
    const auto* lights = dynamic_cast<PointLights*>(node->asGroup()->getChild(1));
    ASSERT_TRUE(lights);
    EXPECT_EQ(lights->getLights().size(), 64u);
}

}  // namespace
}  // namespace fbrdf::test
