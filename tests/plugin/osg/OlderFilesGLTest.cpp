// Files of data/, which version 0.1 wrote before the plugin moved to plugin/osg: they are read, and
// draw what the same scene made anew draws.
#include "FilesTest.h"

#include "support/gl/CompareImages.h"

#include <osgDB/ReadFile>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::PointLights;

// Text has six digits of every number.
constexpr double kText = 1e-3;

std::string dataFile(const std::string& name)
{
    return "tests/plugin/osg/data/" + name;
}

float texel(const std::string& table, int index, int channel)
{
    return table == "q"
               ? -0.05f * static_cast<float>(index % 7) - 0.1f * static_cast<float>(channel)
               : 0.02f * static_cast<float>(index % 5);
}

/// The material of metal.fbrdf.
Material metal()
{
    Material metal;
    metal.name = "old metal";
    metal.form = formPqp(6, 0.5);
    for (const TableSpec& spec : metal.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        for (int i = 0; i < texelCount(spec.domain); ++i)
            for (int c = 0; c < 3; ++c) table.texels.push_back(texel(spec.name, i, c));
        metal.tables.push_back(quantized(table, Storage::log8));
    }
    metal.scales.emplace_back(0.8f, 0.6f, 0.3f);
    return metal;
}

osg::ref_ptr<osg::Geometry> squareAt(float x)
{
    gl::MeshData mesh;
    mesh.positions = {{x - 0.9f, -0.9f, 0.0f},
                      {x + 0.9f, -0.9f, 0.0f},
                      {x + 0.9f, 0.9f, 0.0f},
                      {x - 0.9f, 0.9f, 0.0f}};
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    mesh.tangents.assign(4, {1.0f, 0.0f, 0.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return osgMesh(mesh);
}

osg::ref_ptr<PointLights> lights()
{
    osg::ref_ptr<PointLights> lights = new PointLights;
    lights->addPoint({0.0f, 2.0f, 3.0f}, {10.0f, 20.0f, 30.0f}, 9.0f);
    lights->addDirectional({1.0f, 1.0f, 1.0f}, {0.5f, 0.25f, 0.125f});
    PointLights::Spot spot;
    spot.position = {0.0f, 0.0f, 4.0f};
    spot.intensity = {8.0f, 8.0f, 8.0f};
    spot.innerAngle = 0.2f;
    spot.outerAngle = 0.7f;
    spot.radius = 12.0f;
    lights->addSpot(spot);
    return lights;
}

/// The scene that was written.
osg::ref_ptr<osg::Group> sceneMadeAnew()
{
    osg::ref_ptr<FactorizedBrdf> first = new FactorizedBrdf, second = new FactorizedBrdf;
    first->setMaterial(new osgFbrdf::MaterialObject(metal()));
    first->setExposure(1.5f);
    first->setFloatTarget(true);
    first->setTransfer(Transfer::toneMap);
    first->addChild(squareAt(-1.0f));
    second->setMaterial(first->getMaterial());
    second->addChild(squareAt(1.0f));
    osg::ref_ptr<osg::MatrixTransform> root =
        new osg::MatrixTransform(osg::Matrixd::rotate(0.25, 0.0, 1.0, 0.0));
    root->addChild(first);
    root->addChild(second);
    root->addChild(lights());
    return root;
}

class OlderFiles : public OsgTest {
protected:
    std::vector<float> imageOf(osg::Node& scene)
    {
        OsgView view(context().loader());
        view.setView(perspectiveView());
        view.setScene(&scene);
        return view.frame();
    }

    void expectTheScene(const std::string& file)
    {
        const Notices notices;
        const auto scene = osgDB::readRefNodeFile(dataFile(file));
        ASSERT_TRUE(scene) << notices.text();
        // In this order the textures that are made anew are not those that are bound already.
        const auto read = imageOf(*scene), anew = imageOf(*sceneMadeAnew());
        const auto d = compareImages(read, anew);
        EXPECT_TRUE(d.comparable && d.maxRelative < kText) << describe(d);
        EXPECT_EQ(notices.text(), "");
    }
};

TEST_F(OlderFiles, AMaterialIsTheOneThatWasWritten)
{
    const Material read = readMaterial(dataFile("metal.fbrdf")), expected = metal();
    EXPECT_EQ(read.name, expected.name);
    EXPECT_EQ(read.form.name, "pqp");
    ASSERT_EQ(read.tables.size(), expected.tables.size());
    for (size_t i = 0; i < read.tables.size(); ++i) {
        EXPECT_EQ(read.tables[i].storage, Storage::log8);
        EXPECT_EQ(read.tables[i].texels, expected.tables[i].texels) << read.tables[i].name;
    }
    EXPECT_EQ(read.scales, expected.scales);
}

TEST_F(OlderFiles, PropertiesAreThoseThatWereWritten)
{
    const auto scene = osgDB::readRefNodeFile(dataFile("scene.osgt"));
    ASSERT_TRUE(scene && scene->asGroup()->getNumChildren() == 3);
    const auto* effect = dynamic_cast<const FactorizedBrdf*>(scene->asGroup()->getChild(0));
    ASSERT_TRUE(effect);
    EXPECT_EQ(effect->getMaterialFile(), "metal.fbrdf");
    EXPECT_EQ(effect->getExposure(), 1.5f);
    EXPECT_EQ(effect->getLightsPerPass(), 3);
    EXPECT_EQ(effect->getLookupsPerPass(), 7);
    EXPECT_EQ(effect->getFirstTextureUnit(), 1);
    EXPECT_TRUE(effect->getFloatTarget());
    EXPECT_TRUE(effect->getReloading());
    EXPECT_EQ(effect->getSelectedTechnique(), osgFbrdf::kBatched);
    EXPECT_EQ(effect->getTransfer(), Transfer::toneMap);
}

TEST_F(OlderFiles, ATextSceneIsDrawnAsItWas)
{
    expectTheScene("scene.osgt");
}

TEST_F(OlderFiles, ABinarySceneIsDrawnAsItWas)
{
    expectTheScene("scene.osgb");
}

TEST_F(OlderFiles, APlainSceneIsTheSceneAgain)
{
    expectTheScene("plain.osgt.fbrdf");
}

// The pictures would notice a part that is missing.
TEST_F(OlderFiles, AnotherSceneIsNoticed)
{
    const auto scene = sceneMadeAnew();
    const auto whole = imageOf(*scene);
    dynamic_cast<PointLights&>(*scene->getChild(2)).setLights({});
    EXPECT_FALSE(compareImages(imageOf(*scene), whole).maxRelative < 10.0 * kText);
}

}  // namespace
}  // namespace fbrdf::test
