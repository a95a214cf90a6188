// Textures of the model and vertex code in options and scene files.
#include "FilesTest.h"

#include <Arguments.h>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

TEST(ModelTextureOptions, NameUnits)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    EXPECT_TRUE(
        osgFbrdf::applyOptions(*effect, "tintUnit=0 alphaUnit=2 normalUnit=1 tint=all").empty());
    const osgFbrdf::ModelTextures expected{0, 2, 1, true};
    EXPECT_EQ(effect->getModelTextures(), expected);
    EXPECT_EQ(osgFbrdf::applyOptions(*effect, "tintUnit=-1 alphaUnit=x normalUnit=100000 tint=some")
                  .size(),
              4u);
    EXPECT_EQ(effect->getModelTextures(), expected);
}

class TexturesRoundTrip : public FilesTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(TexturesRoundTrip, KeepsTexturesAndVertexCode)
{
    const auto before = scene();
    osgFbrdf::ModelTextures textures;
    textures.tint = 3;
    textures.normal = 5;
    textures.tintsAll = true;
    const osgFbrdf::VertexHook hook{"// \"quoted\" {\nvoid f()\n{\n}\n", {{"a", 7}, {"b", 9}}};
    auto& written = dynamic_cast<FactorizedBrdf&>(*before->getChild(0));
    written.setModelTextures(textures);
    written.setVertexHook(hook);
    const std::string file = path(std::string("textures.") + GetParam());
    ASSERT_TRUE(osgDB::writeNodeFile(*before, file));
    const auto node = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(node && node->asGroup()->getNumChildren() == 2u);
    const auto* effect = dynamic_cast<FactorizedBrdf*>(node->asGroup()->getChild(0));
    ASSERT_TRUE(effect && effect->getMaterial());
    EXPECT_EQ(effect->getModelTextures(), textures);
    EXPECT_EQ(effect->getVertexHook(), hook);
}

INSTANTIATE_TEST_SUITE_P(Formats, TexturesRoundTrip, ::testing::Values("osgt", "osgb", "osgx"));

}  // namespace
}  // namespace fbrdf::test
