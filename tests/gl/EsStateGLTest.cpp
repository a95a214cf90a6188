// In OpenGL ES 3.0 the picture is the same whatever state the host has, and the state is the host's
// again after. StateGLTest.cpp tests this in OpenGL.
#include "StateList.h"
#include "StateScrambler.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>

#include <gtest/gtest.h>

#include "support/DataDir.h"
#include "support/gl/Scenes.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr unsigned kSeeds = 16;

class EsState : public ::testing::Test {
protected:
    void SetUp() override
    try {
        context_ = std::make_unique<HeadlessContext>(
            HeadlessOptions{Backend::egl, HeadlessOptions::Profile::es, 3, 0});
        gl_ = loadGl(context_->loader());
        gl::RendererOptions options;
        options.load = context_->loader();
        options.log = [this](gl::Severity severity, const std::string& text) {
            if (severity != gl::Severity::note) log_.push_back(text);
        };
        renderer_ = std::make_unique<gl::Renderer>(options);
        mesh_ = renderer_->createMesh(knotMesh(48, 8));
        scrambler_ = std::make_unique<StateScrambler>(gl_, true);
    } catch (const Error& error) {
        if (dataIsMandatory()) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
    void TearDown() override
    {
        scrambler_.reset();
        mesh_.reset();
        renderer_.reset();
        if (!context_) return;
        EXPECT_EQ(gl_.GetError(), GLenum(GL_NO_ERROR));
        for (const std::string& line : log_)  // the scrambler causes errors, as a host may
            EXPECT_EQ(line.find("GL error"), std::string::npos) << line;
    }

    /// Scrambles the state, acts, compares the state, and leaves defaults.
    template <class Act>
    void expectKept(unsigned seed, Act act)
    {
        scrambler_->scramble(seed);
        const StateSnapshot before = snapshot(gl_, true);
        act();
        EXPECT_EQ(difference(before, snapshot(gl_, true)), "") << "seed " << seed;
        scrambler_->setDefaults();
    }

    /// Expects the same pixels from every state as from that of a new context.
    void expectUndisturbed(const gl::GpuMaterial& material, OffscreenFormat format,
                           const gl::DrawOptions& options)
    {
        Offscreen offscreen(context_->loader(), {kSize, kSize, format});
        const auto draw = [&] {
            const auto stats =
                renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                {{&material, mesh_.get()}}, testLights(3), options);
            EXPECT_EQ(stats.itemsFailed, 0);
        };
        scrambler_->setDefaults();
        offscreen.clear();
        draw();
        const auto expected = offscreen.readPixels();
        EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.05f);
        for (unsigned seed = 0; seed < kSeeds; ++seed) {
            offscreen.clear();
            expectKept(seed, draw);
            ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
        }
    }

    std::vector<std::string> log_;
    std::unique_ptr<HeadlessContext> context_;
    GladGLContext gl_{};
    std::unique_ptr<gl::Renderer> renderer_;
    std::shared_ptr<gl::GpuMesh> mesh_;
    std::unique_ptr<StateScrambler> scrambler_;
};

TEST_F(EsState, DrawingPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    const auto material = renderer_->createMaterial(testMaterials()[4]);
    for (const Technique technique : {Technique::single, Technique::twoLookup}) {
        expectUndisturbed(*material, OffscreenFormat::rgba8, {technique});
        if (renderer_->capabilities().floatTargets)
            expectUndisturbed(*material, OffscreenFormat::rgba32f, {technique});
    }
}

TEST_F(EsState, CubeMapsPutBackWhatTheyFindAndAreNotDisturbedByIt)
{
    std::shared_ptr<gl::GpuMaterial> material;
    for (unsigned seed = 0; seed < 4; ++seed)
        expectKept(seed, [&] {
            material = renderer_->createMaterial(testMaterials()[0], {LookUp::cube, 8});
        });
    expectUndisturbed(*material, OffscreenFormat::rgba8, {Technique::twoLookup});
}

TEST_F(EsState, MakingThingsPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    Offscreen offscreen(context_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    std::vector<float> expected;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        std::shared_ptr<gl::GpuMaterial> material;
        std::shared_ptr<gl::GpuLibrary> library;
        expectKept(seed, [&] { material = renderer_->createMaterial(everythingMaterial()); });
        expectKept(seed, [&] { mesh_ = renderer_->createMesh(sphereMesh(8)); });
        expectKept(seed, [&] { library = renderer_->createLibrary({testMaterials()[0]}); });
        expectKept(seed, [&] { renderer_->prepare(*material, {Technique::twoLookup}, 3); });
        offscreen.clear();
        renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                        {{material.get(), mesh_.get()}}, testLights(3));
        if (seed == 0) expected = offscreen.readPixels();
        ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
    }
}

TEST_F(EsState, ADrawThatIsRefusedPutsBackWhatItFinds)
{
    Offscreen flat(context_->loader(), {8, 8, OffscreenFormat::rgba8, false});
    for (unsigned seed = 0; seed < kSeeds; ++seed)
        expectKept(seed, [&] {
            EXPECT_THROW(renderer_->draw({flat.framebuffer(), 8, 8}, perspectiveView(), {}, {}),
                         Error);
        });
}

// EXT_clip_control is not in the list of states, because few contexts have it.
TEST_F(EsState, DrawingPutsBackClipControl)
{
    const auto clipControl =
        reinterpret_cast<PFNGLCLIPCONTROLPROC>(context_->loader()(nullptr, "glClipControlEXT"));
    const auto* extensions = reinterpret_cast<const char*>(gl_.GetString(GL_EXTENSIONS));
    if (!clipControl || !extensions || !std::strstr(extensions, "GL_EXT_clip_control"))
        GTEST_SKIP() << "no EXT_clip_control";
    const auto material = renderer_->createMaterial(testMaterials()[4]);
    const Offscreen offscreen(context_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    clipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                    {{material.get(), mesh_.get()}}, testLights(3));
    GLint origin = 0, depth = 0;
    gl_.GetIntegerv(GL_CLIP_ORIGIN, &origin);
    gl_.GetIntegerv(GL_CLIP_DEPTH_MODE, &depth);
    EXPECT_EQ(origin, GL_UPPER_LEFT);
    EXPECT_EQ(depth, GL_ZERO_TO_ONE);
}

// The tester itself: state that is not put back shows.
TEST_F(EsState, WhatAHostChangesIsSeen)
{
    GLuint sampler = 0;
    gl_.GenSamplers(1, &sampler);
    const std::pair<const char*, std::function<void()>> changes[] = {
        {"GL_CULL_FACE", [&] { gl_.Enable(GL_CULL_FACE); }},
        {"GL_DEPTH_RANGE", [&] { gl_.DepthRangef(0.25f, 0.5f); }},
        {"GL_COLOR_WRITEMASK", [&] { gl_.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE); }},
        {"sampler", [&] { gl_.BindSampler(2, sampler); }},
        {"blend", [&] { gl_.Enable(GL_BLEND); }},
        {"GL_UNPACK_SKIP_ROWS", [&] { gl_.PixelStorei(GL_UNPACK_SKIP_ROWS, 1); }}};
    for (const auto& [name, change] : changes) {
        scrambler_->setDefaults();
        const StateSnapshot before = snapshot(gl_, true);
        change();
        EXPECT_NE(difference(before, snapshot(gl_, true)).find(name), std::string::npos) << name;
    }
    gl_.DeleteSamplers(1, &sampler);
    scrambler_->setDefaults();
    const StateSnapshot before = snapshot(gl_, true);
    scrambler_->scramble(1);
    const std::string scrambled = difference(before, snapshot(gl_, true));
    EXPECT_GT(std::count(scrambled.begin(), scrambled.end(), '\n'), 40) << scrambled;
}

}  // namespace
}  // namespace fbrdf::test
