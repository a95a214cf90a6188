// The modes in which state is not put back: GL's defaults, or left as the call used it.
#include "StateTest.h"

#include <gtest/gtest.h>

#include "support/gl/Scenes.h"

#include <algorithm>
#include <sstream>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr unsigned kSeeds = 8;

class StateModes : public StateTest {
protected:
    gl::Renderer rendererOf(gl::StateMode mode)
    {
        gl::RendererOptions options = rendererOptions();
        options.state = mode;
        return gl::Renderer(options);
    }
    /// Makes a mesh and a material and draws them.
    void picture(gl::Renderer& renderer, Offscreen& offscreen)
    {
        const auto mesh = renderer.createMesh(knotMesh(48, 8));
        const auto material = renderer.createMaterial(testMaterials()[4], {LookUp::cube, 8});
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{material.get(), mesh.get()}}, testLights(3), {Technique::twoLookup, 8, 0});
    }
};

bool startsWithAny(const std::string& line, const std::vector<std::string>& names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return line.rfind(name, 0) == 0; });
}

/// Lines of a difference that begin with none of the names.
std::string unexpected(const std::string& difference, const std::vector<std::string>& names)
{
    std::istringstream lines(difference);
    std::string line, rest;
    while (std::getline(lines, line))
        if (!startsWithAny(line, names)) rest += line + "\n";
    return rest;
}

TEST_P(StateModes, AllDrawTheSamePicture)
{
    Offscreen offscreen = makeOffscreen(kSize);
    std::vector<float> expected;
    for (const auto mode :
         {gl::StateMode::restore, gl::StateMode::defaults, gl::StateMode::leave}) {
        gl::Renderer renderer = rendererOf(mode);
        for (unsigned seed = 0; seed < kSeeds; ++seed) {
            scrambler_->setDefaults();
            offscreen.clear();
            scrambler_->scramble(seed);
            picture(renderer, offscreen);
            scrambler_->setDefaults();
            const auto pixels = offscreen.readPixels();
            if (expected.empty()) expected = pixels;
            ASSERT_EQ(pixels, expected) << "seed " << seed;
        }
    }
}

// State that the runtime touches is GL's default after; the rest is the host's.
TEST_P(StateModes, DefaultsAreThoseOfANewContext)
{
    Offscreen offscreen = makeOffscreen(kSize);
    gl::Renderer renderer = rendererOf(gl::StateMode::defaults);
    scrambler_->setDefaults();
    const StateSnapshot initial = now();
    picture(renderer, offscreen);
    // From defaults to defaults: nothing differs but the viewport, and the buffers of attributes,
    // where the scrambler's defaults are not GL's.
    EXPECT_EQ(
        unexpected(difference(initial, now()), {"GL_VIEWPORT", "viewport 0 box", "GL_SCISSOR_BOX",
                                                "viewport 0 scissor box", "attribute "}),
        "");
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        scrambler_->scramble(seed);
        const StateSnapshot scrambled = now();
        picture(renderer, offscreen);
        StateSnapshot after = now();
        scrambler_->setDefaults();
        for (const auto& [name, value] : after) {
            // The last is of the active unit, which changes.
            if (startsWithAny(name, {"GL_VIEWPORT", "viewport 0 box", "GL_SCISSOR_BOX",
                                     "viewport 0 scissor box", "GL_TEXTURE_2D"}))
                continue;
            const bool isNone = name.rfind("attribute ", 0) == 0 && value.at(0) == 0.0;
            EXPECT_TRUE(value == scrambled.at(name) || value == initial.at(name) || isNone)
                << name << ", seed " << seed;
        }
    }
}

// Renderer.h, "State": the names that a draw and the making of things may leave behind.
const std::vector<std::string>& published()
{
    static const std::vector<std::string> names = {
        "GL_CULL_FACE", "GL_DEPTH", "GL_STENCIL_TEST", "GL_SCISSOR", "GL_COLOR_LOGIC_OP",
        "GL_DITHER", "GL_POLYGON", "GL_SAMPLE", "GL_CLIP", "GL_RASTERIZER_DISCARD",
        "GL_FRAMEBUFFER_SRGB", "GL_PRIMITIVE_RESTART", "GL_TEXTURE_CUBE_MAP_SEAMLESS",
        "GL_ALPHA_TEST", "GL_BLEND", "GL_COLOR_WRITEMASK", "GL_ACTIVE_TEXTURE",
        "GL_CURRENT_PROGRAM", "GL_VERTEX_ARRAY_BINDING", "GL_ARRAY_BUFFER",
        "GL_ELEMENT_ARRAY_BUFFER", "GL_DRAW_FRAMEBUFFER", "GL_DRAW_BUFFER0", "GL_RENDERBUFFER",
        "GL_PIXEL_UNPACK_BUFFER", "GL_VIEWPORT", "GL_UNPACK", "GL_READ_", "GL_PIXEL_PACK_BUFFER",
        "GL_PACK_", "GL_CONSERVATIVE", "GL_RED_", "GL_GREEN_", "GL_BLUE_", "GL_MAP_COLOR",
        "GL_CLAMP_FRAGMENT_COLOR", "unit ", "blend", "buffer ", "viewport 0", "attribute ",
        // These belong to the active unit, which changes:
        "GL_TEXTURE_2D"};
    return names;
}

TEST_P(StateModes, LeftIsNothingButThePublishedList)
{
    Offscreen offscreen = makeOffscreen(kSize);
    gl::Renderer renderer = rendererOf(gl::StateMode::leave);
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        scrambler_->scramble(seed);
        const StateSnapshot before = now();
        picture(renderer, offscreen);
        const StateSnapshot after = now();
        scrambler_->setDefaults();
        EXPECT_EQ(unexpected(difference(before, after), published()), "") << "seed " << seed;
        EXPECT_FALSE(difference(before, after).empty());  // the tester: something is left
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, StateModes, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
