// The cube map that the GPU makes of an environment is compared with the one that the CPU makes.
#include <fbrdf/environment/Prefilter.h>

#include <gtest/gtest.h>

#include "support/ExpectError.h"
#include "support/gl/EnvironmentReference.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kCube = 32;
// Relative to a texel, or to the mean of its level where that is larger. Both integrate
// along meridians, the GPU in float and over fewer of them.
constexpr double kMeridians = 3e-3;
// The same cells of lobes over the same texels, in float.
constexpr double kConvolution = 1e-4;
// Halves have 11 bits.
constexpr double kHalf = 1e-3;

/// The largest difference of two levels, relative to the texel or the mean where that is larger.
double levelDifference(const std::vector<Vec3f>& found, const std::vector<Vec3f>& expected)
{
    double mean = 0.0, largest = 0.0;
    for (const Vec3f& texel : expected)
        mean +=
            (double(texel.x) + double(texel.y) + double(texel.z)) / 3.0 / double(expected.size());
    for (size_t i = 0; i < expected.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double exact = double(expected[i][c]);
            largest =
                std::max(largest, std::abs(double(found[i][c]) - exact) / std::max(exact, mean));
        }
    return largest;
}

/// The integral of a level over all directions.
double integralOf(const CubeImage& cube, size_t level)
{
    const int size = cube.sizeOf(level);
    double sum = 0.0;
    for (size_t i = 0; i < cube.levels[level].size(); ++i) {
        const int at = static_cast<int>(i), x = at % size, y = at / size % size,
                  face = at / size / size;
        const Vec3d d = glm::abs(cubeTexelDirection(face, x, y, size));
        const double largest = std::max(d.x, std::max(d.y, d.z));
        sum += double(cube.levels[level][i].x) * std::pow(largest, 3.0) * 4.0 / (size * size);
    }
    return sum;
}

class EnvironmentMaking : public RendererTest {
protected:
    std::shared_ptr<gl::GpuEnvironment> made(const Panorama& panorama, int size = kCube,
                                             bool floats = true)
    {
        return renderer_->createEnvironment(panorama, {size, floats});
    }

    static CubeImage onCpu(const Panorama& panorama, int size = kCube)
    {
        return prefiltered(cubeOfPanorama(panorama, size), size);
    }

    void expectSame(const CubeImage& found, const CubeImage& expected, double tolerance)
    {
        ASSERT_EQ(found.levels.size(), expected.levels.size());
        for (size_t level = 0; level < found.levels.size(); ++level)
            EXPECT_LT(levelDifference(found.levels[level], expected.levels[level]), tolerance)
                << "level " << level;
    }
};

TEST_P(EnvironmentMaking, IsWhatTheCpuMakes)
{
    for (const int width : {16, 256}) {
        const Panorama panorama = testPanorama(width);
        const auto environment = made(panorama);
        EXPECT_EQ(environment->whyNotOnGpu(), "");
        EXPECT_EQ(environment->size(), kCube);
        EXPECT_EQ(environment->levels(), 3);
        const CubeImage found = readCube(gl(), *environment), expected = onCpu(panorama);
        expectSame(found, expected, kMeridians);
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

// The tester: a cube of another panorama must not pass.
TEST_P(EnvironmentMaking, IsNotWhatTheCpuMakesOfATurnedPanorama)
{
    const CubeImage found = readCube(gl(), *made(testPanorama(64)));
    const CubeImage other = onCpu(turnedPanorama(testPanorama(64)));
    for (size_t level = 0; level < found.levels.size(); ++level)
        EXPECT_GT(levelDifference(found.levels[level], other.levels[level]), 10 * kMeridians);
}

// A sun of one texel keeps its energy wherever it is, at the poles too, and however much finer than
// the cube the panorama is: the CPU's method is exact.
TEST_P(EnvironmentMaking, KeepsTheEnergyOfASmallSun)
{
    for (const int width : {64, 512}) {
        Panorama panorama{width, width / 2, {}};
        const auto count = static_cast<size_t>(width * panorama.height);
        for (const int row : {0, 1, width / 8, width / 4, width / 2 - 1}) {
            panorama.texels.assign(count, Vec3f(0.0f));
            panorama.texels[static_cast<size_t>(row * width + width / 5)] = Vec3f(1e6f);
            const CubeImage found = readCube(gl(), *made(panorama, 16)),
                            exact = onCpu(panorama, 16);
            for (size_t level = 0; level < exact.levels.size(); ++level) {
                EXPECT_LT(levelDifference(found.levels[level], exact.levels[level]), kMeridians)
                    << width << " row " << row << " level " << level;
                EXPECT_NEAR(integralOf(found, level) / integralOf(exact, level), 1.0, kMeridians);
            }
        }
    }
}

TEST_P(EnvironmentMaking, StoresHalvesOrFloats)
{
    Panorama panorama = testPanorama(64);
    const CubeImage floats = readCube(gl(), *made(panorama)),
                    halves = readCube(gl(), *made(panorama, kCube, false));
    expectSame(halves, floats, kHalf);
    // Halves end at 65504: infinity would spread over whole levels.
    for (Vec3f& texel : panorama.texels) texel *= 1e6f;
    const CubeImage clamped = readCube(gl(), *made(panorama, kCube, false));
    for (const auto& level : clamped.levels)
        for (const Vec3f& texel : level)
            for (int c = 0; c < 3; ++c) ASSERT_LE(texel[c], 65504.0f);
    EXPECT_EQ(clamped.levels[0][0].x, 65504.0f);
}

TEST_P(EnvironmentMaking, OnTheCpuIsTheSameWithANote)
{
    Capabilities old = renderer_->capabilities();
    old.floatTargets = false;
    gl::RendererOptions options = rendererOptions();
    options.capabilities = old;
    gl::Renderer renderer(options);
    const Panorama panorama = testPanorama(32);
    const auto environment = renderer.createEnvironment(panorama, {16, true});
    EXPECT_NE(environment->whyNotOnGpu().find("float surfaces"), std::string::npos);
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("by the CPU"), std::string::npos) << log[0];
    expectSame(readCube(gl(), *environment), onCpu(panorama, 16), 1e-6);
    expectError(ErrorKind::gl, "float surfaces", [&] {
        renderer.createEnvironment(gl::HostEnvironment{environment->texture(), true}, {16, true});
    });
}

TEST_P(EnvironmentMaking, TakesAPanoramaOfTheHost)
{
    const Panorama panorama = testPanorama(64);
    GLuint texture = 0;
    gl().GenTextures(1, &texture);
    gl().BindTexture(GL_TEXTURE_2D, texture);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 64, 32, 0, GL_RGB, GL_FLOAT,
                    panorama.texels.data());
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl().BindTexture(GL_TEXTURE_2D, 0);
    const auto ours = made(panorama);
    const auto picture =
        renderer_->createEnvironment(gl::HostEnvironment{texture, false}, {kCube, true});
    // Texels are read at their centres, where a filter leaves rounding only.
    expectSame(readCube(gl(), *picture), readCube(gl(), *ours), 1e-4);
    gl().DeleteTextures(1, &texture);
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(EnvironmentMaking, TakesACubeMapOfTheHost)
{
    const Panorama panorama = testPanorama(64);
    const CubeImage source = cubeOfPanorama(panorama, kCube);
    GLuint texture = 0;
    gl().GenTextures(1, &texture);
    gl().BindTexture(GL_TEXTURE_CUBE_MAP, texture);
    for (size_t face = 0; face < 6; ++face)
        gl().TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, GL_RGB32F,
                        kCube, kCube, 0, GL_RGB, GL_FLOAT,
                        source.levels[0].data() + face * kCube * kCube);
    gl().TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl().BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    const auto cube =
        renderer_->createEnvironment(gl::HostEnvironment{texture, true}, {kCube, true});
    expectSame(readCube(gl(), *cube), onCpu(panorama), kConvolution);
    gl().DeleteTextures(1, &texture);
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(EnvironmentMaking, MakesAPanoramaSmallerThatTexturesCannotBe)
{
    Capabilities small = renderer_->capabilities();
    small.maxTextureSize = 50;
    gl::RendererOptions options = rendererOptions();
    options.capabilities = small;
    gl::Renderer renderer(options);
    const Panorama panorama = testPanorama(256);
    const auto reduced = renderer.createEnvironment(panorama, {8, true});
    EXPECT_EQ(reduced->whyNotOnGpu(), "");
    const double whole = integralOf(readCube(gl(), *made(panorama, 8)), 0);
    EXPECT_NEAR(integralOf(readCube(gl(), *reduced), 0) / whole, 1.0, 1e-3);
}

TEST_P(EnvironmentMaking, TakesACubeThatIsPrefiltered)
{
    const CubeImage cube = onCpu(testPanorama(32), 16);
    const auto environment = renderer_->createEnvironment(cube, {0, true});
    EXPECT_EQ(environment->size(), 16);
    expectSame(readCube(gl(), *environment), cube, 1e-6);
    CubeImage broken = cube;
    broken.levels.pop_back();
    expectError(ErrorKind::input, "levels", [&] { renderer_->createEnvironment(broken); });
    broken = cube;
    broken.levels[1].pop_back();
    expectError(ErrorKind::input, "texels", [&] { renderer_->createEnvironment(broken); });
}

TEST_P(EnvironmentMaking, GraduallyIsBitEqualInTheEnd)
{
    const Panorama panorama = testPanorama(64);
    for (const long long texels : {1LL, 5000LL, 100000LL}) {
        gl::EnvironmentOptions options{64, true};
        options.gradual = true;
        const auto environment = renderer_->createEnvironment(panorama, options);
        EXPECT_FALSE(environment->isFinished());
        int steps = 1;
        while (!renderer_->refine(*environment, texels)) ASSERT_LT(++steps, 1000);
        EXPECT_TRUE(environment->isFinished());
        // The faces with 64 texels on a side are left to it, and it draws whole rows.
        const long long left = 6 * 64 * 64;
        EXPECT_EQ(steps, texels == 1 ? 64 : steps);
        EXPECT_LE(steps, (left + texels - 1) / texels);
        expectSame(readCube(gl(), *environment), readCube(gl(), *made(panorama, 64)), 1e-30);
        EXPECT_TRUE(renderer_->refine(*environment, texels));  // nothing is left
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(EnvironmentMaking, OnlyWhatADrawerAskedForComesGradually)
{
    EXPECT_TRUE(made(testPanorama(16))->isFinished());
    gl::EnvironmentOptions small{kCube, true};
    small.gradual = true;  // all of its levels are drawn at once
    const auto environment = renderer_->createEnvironment(testPanorama(16), small);
    EXPECT_TRUE(environment->isFinished());
    expectError(ErrorKind::usage, "found 0 texels", [&] { renderer_->refine(*environment, 0); });
    gl::Renderer other(rendererOptions());
    expectError(ErrorKind::usage, "another renderer", [&] { other.refine(*environment, 1); });
}

INSTANTIATE_TEST_SUITE_P(Backends, EnvironmentMaking, ::testing::ValuesIn(allVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
