// Directions that a shader draws by the lobes of a material, through the binding of a host, against
// their twins on the CPU, against the density that is claimed for them, and against the albedo.
#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/gl/MaterialBinding.h>

#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include "support/DirectionCells.h"
#include "support/gl/EnvironmentReference.h"
#include "support/gl/GlTest.h"
#include "support/gl/Scenes.h"

#include <cmath>
#include <functional>

namespace fbrdf::test {
namespace {

using Vec4 = glm::vec4;

constexpr int kSide = 64, kDraws = kSide * kSide;
// Axes come from atan, pow and exp2, which the GPU rounds more coarsely than the CPU; the narrowest
// lobe turns that into 64 times as much of its density.
constexpr double kDensity = 3e-3;
// Root of mean squares of the distance between two directions. At the rim of a lobe the cosine is
// the root of what rounding leaves, 1e-6 of the rest of a number.
constexpr double kDirection = 2e-4, kFarthest = 1e-2;

std::vector<LobeTable> sampledTables()
{
    std::vector<LobeTable> tables{
        testLobes(LobeAxes::tilted, 1),     testLobes(LobeAxes::tilted, 2),
        testLobes(LobeAxes::tilted, 3),     testLobes(LobeAxes::bent, 1),
        testLobes(LobeAxes::bent, 3, true), testLobes(LobeAxes::bent, 7)};
    // Lobes that are as narrow as any, one that is the cosine, and one that reflects nothing.
    tables.push_back(testLobes(LobeAxes::tilted, 3));
    for (LobeKnot& knot : tables.back().knots) {
        knot.lobes[0].level = 0.0f;
        knot.lobes[1].level = 6.0f;
        knot.lobes[2].weight = Vec3f(0.0f);
    }
    tables.push_back(testLobes(LobeAxes::tilted, 1));
    for (LobeKnot& knot : tables.back().knots) knot.cosine = knot.lobes[0].weight = Vec3f(0.0f);
    return tables;
}

/// View directions all over the upper half, from the normal almost to the horizon.
Vec3f viewOf(int i)
{
    // Not the normal itself, where a shader's atan is not defined.
    const double theta = 1e-3 + 1.55 * (i % kSide) / (kSide - 1.0), phi = 2.399963 * (i / kSide);
    return Vec3f(directionAt(theta, phi));
}

/// Two numbers in [0, 1) that cover the square evenly (Roberts 2018, R2).
Vec2<float> numbersOf(int i)
{
    const double x = 0.5 + 0.7548776662466927 * i, y = 0.5 + 0.5698402909980532 * i;
    return {static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y))};
}

class Sampling : public RendererTest {
protected:
    /// Runs `statements`, which read vec4 a, b and set vec4 result, for kDraws inputs in a program
    /// with the functions of the material.
    std::vector<Vec4> run(const std::shared_ptr<gl::GpuMaterial>& material,
                          const std::string& statements, const std::function<Vec4(int)>& a,
                          const std::function<Vec4(int)>& b);

    std::shared_ptr<gl::GpuMaterial> sampled(const LobeTable& lobes)
    {
        return exactMaterial(*renderer_, withLobes(testMaterials()[0], lobes));
    }
    /// Directions and densities of all inputs.
    std::vector<Vec4> draws(const LobeTable& lobes, const std::function<Vec4(int)>& wo)
    {
        return run(sampled(lobes), "result = fbrdfSampleLobes(a.xyz, b.xy);", wo,
                   [](int i) { return Vec4(numbersOf(i), 0.0f, 0.0f); });
    }
    int glsl() const { return renderer_->capabilities().glsl; }
};

std::vector<Vec4> Sampling::run(const std::shared_ptr<gl::GpuMaterial>& material,
                                const std::string& statements, const std::function<Vec4(int)>& a,
                                const std::function<Vec4(int)>& b)
{
    const auto& g = gl();
    const std::string version = "#version " + std::to_string(glsl()) + "\n";
    const GLuint program = linkProgram(
        g,
        version + std::string(glsl() == 120 ? "attribute" : "in") +
            " vec3 fbrdfVertex;\nvoid main() { gl_Position = vec4(fbrdfVertex, 1.0); }\n",
        version + materialFunctions(*material, glsl(), 1) + samplingFunctions(*material, glsl()) +
            "uniform sampler2D inputA, inputB;\n" +
            (glsl() == 120 ? "#define result gl_FragColor\n" : "out vec4 result;\n") +
            "void main()\n{\n    vec2 at = gl_FragCoord.xy / 64.0;\n"
            "    vec4 a = FBRDF_TEXTURE2(inputA, at), b = FBRDF_TEXTURE2(inputB, at);\n    " +
            statements + "\n}\n");
    const gl::MaterialBinding binding(material, program);
    const int used = binding.apply(0);
    GLuint textures[2] = {};
    g.GenTextures(2, textures);
    for (int t = 0; t < 2; ++t) {
        std::vector<Vec4> texels;
        for (int i = 0; i < kDraws; ++i) texels.push_back((t == 0 ? a : b)(i));
        g.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(used + t));
        g.BindTexture(GL_TEXTURE_2D, textures[t]);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        g.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT,
                     texels.data());
        g.Uniform1i(g.GetUniformLocation(program, t == 0 ? "inputA" : "inputB"), used + t);
    }
    const float corners[] = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
    GLuint buffer = 0, array = 0;
    const bool hasArrays = g.GenVertexArrays != nullptr && glsl() != 120;
    if (hasArrays) {
        g.GenVertexArrays(1, &array);
        g.BindVertexArray(array);
    }
    g.GenBuffers(1, &buffer);
    g.BindBuffer(GL_ARRAY_BUFFER, buffer);
    g.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    const auto place = static_cast<GLuint>(g.GetAttribLocation(program, "fbrdfVertex"));
    g.EnableVertexAttribArray(place);
    g.VertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    Offscreen target = makeOffscreen(kSide);
    g.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    g.Viewport(0, 0, kSide, kSide);
    g.DrawArrays(GL_TRIANGLES, 0, 3);
    const auto pixels = target.readPixels();
    g.DisableVertexAttribArray(place);
    g.BindFramebuffer(GL_FRAMEBUFFER, 0);
    g.BindBuffer(GL_ARRAY_BUFFER, 0);
    g.DeleteBuffers(1, &buffer);
    if (hasArrays) g.DeleteVertexArrays(1, &array);
    g.DeleteTextures(2, textures);
    g.ActiveTexture(GL_TEXTURE0);
    g.UseProgram(0);
    g.DeleteProgram(program);
    std::vector<Vec4> results;
    for (size_t i = 0; i < kDraws; ++i)
        results.emplace_back(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2],
                             pixels[4 * i + 3]);
    return results;
}

Vec4 viewInput(int i)
{
    return Vec4(viewOf(i), 0.0f);
}

TEST_P(Sampling, DirectionsAndDensitiesAreThoseOfTheCpu)
{
    for (const LobeTable& table : sampledTables()) {
        const auto found = draws(table, viewInput);
        double squares = 0.0;
        for (int i = 0; i < kDraws; ++i) {
            const auto expected = sampleLobes(table, viewOf(i), numbersOf(i));
            const Vec4& draw = found[static_cast<size_t>(i)];
            const double distance = double(glm::length(Vec3f(draw) - expected.wi));
            ASSERT_LT(distance, kFarthest) << i;
            ASSERT_NEAR(double(draw.w), double(expected.pdf),
                        kDensity * double(expected.pdf) + 10.0 * distance)
                << i;
            squares += distance * distance;
        }
        EXPECT_LT(std::sqrt(squares / kDraws), kDirection);
    }
}

TEST_P(Sampling, DensitiesOfAnyDirectionAreThoseOfTheCpu)
{
    const auto light = [](int i) {
        const Vec2<float> u = numbersOf(i);
        return Vec3f(directionAt(std::acos(1.0 - 2.0 * double(u.x)), 2.0 * kPi * double(u.y)));
    };
    for (const LobeTable& table : sampledTables()) {
        const auto found = run(sampled(table), "result = vec4(fbrdfLobePdf(a.xyz, b.xyz));",
                               viewInput, [&](int i) { return Vec4(light(i), 0.0f); });
        for (int i = 0; i < kDraws; ++i) {
            const double expected = double(lobePdf(table, viewOf(i), light(i)));
            ASSERT_NEAR(double(found[static_cast<size_t>(i)].x), expected,
                        kDensity * (expected + 1e-3))
                << i;
        }
    }
}

/// The excess of chi-square over all directions that are drawn for one view.
double excessOfDraws(const std::vector<Vec4>& draws, const LobeTable& claimed, const Vec3d& wo)
{
    std::vector<int> counts(static_cast<size_t>(kCellRows * kCellColumns), 0);
    for (const Vec4& draw : draws) ++counts[directionCell(Vec3d(Vec3f(draw)))];
    const auto expected =
        cellProbabilities([&](const Vec3d& wi) { return lobePdf(claimed, wo, wi); });
    return chiSquareExcess(expected, counts, static_cast<int>(draws.size()));
}

/// The table with all lobes wider or, where negative, narrower.
LobeTable widened(LobeTable table, float levels)
{
    for (LobeKnot& knot : table.knots)
        for (Lobe& lobe : knot.lobes) lobe.level = std::clamp(lobe.level + levels, 0.0f, 6.0f);
    return table;
}

// The numbers are even, not random, so that counts are nearer to the density than those of random
// draws: what is tested is that they are not farther.
TEST_P(Sampling, DrawsWithTheDensityThatItClaims)
{
    const Vec3f wo(directionAt(0.7, 2.0));
    for (const LobeTable& wide : {testLobes(LobeAxes::tilted, 2), testLobes(LobeAxes::bent, 3)}) {
        const LobeTable table = widened(wide, -2.0f);
        const auto found = draws(table, [&](int) { return Vec4(wo, 0.0f); });
        EXPECT_LT(excessOfDraws(found, table, Vec3d(wo)), 4.0);
        // The tester: lobes that are twice as wide are seen.
        EXPECT_GT(excessOfDraws(found, widened(table, 1.0f), Vec3d(wo)), 8.0);
    }
}

/// The integral of f cos theta_i.
Vec3d albedoOf(const Material& material, const Vec3d& wo)
{
    constexpr int kThetas = 200, kPhis = 400;
    Vec3d sum(0.0);
    for (int i = 0; i < kThetas; ++i)
        for (int j = 0; j < kPhis; ++j) {
            const double s2 = (i + 0.5) / kThetas, phi = 2.0 * kPi * (j + 0.5) / kPhis;
            const Vec3d wi(std::sqrt(s2) * std::cos(phi), std::sqrt(s2) * std::sin(phi),
                           std::sqrt(1.0 - s2));
            sum += kPi / (kThetas * kPhis) * evaluate<double>(material, wo, wi);
        }
    return sum;
}

TEST_P(Sampling, EstimatesTheAlbedo)
{
    constexpr double kOfDraws = 0.02;  // 4096 even numbers
    const LobeTable table = testLobes(LobeAxes::tilted, 2);
    const Material material = withLobes(testMaterials()[0], table);
    const auto gpu = exactMaterial(*renderer_, material);
    for (const double theta : {0.2, 1.1}) {
        const Vec3f wo(directionAt(theta, 0.4));
        const auto estimates = run(
            gpu,
            "vec4 drawn = fbrdfSampleLobes(a.xyz, b.xy);\n"
            "    result = vec4(fbrdfEvaluate(a.xyz, drawn.xyz) * (max(0.0, drawn.z) / drawn.w), "
            "1.0);",
            [&](int) { return Vec4(wo, 0.0f); },
            [](int i) { return Vec4(numbersOf(i), 0.0f, 0.0f); });
        Vec3d mean(0.0);
        for (const Vec4& estimate : estimates) mean += Vec3d(Vec3f(estimate)) / double(kDraws);
        const Vec3d albedo = albedoOf(material, Vec3d(wo));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], albedo[c], kOfDraws * albedo[c]) << theta;
    }
}

/// Fits lobes, which takes seconds in a Debug build: in one context alone.
class SamplingFit : public Sampling {};

TEST_P(SamplingFit, IsMadeForAMaterialThatHasNoLobes)
{
    const auto gpu = renderer_->createMaterial(noiseMaterial(formIo(), Storage::half));
    EXPECT_NE(samplingFunctions(*gpu, glsl()).find("vec4 fbrdfSampleLobes(vec3 wo, vec2 u)"),
              std::string::npos);
    EXPECT_THROW(samplingFunctions(*gpu, 100), Error);
}

TEST_P(Sampling, RefusesATableThatUniformsHaveNoRoomFor)
{
    auto options = rendererOptions();
    options.capabilities = renderer_->capabilities();
    options.capabilities->maxUniformVectors = 200;
    gl::Renderer renderer(options);
    const auto gpu =
        exactMaterial(renderer, withLobes(testMaterials()[0], testLobes(LobeAxes::bent, 7)));
    try {
        samplingFunctions(*gpu, glsl());
        ADD_FAILURE() << "taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("256 vectors of uniforms"), std::string::npos)
            << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, SamplingFit, ::testing::Values(GlVariant{}), variantName);
INSTANTIATE_TEST_SUITE_P(Backends, Sampling, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
