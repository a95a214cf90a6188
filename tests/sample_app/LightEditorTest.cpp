// LightEditorTest.cpp - what mouse and keys do to the lights of a document, without a window.
#include "viewer/LightEditor.h"

#include <gtest/gtest.h>

namespace fbrdf::viewer {
namespace {

class LightsOfAWindow : public testing::Test {
protected:
    LightsOfAWindow()
    {
        world_.mesh = scene::makeSphere(16, 8);
        state_.document.camera = scene::Camera();
        follow();
    }
    /// As the window does: the world follows the document, and its handles are found.
    void follow()
    {
        const scene::Bounds objects = scene::boundsOf(world_.mesh);
        world_.lights = orbited(lightsOf(state_.document.lights, objects), Vec3d(objects.centre),
                                state_.document.moment.lightsDegrees * kDegree);
        editor_.see(viewFromCamera(*state_.document.camera, 1.5, objects), kWidth, 400);
    }
    void wish()
    {
        editor_.follow();
        follow();
    }
    glm::dvec2 handleOf(int light)
    {
        for (const scene::LightHandle& handle : editor_.handles())
            if (handle.light == light) return handle.at;
        ADD_FAILURE() << "no handle of light " << light;
        return {};
    }

    static constexpr int kWidth = 600;
    World world_;
    scene::ViewState state_;
    LightEditor editor_{state_, world_};
};

TEST_F(LightsOfAWindow, ADraggedLightStaysUnderTheMouse)
{
    for (int kind = 0; kind < scene::kLightKinds; ++kind) {
        if (static_cast<scene::LightKind>(kind) == scene::LightKind::directional) continue;
        state_.document.lights = {};
        state_.lightWishes.add = kind;
        wish();
        EXPECT_EQ(state_.light, 0) << "what is added is selected";
        const glm::dvec2 grip(3.0, -2.0);
        ASSERT_TRUE(editor_.press(handleOf(0) + grip));
        for (const glm::dvec2& pixel : {glm::dvec2(200.0, 120.0), glm::dvec2(420.0, 250.0)}) {
            editor_.drag(pixel);
            follow();
            EXPECT_LT(glm::length(handleOf(0) + grip - pixel), 0.01);
        }
    }
}

// The document has the lights before they orbit; the mouse has hold of those that are drawn.
TEST_F(LightsOfAWindow, ALightIsDraggedWhileLightsOrbit)
{
    state_.lightWishes.add = 0;
    wish();
    state_.document.moment.lightsDegrees = 25.0;
    follow();
    ASSERT_TRUE(editor_.press(handleOf(0)));
    editor_.drag({250.0, 150.0});
    follow();
    EXPECT_LT(glm::length(handleOf(0) - glm::dvec2(250.0, 150.0)), 0.01);
}

TEST_F(LightsOfAWindow, LightsThatWereMadeBecomeAListWhenOneIsMoved)
{
    state_.document.lights.made = 5;
    follow();
    const scene::LightSet before = world_.lights;
    ASSERT_TRUE(editor_.press(handleOf(2)));
    EXPECT_EQ(state_.light, 2);
    EXPECT_EQ(state_.document.lights.made, 5) << "a click changes nothing";
    editor_.drag(handleOf(2) + glm::dvec2(30.0, 0.0));
    follow();
    EXPECT_EQ(state_.document.lights.made, 0);
    ASSERT_EQ(world_.lights.size(), 5u);
    for (size_t i = 0; i < 5; ++i)
        EXPECT_EQ(world_.lights.lights[i].position == before.lights[i].position, i != 2) << i;
}

TEST_F(LightsOfAWindow, KeysGoThroughMoveAndRemoveThem)
{
    state_.document.lights.made = 3;
    follow();
    for (const int expected : {0, 1, 2, 0}) {
        applyKey(state_, 'n');
        wish();
        EXPECT_EQ(state_.light, expected);
    }
    const glm::dvec2 before = handleOf(0);
    applyKey(state_, scene::kRightKey);
    applyKey(state_, scene::kUpKey);
    wish();
    EXPECT_GT(handleOf(0).x, before.x);
    EXPECT_LT(handleOf(0).y, before.y);
    applyKey(state_, scene::kDeleteKey);
    wish();
    EXPECT_EQ(world_.lights.size(), 2u);
    EXPECT_EQ(state_.light, -1);
    applyKey(state_, scene::kDeleteKey);
    wish();
    EXPECT_EQ(world_.lights.size(), 2u) << "none is selected";
    const scene::Camera camera = *state_.document.camera;
    applyKey(state_, scene::kLeftKey);
    EXPECT_NE(state_.document.camera->eye, camera.eye) << "without one the view turns";
}

TEST_F(LightsOfAWindow, PageKeysMoveAlongTheView)
{
    applyKey(state_, 'a');
    wish();
    const double before = glm::length(Vec3d(world_.lights.lights[0].position));
    const double z = double(world_.lights.lights[0].position.z);
    applyKey(state_, scene::kPageUpKey);
    wish();
    EXPECT_NEAR(double(world_.lights.lights[0].position.z), z - 0.1, 1e-5) << before;
}

TEST_F(LightsOfAWindow, NothingIsTakenBesideAHandleOrWhereLightsAreNotShown)
{
    applyKey(state_, 'a');
    wish();
    EXPECT_FALSE(editor_.press(handleOf(0) + glm::dvec2(40.0, 0.0)));
    const glm::dvec2 at = handleOf(0);
    applyKey(state_, 'w');
    follow();
    EXPECT_FALSE(editor_.press(at));
    state_.showsLights = true;
    state_.document.lights.made = 4096;
    follow();
    EXPECT_TRUE(editor_.handles().empty()) << "more than one can tell apart";
}

TEST_F(LightsOfAWindow, ASelectionThatIsGoneIsNone)
{
    state_.document.lights.made = 3;
    state_.light = 2;
    follow();
    state_.document.lights.made = 1;
    follow();
    state_.lightWishes.remove = true;
    state_.lightWishes.push = Vec3d(1.0);
    wish();
    editor_.drag({10.0, 10.0});
    EXPECT_EQ(state_.document.lights.made, 1);
}

// A file is dropped, and a key is pressed before the next frame: the world still has the lights of
// before.
TEST_F(LightsOfAWindow, KeysBeforeTheWorldHasFollowedDoNothingToLightsThatAreGone)
{
    for (int i = 0; i < 3; ++i) {
        state_.lightWishes.add = 0;
        wish();
    }
    state_.light = 2;
    const scene::SceneLights one{0, 1, {{state_.document.lights.list.lights[0]}, {}}};
    for (const bool removes : {true, false}) {
        state_.document.lights = one;
        state_.light = 2;
        state_.lightWishes.remove = removes;
        if (!removes) state_.lightWishes.push = Vec3d(1.0, 0.0, 0.0);
        editor_.follow();
        editor_.drag({100.0, 100.0});
        EXPECT_EQ(state_.document.lights.list.size(), 1u);
    }
    follow();
    state_.light = 0;
    state_.lightWishes.remove = true;
    wish();
    EXPECT_EQ(world_.lights.size(), 0u);
}

}  // namespace
}  // namespace fbrdf::viewer
