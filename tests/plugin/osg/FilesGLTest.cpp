// What osgDB does with materials and scenes: plugin, options, pseudo-loader, serializers.
#include "FilesTest.h"

#include "support/CommaLocale.h"
#include "support/gl/Scenes.h"
#include "support/NewerFile.h"

#include <Arguments.h>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgUtil/UpdateVisitor>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::PointLights;
using Files = FilesTest;

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
                                       "transfer=tone-map reload=1 preciseFiltering=1 "
                                       "freeTextureUnits=0,11-13 accumulation=RGBA16F "
                                       "somebodyElses=1 word")
                    .empty());
    EXPECT_EQ(effect->getExposure(), 2.5f);
    EXPECT_EQ(effect->getSelectedTechnique(), osgFbrdf::kTwoLookups);
    EXPECT_EQ(effect->getLightsPerPass(), 4);
    EXPECT_EQ(effect->getLookupsPerPass(), 3);
    EXPECT_EQ(effect->getFirstTextureUnit(), 2);
    EXPECT_TRUE(effect->getFloatTarget());
    EXPECT_EQ(effect->getTransfer(), Transfer::toneMap);
    EXPECT_TRUE(effect->getReloading());
    EXPECT_TRUE(effect->getPreciseFiltering());
    EXPECT_EQ(effect->getFreeTextureUnits(), (std::set<int>{0, 11, 12, 13}));
    EXPECT_EQ(effect->getAccumulation(), ColourFormat::rgba16f);
    const std::string bad =
        "exposure=-1 exposure= technique=best lightsPerPass=0 "
        "lookupsPerPass=2x firstTextureUnit=-1 floatTarget=yes "
        "transfer=gamma reload=2 preciseFiltering=on freeTextureUnits=14-11 "
        "freeTextureUnits=-1 freeTextureUnits=1024 freeTextureUnits=3, "
        "accumulation=RGBA16 accumulation=half";
    EXPECT_EQ(osgFbrdf::applyOptions(*effect, bad).size(), 16u);
    EXPECT_EQ(effect->getExposure(), 2.5f);
}

TEST(Options, NameEveryTechnique)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    for (const Technique technique : allTechniques()) {
        const std::string option = std::string("technique=") + techniqueName(technique);
        EXPECT_TRUE(osgFbrdf::applyOptions(*effect, option).empty()) << option;
        EXPECT_EQ(effect->getSelectedTechnique(), static_cast<int>(technique));
    }
    EXPECT_TRUE(osgFbrdf::applyOptions(*effect, "technique=diffuse").empty());
    EXPECT_EQ(effect->getSelectedTechnique(), osgFbrdf::kDiffuseFallback);
    EXPECT_TRUE(osgFbrdf::applyOptions(*effect, "technique=auto").empty());
    EXPECT_EQ(effect->getSelectedTechnique(), osgFX::Effect::AUTO_DETECT);
}

TEST(Options, AreAllInTheDocumentation)
{
    std::ostringstream text;
    text << std::ifstream("docs/openscenegraph.md").rdbuf();
    ASSERT_FALSE(text.str().empty());
    for (const osgFbrdf::OptionText& option : osgFbrdf::optionTexts()) {
        const std::string name = option.name.substr(0, option.name.find('=') + 1);
        EXPECT_NE(text.str().find("| `" + name), std::string::npos) << name;
    }
}

TEST_F(Files, AMaterialIsAnObject)
{
    const auto material = osgFbrdf::readMaterialObject(path("noise.fbrdf"));
    ASSERT_TRUE(material);
    EXPECT_TRUE(material->valid());
    EXPECT_EQ(material->material().form.name, material_.form.name);
    for (int c = 0; c < 3; ++c) EXPECT_GT(material->albedo()[c], 0.0f);
}

// osgconv asks for objects, and crashes when it gets one that is no node.
TEST_F(Files, OsgconvMakesASceneOfAMaterial)
{
    const std::string text = run("osgconv " + path("noise.fbrdf") + " " + path("ball.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto node = osgDB::readRefNodeFile(path("ball.osgt"));
    auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
    ASSERT_TRUE(effect) << text;
    ASSERT_TRUE(effect->getMaterial());
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.3);
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

// The file is looked at once a second of the viewer's clock, which is that of the frame stamp.
TEST_F(Files, AChangedFileIsReadAgainAndABrokenOneIsNot)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    ASSERT_TRUE(effect->setMaterialFile(path("noise.fbrdf")));
    effect->setReloading(true);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect);
    osgUtil::UpdateVisitor visitor;
    const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    visitor.setFrameStamp(stamp);
    double seconds = 0.0;
    const auto update = [&](double step) {
        seconds += step;
        stamp->setReferenceTime(seconds);
        root->accept(visitor);
        return effect->getMaterial();
    };
    const osg::ref_ptr<osgFbrdf::MaterialObject> first = effect->getMaterial();
    EXPECT_EQ(update(2.0), first.get());
    writeMaterial(testMaterials()[4], path("noise.fbrdf"));  // of another size
    EXPECT_EQ(update(0.5), first.get());
    const osg::ref_ptr<osgFbrdf::MaterialObject> second = update(0.6);
    EXPECT_NE(second, first);
    EXPECT_EQ(second->material().form.name, testMaterials()[4].form.name);
    const Notices notices;
    std::ofstream(path("noise.fbrdf")) << "half a file";
    EXPECT_EQ(update(2.0), second.get());
    EXPECT_NE(notices.text().find("noise.fbrdf"), std::string::npos) << notices.text();
    std::remove(path("noise.fbrdf").c_str());
    EXPECT_EQ(update(2.0), second.get());
    writeMaterial(material_, path("noise.fbrdf"));
    EXPECT_EQ(update(2.0)->material().form.name, material_.form.name);
    effect->setReloading(false);
    EXPECT_EQ(effect->getNumChildrenRequiringUpdateTraversal(), 0u);
}

TEST_F(Files, AFileOfANewerVersionIsRefusedWithItsReason)
{
    writeNewerVersion(path("noise.fbrdf"), path("newer.fbrdf"));
    const Notices notices;
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    EXPECT_FALSE(effect->setMaterialFile(path("newer.fbrdf")));
    EXPECT_NE(notices.text().find("newer.fbrdf"), std::string::npos) << notices.text();
    EXPECT_NE(notices.text().find("version 9"), std::string::npos) << notices.text();
    effect->addChild(osgMesh(sphereMesh(12)));
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.3);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
}

TEST_F(Files, ASceneOfANewerFormatIsReadWithAWarning)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*scene(), path("scene.osgt")));
    std::ostringstream text;
    text << std::ifstream(path("scene.osgt")).rdbuf();
    std::string newer = text.str();
    const size_t at = newer.find("Format 1");
    ASSERT_NE(at, std::string::npos);
    newer.replace(at, 8, "Format 99");
    std::ofstream(path("newer.osgt")) << newer;
    const Notices notices;
    const auto node = osgDB::readRefNodeFile(path("newer.osgt"));
    ASSERT_TRUE(node);
    EXPECT_NE(notices.text().find("format 99"), std::string::npos) << notices.text();
}

// The library without its readers gives a warning, and the fallback draws the model.
TEST_F(Files, WithoutThePluginTheLogHasTheReason)
{
    const std::string text =
        runWith("/nowhere", std::string(FBRDF_OSG_KNOT) + " " + path("noise.fbrdf"));
    EXPECT_EQ(WEXITSTATUS(status_), 3) << text;
    EXPECT_NE(text.find("noise.fbrdf"), std::string::npos) << text;
    EXPECT_NE(text.find("OSG_LIBRARY_PATH"), std::string::npos) << text;
}

TEST_F(Files, TheSceneOfTheExampleLoadsByTheEnvironmentAlone)
{
    std::string text =
        run(std::string(FBRDF_OSG_KNOT) + " " + path("noise.fbrdf") + " " + path("knot.osgt"));
    EXPECT_EQ(status_, 0) << text;
    text = run("osgconv " + path("knot.osgt") + " " + path("knot.osgb"));
    EXPECT_EQ(status_, 0) << text;
    EXPECT_EQ(text.find("Error"), std::string::npos) << text;
    const auto node = osgDB::readRefNodeFile(path("knot.osgb"));
    ASSERT_TRUE(node) << text;
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u) << text;
    auto* effect = dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0));
    const auto* lights = dynamic_cast<PointLights*>(node->asGroup()->getChild(1));
    ASSERT_TRUE(effect && lights);
    EXPECT_TRUE(effect->getMaterial());
    EXPECT_EQ(lights->getLights().size(), 200u);
    EXPECT_GT(meanOf(imageOf(effect), 3), 0.1);
}

TEST_F(Files, TheExampleHasAnyNumberOfLightsAndABareModel)
{
    const std::string knot = FBRDF_OSG_KNOT;
    std::string text = run(knot + " --lights 64 " + path("noise.fbrdf") + " " + path("64.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto scene = osgDB::readRefNodeFile(path("64.osgt"));
    ASSERT_TRUE(scene && scene->asGroup()->getNumChildren() == 2) << text;
    const auto* lights = dynamic_cast<PointLights*>(scene->asGroup()->getChild(1));
    ASSERT_TRUE(lights);
    EXPECT_EQ(lights->getLights().size(), 64u);
    text = run(knot + " --model " + path("knot.osgt"));
    EXPECT_EQ(status_, 0) << text;
    const auto model = osgDB::readRefNodeFile(path("knot.osgt") + ".noise.fbrdf");
    const auto* effect = dynamic_cast<FactorizedBrdf*>(model.get());
    ASSERT_TRUE(effect) << text;
    EXPECT_TRUE(effect->getMaterial());
    for (const char* bad :
         {" --lights 0 ", " --lights x ", " --lights 1000000 ", " --model a.osgt "}) {
        text = run(knot + bad + path("noise.fbrdf"));
        EXPECT_EQ(WEXITSTATUS(status_), 2) << bad << text;
    }
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
    EXPECT_EQ(effect->getTransfer(), Transfer::srgb);
    EXPECT_TRUE(effect->getReloading());
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

// Files have these properties only where they differ from the default, as files of older versions
// have none.
TEST_P(RoundTrip, KeepsWhatAddsToTheFormat)
{
    const std::set<int> units{11, 12, 14};
    for (const bool precise : {true, false})
        for (const bool keeps : {true, false}) {
            const auto before = scene();
            auto& written = dynamic_cast<FactorizedBrdf&>(*before->getChild(0));
            written.setPreciseFiltering(precise);
            if (keeps) written.setFreeTextureUnits(units);
            if (keeps) written.setAccumulation(ColourFormat::rgba8);
            const std::string file = path(std::string("precise.") + GetParam());
            ASSERT_TRUE(osgDB::writeNodeFile(*before, file));
            const auto node = osgDB::readRefNodeFile(file);
            ASSERT_TRUE(node);
            ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
            const auto* effect = dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0));
            ASSERT_TRUE(effect && effect->getMaterial());
            EXPECT_EQ(effect->getPreciseFiltering(), precise);
            EXPECT_EQ(effect->getFreeTextureUnits(), keeps ? units : std::set<int>());
            EXPECT_EQ(effect->getAccumulation(),
                      keeps ? ColourFormat::rgba8 : ColourFormat::rgba32f);
            EXPECT_TRUE(effect->getReloading());
            EXPECT_EQ(dynamic_cast<PointLights*>(node->asGroup()->getChild(1))->getLights().size(),
                      testLights(64).size());
        }
}

// OSG's own writers follow the locale that a host has set.
TEST_P(RoundTrip, IsTheSameFileInAHostWithDecimalCommas)
{
    const auto written = [&](const std::string& name) {
        const std::string file = path(name + "." + GetParam());
        EXPECT_TRUE(osgDB::writeNodeFile(*scene(), file));
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    };
    const std::string classic = written("classic");
    const CommaLocale host;
    std::ostringstream number;
    number << 1000.5;
    ASSERT_EQ(number.str(), "1.000,5");
    EXPECT_EQ(written("commas"), classic);
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
