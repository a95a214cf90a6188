// What a material keeps from frame to frame: plans and the state sets of their passes. No GL.
#include "MaterialStates.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

using osgFbrdf::MaterialStates;
using osgFbrdf::PassInputs;

PlanRequest requestFor(int lights)
{
    PlanRequest request;
    request.technique = Technique::twoLookup;
    request.lights = lights;
    return request;
}

TEST(MaterialStates, GivesTheSamePassesForTheSameRequest)
{
    const osg::ref_ptr<MaterialStates> states = new MaterialStates(testMaterials()[0]);
    const auto first = states->passes(requestFor(3), {});
    ASSERT_TRUE(first->plan.feasible()) << first->plan.reason;
    EXPECT_EQ(first->states.size(), first->plan.passes.size());
    EXPECT_EQ(states->passes(requestFor(3), {}), first);
}

// Each of these changes the plan or a program: a key that left one out would draw the wrong passes.
TEST(MaterialStates, GivesOtherPassesForAnyOtherRequest)
{
    const osg::ref_ptr<MaterialStates> states = new MaterialStates(testMaterials()[0]);
    const PlanRequest usual = requestFor(3);
    const LobeTable lobes = testLobes(LobeAxes::tilted, 2);
    std::vector<PlanRequest> requests(8, usual);
    requests[0].technique = Technique::batched;
    requests[1].lights = 4;
    requests[2].lightsPerPass = 2;
    requests[3].maxLookups = 5;
    requests[4].target = ColourFormat::rgba8;
    requests[5].offscreen = false;
    requests[6].transfer = Transfer::srgb;
    requests[7].lobes = layoutOf(lobes);
    requests[7].lobeLight.environment = true;
    const auto first = states->passes(usual, {});
    for (size_t i = 0; i < requests.size(); ++i)
        EXPECT_NE(states->passes(requests[i], {}, &lobes), first) << "request " << i;
    std::vector<PassInputs> inputs(4);
    inputs[0].units = osgFbrdf::TextureUnits(2, {});
    inputs[1].derivedTangents = true;
    inputs[2].hooks.attenuated = true;
    inputs[3].units = osgFbrdf::TextureUnits(0, {0});
    for (size_t i = 0; i < inputs.size(); ++i) {
        const auto other = states->passes(usual, inputs[i]);
        ASSERT_EQ(other->states.size(), first->states.size());
        EXPECT_NE(other->states.front(), first->states.front()) << "inputs " << i;
    }
}

std::vector<std::string> programsOf(const osgFbrdf::PlannedPasses& passes)
{
    std::vector<std::string> texts;
    for (const auto& state : passes.states) {
        const auto* program =
            static_cast<const osg::Program*>(state->getAttribute(osg::StateAttribute::PROGRAM));
        texts.push_back(program->getShader(1)->getShaderSource());
    }
    return texts;
}

// An effect that no environment lights has the programs and the state that it always had.
TEST(MaterialStates, GivesNothingOfAnEnvironmentWithoutOne)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const osg::ref_ptr<MaterialStates> states = new MaterialStates(material),
                                       plain = new MaterialStates(testMaterials()[0]);
    const auto expected = plain->passes(requestFor(3), {});
    const auto before = states->passes(requestFor(3), {});
    EXPECT_EQ(programsOf(*before), programsOf(*expected));
    EXPECT_EQ(before->needed.textureUnits, 0);
    PlanRequest request = requestFor(3);
    request.lobes = layoutOf(material.lobes);
    request.lobeLight.environment = true;
    const auto lit = states->passes(request, {}, &material.lobes);
    ASSERT_TRUE(lit->plan.feasible()) << lit->plan.reason;
    EXPECT_NE(programsOf(*lit), programsOf(*expected));
    EXPECT_EQ(lit->needed.textureUnits, states->textureUnits() + 1);
    EXPECT_TRUE(lit->needed.choosesLevels);
    EXPECT_EQ(states->passes(requestFor(3), {}), before);
    size_t counts[2] = {};
    for (const auto& state : lit->states) counts[state->getUniform("fbrdfLobes") ? 1 : 0]++;
    EXPECT_GT(counts[0], 0u);  // passes that add lights
    EXPECT_EQ(counts[1], 2u);  // three look-ups, two in a pass
    for (const auto& state : before->states) EXPECT_FALSE(state->getUniform("fbrdfLobes"));
}

TEST(TextureUnits, AreThoseThatOthersLeave)
{
    const osgFbrdf::TextureUnits units(1, {0, 2, 3, 11});
    for (const auto& [texture, unit] :
         std::vector<std::pair<int, int>>{{0, 1}, {1, 4}, {7, 10}, {8, 12}})
        EXPECT_EQ(units[texture], unit) << texture;
    EXPECT_EQ(units.needed(0), 1);
    EXPECT_EQ(units.needed(9), 13);
    EXPECT_EQ(osgFbrdf::TextureUnits(3, {})[5], 8);
}

// Lights come into reach and go: the plans of long ago are dropped, and made again when asked for.
TEST(MaterialStates, ForgetsPlansThatAreNotAskedForAgain)
{
    const osg::ref_ptr<MaterialStates> states = new MaterialStates(testMaterials()[0]);
    const std::weak_ptr<const osgFbrdf::PlannedPasses> first = states->passes(requestFor(1), {});
    EXPECT_FALSE(first.expired());
    for (int lights = 2; lights < 100; ++lights) states->passes(requestFor(lights), {});
    EXPECT_TRUE(first.expired());
    EXPECT_TRUE(states->passes(requestFor(1), {})->plan.feasible());
}

}  // namespace
}  // namespace fbrdf::test
