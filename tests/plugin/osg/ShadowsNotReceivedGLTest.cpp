// The effect says why it has no shadows of osgShadow, and which lights have them.
#include "ShadowScene.h"

#include <osgShadow/ParallelSplitShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ShadowMap>
#include <osgShadow/ViewDependentShadowMap>

#include <algorithm>
#include <set>
#include <string>

namespace fbrdf::test {
namespace {

/// What stands under a ShadowedScene with no technique of osgShadow's.
class NoMaps : public osgShadow::ShadowTechnique {
public:
    META_Object(fbrdf, NoMaps)
    NoMaps() = default;
    NoMaps(const NoMaps& other, const osg::CopyOp& op) : ShadowTechnique(other, op) {}
    void init() override {}
    void update(osg::NodeVisitor& visitor) override { _shadowedScene->Group::traverse(visitor); }
    void cull(osgUtil::CullVisitor& visitor) override { _shadowedScene->Group::traverse(visitor); }
    void resizeGLObjectBuffers(unsigned int) override {}
    void releaseGLObjects(osg::State* = nullptr) const override {}
};

class ShadowsNotReceived : public FloorTest {
protected:
    void SetUp() override
    {
        FloorTest::SetUp();
        for (const int number : {0, 1, 2})
            lamps_.push_back(
                osgLight(number, {0.3f * static_cast<float>(number), 0.5f, 1.2f, 0.0f}));
    }

    /// Draws three frames of the floor; says why it has no shadows.
    std::string whyNot(osgShadow::ShadowTechnique* technique)
    {
        techniques_.emplace_back(technique);
        scene_ = new osgShadow::ShadowedScene(technique);
        for (const auto& lamp : lamps_) scene_->addChild(sourceOf(lamp));
        scene_->addChild(effect_);
        view_->setScene(scene_);
        for (int frame = 0; frame < 2; ++frame) view_->draw();
        EXPECT_GT(meanOf(view_->frame(), 0), 0.1);
        EXPECT_EQ(effect_->lastReport().technique, "single pass");
        view_->setScene(nullptr);
        return effect_->lastReport().whyNoShadows;
    }

    std::vector<osg::ref_ptr<osg::Light>> lamps_;
    osg::ref_ptr<osgShadow::ShadowedScene> scene_;
};

TEST_F(ShadowsNotReceived, HaveTheirReasonInTheReportAndOnceInTheLog)
{
    const Notices notices;
    const std::string reason = whyNot(new NoMaps);
    EXPECT_EQ(reason,
              "found fbrdf::NoMaps without a map of depths in its state, expected a technique of "
              "osgShadow that has maps");
    EXPECT_NE(notices.text().find(reason), std::string::npos) << notices.text();
    EXPECT_EQ(notices.text().find(reason), notices.text().rfind(reason)) << notices.text();
    EXPECT_EQ(effect_->lastReport().shadowMaps, 0);
}

TEST_F(ShadowsNotReceived, AreThoseOfTooManyMaps)
{
    const osg::ref_ptr<osgShadow::ShadowSettings> settings = new osgShadow::ShadowSettings;
    settings->setNumShadowMapsPerLight(3);
    // Three lights with three maps each.
    const osg::ref_ptr<osgShadow::ViewDependentShadowMap> technique =
        new osgShadow::ViewDependentShadowMap;
    whyNot(technique);
    scene_->setShadowSettings(settings);
    view_->setScene(scene_);
    for (int frame = 0; frame < 2; ++frame) view_->draw();
    EXPECT_EQ(effect_->lastReport().whyNoShadows, "found 9 shadow maps, expected at most 8");
    view_->setScene(nullptr);
}

TEST_F(ShadowsNotReceived, LeaveTheirUnitsToMapsOfAMaterialThatNeedsThem)
{
    const std::vector<TableSpec> tables = testMaterials()[0].form.tables;
    const auto maps = static_cast<int>(std::count_if(
        tables.begin(), tables.end(), [](const TableSpec& table) { return !table.uniform; }));
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    std::set<int> others;
    for (int unit = maps; unit < units; ++unit) others.insert(unit);
    effect_->setFreeTextureUnits(others);
    const Notices notices;
    const std::string reason = whyNot(new osgShadow::ShadowMap);
    EXPECT_NE(reason.find("texture units, of which others keep "), std::string::npos) << reason;
    EXPECT_EQ(notices.text().find("GL error"), std::string::npos) << notices.text();
}

TEST_F(ShadowsNotReceived, BelongToALightOfTheScene)
{
    auto* technique = new osgShadow::ParallelSplitShadowMap;
    const auto light = osgLight(3, {0.0f, 0.9f, 1.2f, 0.0f});
    light->setDirection({0.0f, -0.9f, -1.2f});
    technique->setUserLight(light);
    EXPECT_NE(
        whyNot(technique).find("no light where the shadow map of texture unit 3 is drawn from"),
        std::string::npos)
        << effect_->lastReport().whyNoShadows;
    EXPECT_EQ(effect_->lastReport().shadowMaps, 3);
    technique = new osgShadow::ParallelSplitShadowMap;
    lamps_[1]->setDirection({-0.3f, -0.5f, -1.2f});
    technique->setUserLight(lamps_[1]);
    EXPECT_EQ(whyNot(technique), "");
}

/// Pixels of the floor that a technique makes black, with a lamp that shines no light.
class ShadowsElsewhere : public FloorTest {
protected:
    size_t blackened(const Light& light)
    {
        const auto lamp = osgLight(0, {0.8f, 0.5f, 1.2f, 0.0f});
        lamp->setDiffuse({0.0f, 0.0f, 0.0f, 1.0f});
        Picture pictures[2];
        for (const bool shadowed : {false, true}) {
            techniques_.emplace_back(new osgShadow::ShadowMap);
            const osg::ref_ptr<osg::Group> root =
                shadowed ? new osgShadow::ShadowedScene(techniques_.back()) : new osg::Group;
            root->addChild(sourceOf(lamp));
            root->addChild(osgLights({light}));
            root->addChild(effect_);
            root->addChild(ballOverFloor());
            view_->setScene(root);
            for (int frame = 0; frame < 2; ++frame) view_->draw();
            pictures[shadowed] = view_->frame();
            view_->setScene(nullptr);
        }
        size_t count = 0;
        for (size_t i = 0; i < pictures[0].size(); i += 4)
            count += pictures[1][i] < 0.1f * pictures[0][i] ? 1 : 0;
        return count;
    }
};

TEST_F(ShadowsElsewhere, AreThoseOfAnyLightAtThePlaceOfTheLamp)
{
    Light light;
    light.type = Light::Type::directional;
    light.position = glm::normalize(Vec3f(0.8f, 0.5f, 1.2f));
    EXPECT_GT(blackened(light), 60u);
    light.position = glm::normalize(Vec3f(-0.8f, 0.5f, 1.2f));
    EXPECT_EQ(blackened(light), 0u);
}

}  // namespace
}  // namespace fbrdf::test
