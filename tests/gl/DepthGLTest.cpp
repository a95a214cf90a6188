// Every pass reaches exactly the fragments that the first one left visible: the samples that pass
// the depth test are counted for each draw call, through the injected loader.
#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>

namespace fbrdf::test {
namespace {

constexpr int kSize = 64;

class DepthMatch : public GlTest {
protected:
    static size_t covered(const std::vector<float>& image)
    {
        size_t count = 0;
        for (size_t i = 3; i < image.size(); i += 4) count += image[i] == 1.0f ? 1 : 0;
        return count;
    }

    static gl::View randomView(std::mt19937& random)
    {
        std::uniform_real_distribution<float> value(-1.0f, 1.0f);
        gl::View view = perspectiveView();
        view.view = glm::translate(
            glm::mat4(1.0f), {0.3f * value(random), 0.3f * value(random), -4.0f + value(random)});
        view.view = glm::rotate(view.view, 3.0f * value(random),
                                glm::normalize(Vec3f(value(random), value(random), 1.1f)));
        view.projection = glm::perspective(0.8f + 0.2f * value(random), 1.0f, 0.31f, 77.0f);
        return view;
    }
};

TEST_P(DepthMatch, EveryPassCoversWhatIsVisible)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto mesh = renderer.createMesh(knotMesh(96, 12));
    std::mt19937 random(3);
    for (const OffscreenFormat format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8})
        for (const Material& material : testMaterials()) {
            const auto gpu = renderer.createMaterial(material);
            const gl::View view = randomView(random);
            Offscreen offscreen = makeOffscreen(kSize, format);
            hooks.samples.clear();
            hooks.countSamples = true;
            const auto stats =
                renderer.draw({offscreen.framebuffer(), kSize, kSize}, view,
                              {{gpu.get(), mesh.get()}}, testLights(3), {Technique::twoLookup});
            hooks.countSamples = false;
            const size_t visible = covered(offscreen.readPixels());
            ASSERT_GT(visible, 300u);
            ASSERT_EQ(hooks.samples.size(), static_cast<size_t>(stats.drawCalls));
            // The first pass of each surface also draws fragments that nearer ones replace later;
            // all other passes must match exactly.
            int laying = 0;
            for (const GLuint samples : hooks.samples) {
                laying += samples > visible ? 1 : 0;
                EXPECT_GE(samples, visible) << material.name;
            }
            EXPECT_LE(laying, 2) << material.name;
        }
}

INSTANTIATE_TEST_SUITE_P(Backends, DepthMatch, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
