// Area lights in scene files, and in scenes for programs without the plugin.
#include "AreaLightsTest.h"
#include "FilesTest.h"

#include "support/gl/EnvironmentScenes.h"

#include <osg/LightSource>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace fbrdf::test {
namespace {

using osgFbrdf::AreaLights;
using Shape = AreaLight::Shape;

struct Found : public osg::NodeVisitor {
    explicit Found(osg::Node* node) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN)
    {
        if (node) node->accept(*this);
    }
    void apply(osg::Group& group) override
    {
        if (auto* found = dynamic_cast<AreaLights*>(&group)) areas = found;
        traverse(group);
    }
    void apply(osg::LightSource& source) override
    {
        sources.emplace_back(source.getLight());
        traverse(source);
    }
    osg::ref_ptr<AreaLights> areas;
    std::vector<osg::ref_ptr<const osg::Light>> sources;
};

/// What the shape of the light does not read is as in a light that is new: files do not have it.
AreaLight tidied(const AreaLight& light)
{
    AreaLight tidy;
    tidy.shape = light.shape;
    tidy.radiance = light.radiance;
    tidy.radius = light.radius;
    tidy.size = light.size;
    switch (light.shape) {
        case Shape::disc: tidy.normal = light.normal; break;
        case Shape::tube: tidy.end = light.end; break;
        case Shape::polygon: tidy.vertices = light.vertices; return tidy;
        case Shape::rectangle:
            tidy.axisU = light.axisU;
            tidy.axisV = light.axisV;
            break;
        case Shape::sphere: break;
    }
    tidy.position = light.position;
    return tidy;
}

/// One of each shape, and two that are not valid: they are kept as they are.
std::vector<AreaLight> allShapes()
{
    std::vector<AreaLight> lights;
    for (const AreaLight& light : oneOfEach()) lights.push_back(tidied(light));
    lights[2].twoSided = true;
    lights.push_back(tidied(areaLightOf(Shape::sphere)));
    lights.back().size = -1.0f;
    lights.push_back(tidied(areaLightOf(Shape::polygon)));
    lights.back().vertices.resize(static_cast<size_t>(kMostVertices) + 1);
    return lights;
}

void expectEqual(const AreaLight& a, const AreaLight& b)
{
    EXPECT_EQ(a.shape, b.shape);
    EXPECT_EQ(a.radiance, b.radiance);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.twoSided, b.twoSided);
    EXPECT_EQ(a.size, b.size);
    for (const auto member : {&AreaLight::position, &AreaLight::end, &AreaLight::normal,
                              &AreaLight::axisU, &AreaLight::axisV})
        EXPECT_EQ(a.*member, b.*member);
    EXPECT_EQ(a.vertices, b.vertices);
}

void expectAll(const AreaLights* areas)
{
    ASSERT_TRUE(areas);
    EXPECT_EQ(areas->getName(), "soft boxes");
    const auto expected = allShapes();
    ASSERT_EQ(areas->getLights().size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) expectEqual(areas->getLights()[i], expected[i]);
}

class AreaLightsIn : public FilesTest, public ::testing::WithParamInterface<const char*> {
protected:
    osg::ref_ptr<osg::Group> litScene() const
    {
        const auto root = scene(), areas = osg::ref_ptr<osg::Group>(osgAreaLights(allShapes()));
        areas->setName("soft boxes");
        root->addChild(areas);
        return root;
    }
    std::string file() const { return path(std::string("scene.") + GetParam()); }
};

TEST_P(AreaLightsIn, ComeBack)
{
    const Notices notices;
    ASSERT_TRUE(osgDB::writeNodeFile(*litScene(), file()));
    const auto node = osgDB::readRefNodeFile(file());
    expectAll(Found(node).areas);
    EXPECT_EQ(notices.text(), "");
}

TEST_P(AreaLightsIn, ThePlainFormHasLightSourcesAndComesBack)
{
    const auto before = litScene();
    before->removeChild(1, 1);  // the 64 other lights
    ASSERT_TRUE(osgDB::writeNodeFile(*before, file() + ".fbrdf"));
    const auto plain = osgDB::readRefNodeFile(file());
    EXPECT_FALSE(Found(plain).areas);
    EXPECT_EQ(Found(plain).sources.size(), 5u) << "the valid ones";
    const auto after = osgDB::readRefNodeFile(file() + ".fbrdf");
    expectAll(Found(after).areas);
    EXPECT_EQ(Found(after).sources.size(), 0u);
}

// A file that ends early: a warning of osgDB, no crash, and no light that was not written.
TEST_P(AreaLightsIn, DamageIsSurvived)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*osgAreaLights(allShapes()), file()));
    std::ostringstream bytes;
    bytes << std::ifstream(file(), std::ios::binary).rdbuf();
    const std::string whole = bytes.str();
    const Notices notices;
    for (size_t length = whole.size() / 4; length < whole.size(); length += 7) {
        std::ofstream(file(), std::ios::binary) << whole.substr(0, length);
        const auto node = osgDB::readRefNodeFile(file());
        if (const auto areas = Found(node).areas) {
            EXPECT_LE(areas->getLights().size(), allShapes().size());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, AreaLightsIn, ::testing::Values("osgt", "osgb", "osgx"));

using AreaLightsFiles = FilesTest;

// Numbers that no version writes: one line each, and the scene stays.
TEST_F(AreaLightsFiles, HostileNumbersAreNamed)
{
    const struct {
        const char *from, *to, *warning;
    } cases[] = {
        {"Lights 1 ", "Lights 4000000000 ", "found 4000000000 area lights, expected at most"},
        {"4 0 1 2 0.5 0", "9 0 1 2 0.5 0", "found an area light of shape 9, expected 0 to 4"},
        {"  5 1.5 -1 1", "  7000000 1.5 -1 1", "found an area light of 7000000 vertices"},
    };
    for (const auto& [from, to, warning] : cases) {
        ASSERT_TRUE(osgDB::writeNodeFile(*osgAreaLights({areaLightOf(Shape::polygon)}),
                                         path("scene.osgt")));
        std::ostringstream bytes;
        bytes << std::ifstream(path("scene.osgt")).rdbuf();
        std::string text = bytes.str();
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << text;
        text.replace(at, std::string(from).size(), to);
        std::ofstream(path("scene.osgt")) << text;
        const Notices notices;
        osgDB::readRefNodeFile(path("scene.osgt"));
        EXPECT_NE(notices.text().find(warning), std::string::npos) << notices.text();
    }
}

}  // namespace
}  // namespace fbrdf::test
