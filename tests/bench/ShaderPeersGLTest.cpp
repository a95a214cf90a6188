// Compares the drawing of each peer with its CPU twin, and the twins with the models that they
// implement.
#include "bench/ShaderPeers.h"

#include "bench/Network.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/sources/OpenSource.h>

#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"
#include "support/TemporaryDir.h"

#include <fstream>

namespace fbrdf::test {
namespace {

using namespace bench;

constexpr int kSize = 24, kLights = 5;

// The rounding of some dozens of float operations against double.
constexpr double kRounding = 5e-5;
// sin theta_h comes from 1 - cos^2, which has few digits left near 0, and directions turn about h
// with it. Measured on llvmpipe: 5.7e-5.
constexpr double kCancellation = 2e-4;
// atan, acos and asin of llvmpipe are polynomials good to 1e-4 rad, and a MERL cell is 0.009 rad.
constexpr double kInverseTrigonometry = 5e-3;

double toleranceOf(const std::string& peer)
{
    if (peer == "merl" || peer == "poulin-fournier") return kInverseTrigonometry;
    return peer.rfind("nbrdf", 0) == 0 ? kCancellation : kRounding;
}

Vec3d pixelOf(const std::vector<float>& image, size_t pixel)
{
    return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

/// Radiance at a point in eye space, in double.
Vec3d radiance(const ShaderPeer& peer, const std::vector<Light>& lights, const glm::dmat4& view,
               const Vec3d& point, const ShadingFrame<double>& frame)
{
    const Vec3d wo = frame.local(glm::normalize(-point));
    Vec3d sum(0.0);
    for (const Light& light : lights) {
        const Vec3d toLight = Vec3d(view * glm::dvec4(Vec3d(light.position), 1.0)) - point;
        const Vec3d wi = frame.local(glm::normalize(toLight));
        if (wi.z > 0.0 && wo.z > 0.0)
            sum +=
                peer.evaluate(wo, wi) * Vec3d(light.intensity) * wi.z / glm::dot(toLight, toLight);
    }
    return sum;
}

class PeerImage : public GlTest {
protected:
    std::vector<float> drawn(const ShaderPeer& peer, const Stage& stage, Offscreen& offscreen)
    {
        const auto lights = stageLights(kLights);
        const PeerDrawing drawing(gl(), peer, stage, kLights);
        offscreen.clear();
        drawing.draw({offscreen.framebuffer(), kSize, kSize}, lights);
        return offscreen.readPixels();
    }

    std::vector<double> expected(const ShaderPeer& peer, const Stage& stage,
                                 const GeometryBuffer& geometry)
    {
        const auto lights = stageLights(kLights);
        std::vector<double> image(geometry.position.size(), 0.0);
        for (size_t pixel = 0; pixel < image.size() / 4; ++pixel) {
            if (!geometry.covers(pixel)) continue;
            const auto frame =
                shadingFrame(pixelOf(geometry.normal, pixel), pixelOf(geometry.tangent, pixel));
            const Vec3d sum = radiance(peer, lights, glm::dmat4(stage.view.view),
                                       pixelOf(geometry.position, pixel), frame);
            for (int c = 0; c < 3; ++c) image[4 * pixel + static_cast<size_t>(c)] = sum[c];
            image[4 * pixel + 3] = 1.0;
        }
        return image;
    }
};

TEST_P(PeerImage, AgreesWithItsCpuTwin)
{
    Offscreen offscreen = makeOffscreen(kSize);
    for (const char* mesh : {"triangle", "sphere"}) {
        const Stage stage = makeStage(mesh, 1.0);
        const auto geometry =
            geometryBuffer(gl(), offscreen, stage.mesh, glm::mat4(1.0f), stage.view);
        for (const ShaderPeer& peer : shaderPeers()) {
            SCOPED_TRACE(peer.name + " on a " + mesh);
            const auto d =
                compareImages(drawn(peer, stage, offscreen), expected(peer, stage, geometry));
            EXPECT_TRUE(d.comparable);
            EXPECT_LT(d.maxRelative, toleranceOf(peer.name)) << describe(d);
        }
    }
}

// The tester: another roughness must not pass for the peer's.
TEST_P(PeerImage, OfAnotherRoughnessIsNoticed)
{
    Offscreen offscreen = makeOffscreen(kSize);
    const Stage stage = makeStage("triangle", 1.0);
    const auto geometry = geometryBuffer(gl(), offscreen, stage.mesh, glm::mat4(1.0f), stage.view);
    ShaderPeer peer = ggxPeer();
    peer.parameters[0].x *= 1.01f;
    const auto d = compareImages(drawn(peer, stage, offscreen), expected(peer, stage, geometry));
    EXPECT_GT(d.maxRelative, 10.0 * kRounding) << describe(d);
}

INSTANTIATE_TEST_SUITE_P(Backends, PeerImage, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

std::vector<DirectionPair<double>> somePairs()
{
    std::vector<DirectionPair<double>> pairs;
    for (const double theta_h : {0.05, 0.3, 0.8})
        for (const double theta_d : {0.1, 0.5, 0.9})
            for (const double phi_d : {-2.0, 0.4, 1.5}) {
                const auto pair = pairFromHalfDifference({theta_h, 0.3, theta_d, phi_d});
                if (pair.wo.z > 0.1 && pair.wi.z > 0.1) pairs.push_back(pair);
            }
    return pairs;
}

TEST(PeerTwin, OfTheNetworkIsTheReaderOfPublishedWeights)
{
    const TemporaryDir directory;
    const auto weights = networkWeights();
    ASSERT_EQ(weights.size(), static_cast<size_t>(kNetworkWeights));
    const std::string path = directory.file("net.f32");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(weights.data()),
               static_cast<std::streamsize>(weights.size() * sizeof(float)));
    const Source source = openSource(path);
    for (const auto& pair : somePairs())
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(evaluateNetwork(weights, pair.wo, pair.wi)[c],
                        source.evaluate(pair.wo, pair.wi)[c], 1e-12);
}

TEST(PeerTwin, OfTheTableIsCloseToWhatItTabulates)
{
    const ShaderPeer merl = merlPeer();
    const Source ggx = openSource("ggx:alpha=0.3,f0=0.9/0.6/0.3");
    constexpr double kTabulated = 0.01;  // linear between cells of one degree
    for (const auto& pair : somePairs()) {
        const Vec3d expected = ggx.evaluate(pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(merl.evaluate(pair.wo, pair.wi)[c], expected[c], kTabulated * expected[c]);
    }
}

}  // namespace
}  // namespace fbrdf::test
