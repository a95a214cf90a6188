// The peer under an environment of 1 everywhere shows its directional albedo.
#include "bench/GgxEnvironment.h"

#include "bench/Materials.h"

#include <fbrdf/environment/Panorama.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"

namespace fbrdf::test {
namespace {

using namespace bench;

constexpr int kSize = 16;

class GgxEnvironmentGL : public RendererTest {};

TEST_P(GgxEnvironmentGL, ShowsItsAlbedoWhereAllIsWhite)
{
    // 32 x 32 texels between which the table is interpolated.
    constexpr double kTable = 5e-3;
    const Panorama white{8, 4, std::vector<Vec3f>(32, Vec3f(1.0f))};
    const Stage stage = makeStage("triangle", 1.0);
    const GgxEnvironment peer(gl(), stage, renderer_->createEnvironment(white, {16, true}));
    Offscreen offscreen = makeOffscreen(kSize);
    peer.draw({offscreen.framebuffer(), kSize, kSize});
    const auto pixels = offscreen.readPixels();
    const auto geometry = geometryBuffer(gl(), offscreen, stage.mesh, glm::mat4(1.0f), stage.view);
    for (size_t pixel = 0; pixel < kSize * kSize; pixel += 7) {
        const auto at = [&](const std::vector<float>& image) {
            return Vec3d(image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]);
        };
        const double cosine =
            glm::dot(glm::normalize(at(geometry.normal)), glm::normalize(-at(geometry.position)));
        const Vec2<double> albedo = GgxEnvironment::albedo(cosine);
        const Vec3d expected = kF0 * albedo.x + albedo.y + kDiffuse;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(at(pixels)[c], expected[c], kTable) << cosine;
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, GgxEnvironmentGL, testing::ValuesIn(modernVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
