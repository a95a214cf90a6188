// .fbrdf files as resources of OGRE: reloading, and what is drawn where there is no material.
#include "OgreTest.h"

#include "support/FileBytes.h"
#include "support/NewerFile.h"

#include <fbrdf/io/MaterialFile.h>

namespace fbrdf::test {
namespace {

// That of PicturesGLTest.cpp.
constexpr double kMean = 5e-6;

class OgreResources : public OgreTest {
protected:
    void SetUp() override
    {
        OgreTest::SetUp();
        host().addMesh("sphere", mesh_);
        host().setView(perspectiveView());
        for (const Light& light : unlimitedLights(9)) host().addLight(light);
    }

    Ogre::ResourcePtr resource(const std::string& name)
    {
        return Ogre::ResourceGroupManager::getSingleton()
            ._getResourceManager("Fbrdf")
            ->getResourceByName(name, "General");
    }
    void expectRuntimes(const Material& material)
    {
        const auto d =
            compareImages(host().picture(),
                          runtimePicture(material, mesh_, unlimitedLights(9), perspectiveView()));
        EXPECT_TRUE(d.comparable && d.meanRelative < kMean) << describe(d);
    }
    static void expectSame(const std::vector<float>& found, const std::vector<float>& expected)
    {
        const auto d = compareImages(found, expected);
        EXPECT_TRUE(d.comparable && d.maxRelative == 0.0) << describe(d);
    }
    /// What OGRE itself draws of a diffuse surface.
    std::vector<float> diffuse(const Vec3f& albedo)
    {
        auto material = Ogre::MaterialManager::getSingleton().create("diffuse", "General");
        material->getTechnique(0)->getPass(0)->setDiffuse(albedo.x, albedo.y, albedo.z, 1.0f);
        Ogre::Entity* entity = host().addEntity("sphere", "diffuse");
        auto pixels = host().picture();
        host().scene().destroyEntity(entity);
        return pixels;
    }
    /// Draws a material of these bytes, which is none, and returns the one line of the log.
    std::string lineOf(const std::string& bytes)
    {
        putFile(file("bad.fbrdf"), bytes);
        addScriptOf("bad");
        const auto expected = diffuse(Vec3f(0.5f));
        host().addEntity("sphere", "bad");
        expectSame(host().picture(), expected);
        host().picture();
        const auto lines = takeLog();
        EXPECT_EQ(lines.size(), 1u);
        return lines.empty() ? "" : lines[0];
    }

    gl::MeshData mesh_ = sphereMesh(24);
};
FBRDF_ON_BOTH_SYSTEMS(OgreResources);

TEST_P(OgreResources, AReloadedFileIsDrawn)
{
    addMaterial("m", testMaterials()[0]);
    host().addEntity("sphere", "m");
    expectRuntimes(testMaterials()[0]);
    // Other texels, and another form.
    for (const Material& other :
         {noiseMaterial(testMaterials()[0].form, Storage::log8, 7), everythingMaterial()}) {
        writeMaterial(other, file("m.fbrdf"));
        resource("m.fbrdf")->reload();
        expectRuntimes(other);
    }
}

TEST_P(OgreResources, AfterABadFileTheLastGoodMaterialStays)
{
    addMaterial("m", testMaterials()[0]);
    host().addEntity("sphere", "m");
    host().picture();
    putFile(file("m.fbrdf"), "no material");
    resource("m.fbrdf")->reload();
    expectRuntimes(testMaterials()[0]);
    const auto lines = takeLog();
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].find("ogreFbrdf: the last good material stays: m.fbrdf: found "), 0u)
        << lines[0];
}

TEST_P(OgreResources, ABadFileThatIsMendedIsDrawn)
{
    lineOf("no material");
    writeMaterial(testMaterials()[0], file("bad.fbrdf"));
    resource("bad.fbrdf")->reload();
    expectRuntimes(testMaterials()[0]);
}

TEST_P(OgreResources, WhatIsUnloadedComesBack)
{
    addMaterial("m", testMaterials()[0]);
    host().addEntity("sphere", "m");
    host().picture();
    resource("m.fbrdf")->unload();
    EXPECT_FALSE(resource("m.fbrdf")->isLoaded());
    resource("m.fbrdf")->load();
    expectRuntimes(testMaterials()[0]);
    // Both, as the unloading of a group does it; the material of OGRE loads itself when it is
    // drawn.
    Ogre::MaterialManager::getSingleton().getByName("m")->unload();
    resource("m.fbrdf")->unload();
    host().picture();
    expectRuntimes(testMaterials()[0]);
    EXPECT_TRUE(resource("m.fbrdf")->isLoaded());
}

TEST_P(OgreResources, MaterialsThatShareAFileShareItsTexturesAndProgram)
{
    addMaterial("m", testMaterials()[0]);
    host().addScript(
        "material n\n{\ntechnique\n{\npass\n{\nrtshader_system\n{\nfbrdf m.fbrdf exposure "
        "2\n}\n}\n}\n}\n");
    Ogre::Entity *one = host().addEntity("sphere", "m"), *other = host().addEntity("sphere", "n");
    host().picture();
    EXPECT_EQ(programOf(*one), programOf(*other));
    EXPECT_GT(resource("m.fbrdf")->getSize(), 0u);
}

TEST_P(OgreResources, AMissingFileIsNamedAndADiffuseModelDrawn)
{
    addScriptOf("gone");
    const auto expected = diffuse(Vec3f(0.5f));
    host().addEntity("sphere", "gone");
    expectSame(host().picture(), expected);
    EXPECT_EQ(takeLog(),
              std::vector<std::string>{"ogreFbrdf: 'gone': diffuse fallback is drawn: gone.fbrdf: "
                                       "found no such file, expected a material"});
}

TEST_P(OgreResources, AFileThatCannotBeReadIsNamedAndADiffuseModelDrawn)
{
    addMaterial("m", testMaterials()[0]);
    std::filesystem::remove(file("m.fbrdf"));  // OGRE has listed it
    const auto expected = diffuse(Vec3f(0.5f));
    host().addEntity("sphere", "m");
    expectSame(host().picture(), expected);
    EXPECT_EQ(takeLog(),
              std::vector<std::string>{"ogreFbrdf: 'm': diffuse fallback is drawn: m.fbrdf: found "
                                       "a file that cannot be read, expected a material"});
}

TEST_P(OgreResources, ABrokenFileIsNamedAndADiffuseModelDrawn)
{
    const std::string whole = materialFileBytes(testMaterials()[0]);
    const std::string line = lineOf(whole.substr(0, whole.size() / 2));
    EXPECT_EQ(line.find("ogreFbrdf: 'bad': diffuse fallback is drawn: bad.fbrdf: "), 0u) << line;
    EXPECT_NE(line.find("found "), std::string::npos) << line;
}

TEST_P(OgreResources, AFileOfAnotherKindIsNamedAndADiffuseModelDrawn)
{
    const std::string line = lineOf("newmtl gold\nKd 1 1 0\n");
    EXPECT_EQ(line.find("ogreFbrdf: 'bad': diffuse fallback is drawn: bad.fbrdf: found "), 0u)
        << line;
}

TEST_P(OgreResources, ANewerFileIsNamedAndADiffuseModelDrawn)
{
    writeMaterial(testMaterials()[0], file("old.fbrdf"));
    writeNewerVersion(file("old.fbrdf"), file("new.fbrdf"));
    const std::string line = lineOf(fileBytes(file("new.fbrdf")));
    EXPECT_NE(line.find("bad.fbrdf"), std::string::npos) << line;
    EXPECT_NE(line.find("version"), std::string::npos) << line;
}

TEST_P(OgreResources, TooFewTextureUnitsAreNamedAndTheAlbedoIsDrawn)
{
    const Material material = testMaterials()[0];
    host().root().getRenderSystem()->getMutableCapabilities()->setNumTextureUnits(2);
    addMaterial("m", material);
    const auto expected = diffuse(diffuseAlbedo(material));
    host().addEntity("sphere", "m");
    expectSame(host().picture(), expected);
    // Another number of lights makes OGRE build its techniques anew; the log has the line already.
    host().addLight(unlimitedLights(10)[9]);
    host().picture();
    EXPECT_EQ(takeLog(), std::vector<std::string>{
                             "ogreFbrdf: 'm': diffuse fallback is drawn: m.fbrdf: texture "
                             "units: found 2, expected at least 3"});
}

TEST_P(OgreResources, TheFallbackCanBeAskedFor)
{
    const Material material = testMaterials()[0];
    addMaterial("m", material, "technique diffuse");
    const auto expected = diffuse(diffuseAlbedo(material));
    host().addEntity("sphere", "m");
    expectSame(host().picture(), expected);
}

// GL3Plus draws nothing at all without GLSL.
class OgreWithoutGlsl : public OgreResources {};
INSTANTIATE_TEST_SUITE_P(Systems, OgreWithoutGlsl, ::testing::Values("GL"), systemName);

TEST_P(OgreWithoutGlsl, TheAlbedoIsDrawnByFixedFunction)
{
    const Material material = testMaterials()[0];
    host().generator().setTargetLanguage("hlsl");
    addMaterial("m", material);
    const auto expected = diffuse(diffuseAlbedo(material));
    host().addEntity("sphere", "m");
    expectSame(host().picture(), expected);
    EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.1f);
    EXPECT_EQ(takeLog(),
              std::vector<std::string>{"ogreFbrdf: 'm': diffuse fallback is drawn: m.fbrdf: found "
                                       "shader language 'hlsl', expected glsl"});
}

}  // namespace
}  // namespace fbrdf::test
