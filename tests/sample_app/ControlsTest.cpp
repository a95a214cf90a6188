// ControlsTest.cpp - what keys, mouse and command line mean; no window, no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Controls.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

ViewState seenState()
{
    ViewState state;
    state.document.camera = state.home;
    return state;
}

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
    ViewState state = seenState();
    state.document.materials.resize(3);
    state.document.shown = 0;
    state.meshes = {"sphere", "knot"};
    for (const int expected : {1, 2, 0, 1}) {
        EXPECT_TRUE(applyKey(state, 'm'));
        EXPECT_EQ(state.document.shown, expected);
    }
    EXPECT_TRUE(applyKey(state, 'o'));
    EXPECT_EQ(state.document.mesh, "knot");
    applyKey(state, 'o');
    EXPECT_EQ(state.document.mesh, "sphere");
    state.document.mesh = "gone.obj";
    applyKey(state, 'o');
    EXPECT_EQ(state.document.mesh, "sphere") << "the first after what is in no list";
    for (int i = 0; i < kViewTechniqueCount; ++i) applyKey(state, 't');
    EXPECT_EQ(state.document.technique, viewTechnique(Technique::single));
    applyKey(state, 't');
    EXPECT_EQ(state.document.technique, viewTechnique(Technique::batched));
}

TEST(Keys, DoubleAndHalveLightsWithinLimits)
{
    ViewState state = seenState();
    int& made = state.document.lights.made;
    made = 3;
    for (const int expected : {6, 12}) {
        applyKey(state, 'l');
        EXPECT_EQ(made, expected);
    }
    for (int i = 0; i < 20; ++i) applyKey(state, 'l');
    EXPECT_EQ(made, 4096);
    for (int i = 0; i < 20; ++i) applyKey(state, 'k');
    EXPECT_EQ(made, 1);
    made = 0;
    applyKey(state, 'l');
    EXPECT_EQ(made, 1) << "a list gives way to one that is made";
}

TEST(Keys, TurnTheTableAndTheEnvironment)
{
    ViewState state = seenState();
    state.environments = {"", "studio", "sky.exr"};
    for (const char* expected : {"studio", "sky.exr", "", "studio"}) {
        EXPECT_TRUE(applyKey(state, 'e'));
        EXPECT_EQ(state.document.environment.name, expected);
    }
    EXPECT_TRUE(applyKey(state, ' ') && state.document.turning);
    EXPECT_TRUE(applyKey(state, ' ') && !state.document.turning);
    EXPECT_TRUE(applyKey(state, '.') && state.document.environment.degrees == 15.0f);
    for (int i = 0; i < 13; ++i) applyKey(state, ',');
    EXPECT_EQ(state.document.environment.degrees, -180.0f);
    applyKey(state, ',');
    EXPECT_EQ(state.document.environment.degrees, 165.0f);
}

TEST(Keys, SixStepsOfExposureAreAStop)
{
    ViewState state = seenState();
    for (int i = 0; i < 6; ++i) applyKey(state, '+');
    EXPECT_NEAR(state.document.exposure, 2.0f, 1e-5f);
    for (int i = 0; i < 12; ++i) applyKey(state, '-');
    EXPECT_NEAR(state.document.exposure, 0.5f, 1e-5f);
}

TEST(Keys, RestAndUnknownOnes)
{
    ViewState state = seenState();
    applyDrag(state, 100.0, 50.0, 400);
    EXPECT_NE(state.document.camera->eye, state.home.eye);
    EXPECT_TRUE(applyKey(state, 'r'));
    EXPECT_EQ(state.document.camera->eye, state.home.eye);
    EXPECT_TRUE(applyKey(state, 's') && state.screenshot);
    EXPECT_TRUE(applyKey(state, 'c') && state.cancel);
    EXPECT_TRUE(applyKey(state, 'f') && state.frame);
    EXPECT_TRUE(applyKey(state, 'h') && state.help);
    EXPECT_TRUE(applyKey(state, 'h') && !state.help);
    EXPECT_FALSE(applyKey(state, '$') || applyKey(state, 0));
    EXPECT_FALSE(state.close);
    EXPECT_TRUE(applyKey(state, 27) && state.close);
}

TEST(Keys, WithControlAreWishes)
{
    ViewState state = seenState();
    EXPECT_TRUE(applyControlKey(state, 'z', false) && state.undo && !state.redo);
    EXPECT_TRUE(applyControlKey(state, 'z', true) && state.redo);
    EXPECT_TRUE(applyControlKey(state, 's', false) && state.save);
    EXPECT_TRUE(applyControlKey(state, 'e', false) && state.screenshotExr);
    EXPECT_FALSE(state.screenshot);
    state.redo = false;
    EXPECT_TRUE(applyControlKey(state, 'y', false) && state.redo);
    EXPECT_FALSE(applyControlKey(state, 'x', false));
    EXPECT_TRUE(state.document == seenState().document);
}

TEST(Keys, ReachComparisonsAndThePlaceThatIsExplained)
{
    ViewState state = seenState();
    EXPECT_TRUE(applyKey(state, 'v') && state.compare.on);
    EXPECT_TRUE(applyKey(state, kLeftKey));
    EXPECT_LT(state.document.camera->eye.x, 0.0) << "no place is explained yet: the view turns";
    EXPECT_EQ(state.cursor.x, 0.5);
    EXPECT_TRUE(applyKey(state, 'i') && state.cursor.on && state.cursor.followsMouse);
    EXPECT_TRUE(applyKey(state, kRightKey) && applyKey(state, kDownKey));
    EXPECT_FALSE(state.cursor.followsMouse);
    EXPECT_GT(state.cursor.x, 0.5);
    EXPECT_GT(state.cursor.y, 0.5);
    for (int i = 0; i < 500; ++i) {
        applyKey(state, kLeftKey);
        applyKey(state, kUpKey);
    }
    EXPECT_EQ(state.cursor.x, 0.0);
    EXPECT_EQ(state.cursor.y, 0.0);
}

TEST(Keys, ChooseAMaterialWhileTheyAreAskedTo)
{
    ViewState state = seenState();
    state.browser.count = 3;
    applyKey(state, kRightKey);
    EXPECT_EQ(state.browser.chosen, 0) << "arrows turn the view";
    EXPECT_TRUE(applyKey(state, 'y') && state.browser.on && state.browser.focused);
    for (const int expected : {1, 2, 2}) {
        EXPECT_TRUE(applyKey(state, kRightKey));
        EXPECT_EQ(state.browser.chosen, expected);
    }
    for (int i = 0; i < 5; ++i) applyKey(state, kLeftKey);
    EXPECT_EQ(state.browser.chosen, 0);
    EXPECT_TRUE(applyKey(state, kEnterKey) && state.browser.open);
    applyKey(state, 'y');
    state.browser.open = false;
    EXPECT_FALSE(applyKey(state, kEnterKey) || state.browser.open);
}

TEST(Keys, AllOfTheHelpExist)
{
    for (const KeyHelp& line : keyHelp()) {
        const std::string keys = line.key;
        if (keys.size() != 1) continue;
        ViewState state = seenState();
        EXPECT_TRUE(applyKey(state, static_cast<char>(std::tolower(keys[0])))) << keys;
    }
}

TEST(Mouse, TheObjectFollowsADrag)
{
    ViewState state = seenState();  // at (0, 0, 4)
    applyDrag(state, 100.0, 0.0, 400);
    EXPECT_LT(state.document.camera->eye.x, 0.0) << "dragged right, so seen from the left";
    EXPECT_NEAR(std::atan2(state.document.camera->eye.x, state.document.camera->eye.z), -0.25 * kPi,
                1e-12);
    state.document.camera = state.home;
    applyDrag(state, 0.0, 100.0, 400);
    EXPECT_GT(state.document.camera->eye.y, 0.0) << "dragged down, so seen from above";
    state.document.camera = state.home;
    applyScroll(state, 3.0);
    EXPECT_LT(glm::length(state.document.camera->eye), 4.0);
    applyScroll(state, -3.0);
    EXPECT_NEAR(glm::length(state.document.camera->eye), 4.0, 1e-12);
}

}  // namespace
}  // namespace fbrdf::scene
