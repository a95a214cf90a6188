// ControlsTest.cpp - what keys, mouse and command line mean; no window, no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Controls.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

TEST(Techniques, HaveNamesThatReadBack)
{
    for (int i = 0; i < kViewTechniqueCount; ++i) {
        const auto technique = static_cast<ViewTechnique>(i);
        EXPECT_EQ(viewTechniqueFromName(viewTechniqueName(technique)), technique);
        if (!isOnCpu(technique)) {
            EXPECT_STREQ(techniqueName(runtimeTechnique(technique)), viewTechniqueName(technique));
        }
    }
    for (const char* name : {"", "Single", "two lookup", "nope"}) try {
            viewTechniqueFromName(name);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
        }
}

TEST(Keys, CycleThroughMaterialsMeshesAndTechniques)
{
    ViewState state;
    state.materialCount = 3;
    state.meshCount = 2;
    for (const int expected : {1, 2, 0, 1}) {
        EXPECT_TRUE(applyKey(state, 'm'));
        EXPECT_EQ(state.material, expected);
    }
    EXPECT_TRUE(applyKey(state, 'o') && applyKey(state, 'o'));
    EXPECT_EQ(state.mesh, 0);
    for (int i = 0; i < kViewTechniqueCount; ++i) applyKey(state, 't');
    EXPECT_EQ(state.technique, viewTechnique(Technique::single));
    applyKey(state, 't');
    EXPECT_EQ(state.technique, viewTechnique(Technique::batched));
}

TEST(Keys, DoubleAndHalveLightsWithinLimits)
{
    ViewState state;
    for (int i = 0; i < 20; ++i) applyKey(state, 'l');
    EXPECT_EQ(state.lightCount, kMostLights);
    for (int i = 0; i < 20; ++i) applyKey(state, 'k');
    EXPECT_EQ(state.lightCount, 1);
    state.madeLights = false;
    applyKey(state, 'l');
    EXPECT_EQ(state.lightCount, 1) << "lights of a file stay";
}

TEST(Keys, TurnTheTableAndTheEnvironment)
{
    ViewState state;
    state.environmentCount = 4;
    for (const int expected : {1, 2, 3, 0}) {
        EXPECT_TRUE(applyKey(state, 'e'));
        EXPECT_EQ(state.environment, expected);
    }
    EXPECT_TRUE(applyKey(state, ' ') && state.turning);
    EXPECT_TRUE(applyKey(state, ' ') && !state.turning);
    EXPECT_TRUE(applyKey(state, '.') && state.environmentDegrees == 15.0f);
    for (int i = 0; i < 13; ++i) applyKey(state, ',');
    EXPECT_EQ(state.environmentDegrees, -180.0f);
    applyKey(state, ',');
    EXPECT_EQ(state.environmentDegrees, 165.0f);
}

TEST(Keys, SixStepsOfExposureAreAStop)
{
    ViewState state;
    for (int i = 0; i < 6; ++i) applyKey(state, '+');
    EXPECT_NEAR(state.exposure, 2.0f, 1e-5f);
    for (int i = 0; i < 12; ++i) applyKey(state, '-');
    EXPECT_NEAR(state.exposure, 0.5f, 1e-5f);
}

TEST(Keys, RestAndUnknownOnes)
{
    ViewState state;
    applyDrag(state, 100.0, 50.0, 400);
    EXPECT_NE(state.camera.eye, state.home.eye);
    EXPECT_TRUE(applyKey(state, 'r'));
    EXPECT_EQ(state.camera.eye, state.home.eye);
    EXPECT_TRUE(applyKey(state, 's') && state.screenshot);
    EXPECT_TRUE(applyKey(state, 'c') && state.cancel);
    EXPECT_TRUE(applyKey(state, 'f') && state.frame);
    EXPECT_TRUE(applyKey(state, 'h') && state.help);
    EXPECT_TRUE(applyKey(state, 'h') && !state.help);
    EXPECT_FALSE(applyKey(state, 'x') || applyKey(state, 0));
    EXPECT_FALSE(state.close);
    EXPECT_TRUE(applyKey(state, 27) && state.close);
}

TEST(Keys, AllOfTheHelpExist)
{
    for (const KeyHelp& line : keyHelp()) {
        const std::string keys = line.key;
        if (keys.size() != 1) continue;
        ViewState state;
        EXPECT_TRUE(applyKey(state, static_cast<char>(std::tolower(keys[0])))) << keys;
    }
}

TEST(Mouse, TheObjectFollowsADrag)
{
    ViewState state;  // at (0, 0, 4)
    applyDrag(state, 100.0, 0.0, 400);
    EXPECT_LT(state.camera.eye.x, 0.0) << "dragged right, so seen from the left";
    EXPECT_NEAR(std::atan2(state.camera.eye.x, state.camera.eye.z), -0.25 * kPi, 1e-12);
    state.camera = state.home;
    applyDrag(state, 0.0, 100.0, 400);
    EXPECT_GT(state.camera.eye.y, 0.0) << "dragged down, so seen from above";
    state.camera = state.home;
    applyScroll(state, 3.0);
    EXPECT_LT(glm::length(state.camera.eye), 4.0);
    applyScroll(state, -3.0);
    EXPECT_NEAR(glm::length(state.camera.eye), 4.0, 1e-12);
}

}  // namespace
}  // namespace fbrdf::scene
