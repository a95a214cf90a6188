// How finely a context filters is measured, part of every bound, and no matter where the shader
// filters. Contexts that filter as coarsely as GPUs are played by a loader (CoarseFilter.h).
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/CoarseFilter.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Reference.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr double kFine = 1e-6;  // of a difference of neighbours: float arithmetic

/// A ramp of a quarter of an octave a texel along the first axis, flat along the others.
Material ramp(Storage storage)
{
    Material material = noiseMaterial(formHdio({16, 4, 4}), storage);
    for (Table& table : material.tables) {
        const int width = domainSize(table.domain)[0];
        for (size_t i = 0; i < table.texels.size(); ++i)
            table.texels[i] = static_cast<float>(static_cast<int>(i) / 3 % width) * 0.25f;
        Table steep = table;
        steep.storage = Storage::float32;
        table = quantized(steep, storage);
    }
    return material;
}

class Filtering : public GlTest {
protected:
    gl::RendererOptions coarse(int bits)
    {
        gl::RendererOptions options = rendererOptions();
        options.load = coarselyFiltering(context().options().backend, bits);
        return options;
    }
    /// Capabilities of a GPU: nothing is known to be sampled by a CPU.
    gl::RendererOptions withAllTypes(gl::RendererOptions options)
    {
        options.capabilities = gl::Renderer(options).capabilities();
        options.capabilities->softwareSampling = false;
        return options;
    }
    double filterError(const gl::RendererOptions& options, const Material& material,
                       const gl::MaterialOptions& uploaded = {})
    {
        gl::Renderer renderer(options);
        return renderer.createMaterial(material, uploaded)->filterError();
    }
};

/// Sum over the factors of a term, as a plan adds them up.
double contrastOf(const Material& material)
{
    double worst = 0.0;
    for (const Term& term : material.form.terms) {
        double sum = 0.0;
        for (const Factor& factor : term.factors)
            sum += contrast(material.tables[static_cast<size_t>(factor.table)]);
        worst = std::max(worst, sum);
    }
    return worst;
}

/// The largest error of a ramp between two texels, in 4096 steps, by plain calls of GL.
class Ramps : public GlTest {
protected:
    double largestError(GLint internalFormat)
    {
        constexpr GLsizei kSteps = 4096;
        const auto& g = gl();
        const float texels[] = {0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f};
        GLuint texture = 0, array = 0;
        g.GenTextures(1, &texture);
        g.BindTexture(GL_TEXTURE_2D, texture);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        g.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        g.TexImage2D(GL_TEXTURE_2D, 0, internalFormat, 2, 1, 0, GL_RGB, GL_FLOAT, texels);
        g.GenVertexArrays(1, &array);
        g.BindVertexArray(array);
        Offscreen offscreen(context().loader(), {kSteps, 1, OffscreenFormat::rgba32f, false});
        g.BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
        g.Viewport(0, 0, kSteps, 1);
        const GLuint program = linkProgram(
            g,
            "#version 140\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
            "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
            "#version 140\nuniform sampler2D map;\nout vec4 result;\nvoid main() { result = "
            "textureLod(map, vec2(0.25 + 0.5 * gl_FragCoord.x / 4096.0, 0.5), 0.0); }\n");
        g.UseProgram(program);
        g.DrawArrays(GL_TRIANGLES, 0, 3);
        const auto pixels = offscreen.readPixels();
        double worst = 0.0;
        for (size_t i = 0; i < static_cast<size_t>(kSteps); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(pixels[4 * i]) -
                                             (static_cast<double>(i) + 0.5) / kSteps));
        g.UseProgram(0);
        g.DeleteProgram(program);
        g.DeleteTextures(1, &texture);
        g.BindVertexArray(0);
        g.DeleteVertexArrays(1, &array);
        g.BindFramebuffer(GL_FRAMEBUFFER, 0);
        return worst;
    }
};

// Whatever the driver, what is measured agrees with a ramp that is drawn in another way.
TEST_P(Ramps, AgreeWithWhatIsMeasured)
{
    gl::RendererOptions options = rendererOptions();
    options.load = context().loader();
    options.capabilities = gl::Renderer(options).capabilities();
    options.capabilities->softwareSampling = false;
    const std::pair<Storage, GLint> types[] = {
        {Storage::log8, GL_RGB16}, {Storage::half, GL_RGB16F}, {Storage::float32, GL_RGBA32F}};
    for (const auto& [storage, format] : types) {
        gl::Renderer renderer(options);
        const Material material = ramp(storage);
        const double found =
            renderer.createMaterial(material)->filterError() / contrastOf(material);
        const double drawn = largestError(format);
        EXPECT_GE(found, 0.9 * drawn - 1e-7) << storageName(storage);
        EXPECT_LE(found, 1.2 * drawn + 3e-5) << storageName(storage);
    }
}

TEST_P(Ramps, SeeCoarseFiltering)  // the tester: 8-bit texels have no finer weights on llvmpipe
{
    const std::string name = reinterpret_cast<const char*>(gl().GetString(GL_RENDERER));
    if (name.find("llvmpipe") == std::string::npos) GTEST_SKIP() << name << " is not llvmpipe";
    EXPECT_GT(largestError(GL_RGB8), 1e-3);
}

TEST_P(Filtering, OfFewBitsIsFound)
{
    for (const int bits : {8, 6, 4, 0})
        for (const Storage storage : {Storage::log8, Storage::half, Storage::float32}) {
            const Material material = ramp(storage);
            const double found = filterError(withAllTypes(coarse(bits)), material);
            const double step = std::exp2(-bits - 1) * contrastOf(material);
            EXPECT_GT(found, 0.98 * step) << bits << " bits, " << storageName(storage);
            EXPECT_LT(found, 1.06 * step) << bits << " bits, " << storageName(storage);
        }
}

TEST_P(Filtering, OfVolumesCubesAndArraysIsFound)
{
    const double step = 0x1p-9;
    const Material volume =
        noiseMaterial({"volume",
                       {{"v", GridDomain{{Axis{6, {}}, Axis{5, {}}, Axis{4, {}}}}}},
                       {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d, Angle::phi_d}}}}}},
                      Storage::half);
    EXPECT_NEAR(filterError(coarse(8), volume) / (step * contrastOf(volume)), 1.02, 0.05);
    const Material disc = noiseMaterial(formPqp(16, 1.0), Storage::half);
    if (GetParam().legacy) return;  // GLSL 1.20 is not told to filter cubes coarsely
    // Recombined maps of noise are smoother than the noise.
    EXPECT_GT(filterError(coarse(8), disc, {LookUp::cube, 32}), 0.2 * step * contrastOf(disc));
    gl::Renderer renderer(coarse(8));
    if (renderer.capabilities().bufferTextures) {
        const auto library = renderer.createLibrary({disc, disc});
        EXPECT_EQ(library->whyNotPacked(), "");
    }
}

TEST_P(Filtering, ByTheShaderHasNoError)
{
    for (const Storage storage : {Storage::log8, Storage::half, Storage::float32})
        EXPECT_EQ(filterError(withAllTypes(coarse(4)), ramp(storage), {LookUp::native, 0, true}),
                  0.0);
}

TEST_P(Filtering, ThatAHostKnowsIsNotMeasured)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = gl::Renderer(options).capabilities();
    options.capabilities->filter = FilterPrecision{0.125, 0.0};
    const Material material = ramp(Storage::float32);
    EXPECT_NEAR(filterError(options, material), 0.125 * contrastOf(material), 1e-9);
}

/// Draws with the techniques and returns the largest share of the bound that was used up.
class Bounds : public Filtering {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        mesh_ = sphereMesh(16);
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, mesh_, glm::mat4(1.0f), perspectiveView());
    }

    struct Share {
        double ofBound = 0.0;  ///< of what the plan states
        double ofFiner = 0.0;  ///< of what it would state if nothing were known of the filter
        double relative = 0.0;
    };
    Share drawn(gl::Renderer& renderer, const Material& material,
                const gl::MaterialOptions& uploaded, Technique technique, bool clustered = false)
    {
        const auto lights = testLights(3);
        const auto exact = referenceImage(material, geometry_, lights, perspectiveView());
        const auto gpu = renderer.createMaterial(material, uploaded);
        const auto mesh = renderer.createMesh(mesh_);
        gl::DrawOptions options;
        options.technique = technique;
        options.clustered = clustered;
        const Drawn found = drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), mesh.get()}},
                                      lights, options);
        EXPECT_EQ(found.stats.filter, uploaded.precise ? Filter::shader : Filter::hardware);
        ErrorBound finer = found.stats.error;
        finer.relative = (1.0 + finer.relative) / std::exp2(finer.maps.filtering) - 1.0;
        finer.absolute -= finer.maps.absolute;
        const auto deviation = deviationOf(found.pixels, exact, found.stats.error);
        return {deviation.share, deviationOf(found.pixels, exact, finer).share, deviation.relative};
    }

    gl::MeshData mesh_;
    GeometryBuffer geometry_;
};

TEST_P(Bounds, HoldWhereTheFilterIsCoarse)
{
    gl::Renderer renderer(coarse(8));
    double used = 0.0, withoutFilter = 0.0;
    for (const Material& material : testMaterials()) {
        if (hasSigns(material)) continue;
        for (const Technique technique : allTechniques()) {
            const Share share = drawn(renderer, material, {}, technique);
            EXPECT_LE(share.ofBound, 1.0) << material.name << " " << techniqueName(technique);
            used = std::max(used, share.ofBound);
            withoutFilter = std::max(withoutFilter, share.ofFiner);
        }
        if (renderer.capabilities().bufferTextures) {
            EXPECT_LE(drawn(renderer, material, {}, Technique::single, true).ofBound, 1.0)
                << material.name;
        }
    }
    EXPECT_GT(used, 0.05) << "a bound that nothing comes near says nothing";
    // The tester: the filter is as coarse as it should be, and what is stated without it is false.
    EXPECT_GT(withoutFilter, 10.0);
}

TEST_P(Bounds, AreThoseOfFloatsWhereTheShaderFilters)
{
    gl::Renderer renderer(coarse(8));
    for (const Material& material : testMaterials()) {
        if (hasSigns(material)) continue;
        for (const Technique technique : allTechniques()) {
            const Share share = drawn(renderer, material, {LookUp::native, 0, true}, technique);
            EXPECT_LE(share.ofBound, 1.0) << material.name << " " << techniqueName(technique);
            EXPECT_LE(share.relative, 1e-4) << material.name << " " << techniqueName(technique);
        }
    }
}

TEST_P(Bounds, OfRecombinedMapsHold)
{
    gl::Renderer renderer(coarse(6));
    const Material material = calmMaterial(formPqp(16, 0.5));
    for (const gl::MaterialOptions& uploaded :
         {gl::MaterialOptions{LookUp::parabolic, 32}, gl::MaterialOptions{LookUp::cube, 32},
          gl::MaterialOptions{LookUp::parabolic, 32, true}})
        EXPECT_LE(drawn(renderer, material, uploaded, Technique::single).ofBound, 1.0)
            << lookUpName(uploaded.lookUp) << (uploaded.precise ? " precise" : "");
}

TEST_P(Bounds, ThatAreAbsoluteGrowWithTheLights)
{
    gl::Renderer renderer(coarse(6));
    const auto gpu = renderer.createMaterial(waterlooMaterial());
    const auto mesh = renderer.createMesh(mesh_);
    const auto absolute = [&](int lights) {
        return drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), mesh.get()}},
                         testLights(lights))
            .stats.error.maps.absolute;
    };
    EXPECT_GT(absolute(1), 0.0);
    EXPECT_GT(absolute(4), absolute(1));
}

// A log may stand for a value that no double holds: the bound must not become what is no number.
TEST_P(Bounds, OfTablesWithoutALargestValueAreNumbers)
{
    gl::Renderer renderer(coarse(8));
    const auto mesh = renderer.createMesh(mesh_);
    Material material = ramp(Storage::float32);
    material.tables[0].texels[0] = 1100.0f;
    const auto gpu = renderer.createMaterial(material);
    const Drawn found =
        drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), mesh.get()}}, testLights(3));
    EXPECT_EQ(found.stats.itemsFailed, 0);
    EXPECT_GE(found.stats.error.relative, 0.0);
    EXPECT_EQ(found.stats.error.maps.absolute, 0.0);
}

TEST_P(Filtering, OfCubesByTheShaderIsNotDoneAndSaysWhy)
{
    gl::Renderer renderer(rendererOptions());
    const auto gpu = renderer.createMaterial(noiseMaterial(formPqp(16, 1.0), Storage::half),
                                             {LookUp::cube, 32, true});
    EXPECT_NE(gpu->whyNotRecombined().find("edges of a cube"), std::string::npos);
    EXPECT_EQ(gpu->lookUpError(), 0.0);
}

TEST_P(Filtering, OfALibraryIsAsFineAsOfItsMaterials)
{
    gl::Renderer renderer(coarse(8));
    if (!renderer.capabilities().bufferTextures) GTEST_SKIP() << "libraries need OpenGL 3.1";
    const Material material = noiseMaterial(formHdio({16, 8, 8}), Storage::half);
    const auto mesh = renderer.createMesh(sphereMesh(16));
    for (const bool precise : {false, true}) {
        const gl::MaterialOptions uploaded{LookUp::native, 0, precise};
        const auto library = renderer.createLibrary({material, material}, uploaded);
        EXPECT_EQ(library->whyNotPacked(), "");
        const auto gpu = renderer.createMaterial(material, uploaded);
        Offscreen offscreen = makeOffscreen(kSize);
        const auto stats =
            renderer.drawBatch({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                               {library.get(), mesh.get(), {{glm::mat4(1.0f), 1}}}, testLights(2));
        EXPECT_EQ(stats.filter, precise ? Filter::shader : Filter::hardware);
        EXPECT_NEAR(stats.error.maps.filtering, gpu->filterError(), 1e-3 * gpu->filterError());
        const auto apart =
            drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), mesh.get()}}, testLights(2));
        const auto packed = offscreen.readPixels();
        double worst = 0.0;
        for (size_t i = 0; i < packed.size(); ++i)
            worst = std::max(worst, static_cast<double>(std::abs(packed[i] - apart.pixels[i])));
        EXPECT_LE(worst, precise ? 1e-5 : 0.1);
    }
}

class FilterFault : public Filtering {
protected:
    bool wasAssumed() const
    {
        return std::any_of(log.begin(), log.end(), [](const std::string& line) {
            return line.find("8 bits between texels are assumed") != std::string::npos;
        });
    }
};

TEST_P(FilterFault, ATypeThatTheDriverDoesNotFilterIsFound)
{
    Hooks hooks(context().loader());
    hooks.unfilteredFormat = GL_RGB16F;
    gl::RendererOptions options = withAllTypes(hooked(hooks));
    const Material halves = ramp(Storage::half), bytes = ramp(Storage::log8);
    gl::Renderer renderer(options);
    EXPECT_NEAR(renderer.createMaterial(halves)->filterError() / contrastOf(halves), 0.5, 0.03);
    EXPECT_LT(renderer.createMaterial(bytes)->filterError() / contrastOf(bytes), 1e-4);
}

TEST_P(FilterFault, ANewContextIsMeasuredAnew)
{
    const Material material = ramp(Storage::half);
    const double before = filterError(coarse(10), material);
    EXPECT_NEAR(filterError(coarse(5), material) / before, 32.0, 2.0);
}

TEST_P(FilterFault, ATargetThatCannotBeDrawnToLeavesAnAssumption)
{
    Hooks hooks(context().loader());
    hooks.refuseFramebuffers = true;
    const Material material = ramp(Storage::float32);
    EXPECT_GE(filterError(hooked(hooks), material), 0x1p-8 * contrastOf(material));
    EXPECT_TRUE(wasAssumed());
}

TEST_P(FilterFault, AnErrorWhileMeasuringLeavesAnAssumptionAndTheNextCallWorks)
{
    const Material material = ramp(Storage::float32);
    bool seen = false;
    for (int after = 0; after < 12; ++after) {
        Hooks hooks(context().loader());
        gl::Renderer renderer(hooked(hooks));
        log.clear();
        hooks.nextError = GL_OUT_OF_MEMORY;
        hooks.errorAfter = after;
        try {
            renderer.createMaterial(material);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::gl);
        }
        seen = seen || wasAssumed();
        hooks.nextError = GL_NO_ERROR;
        const auto gpu = renderer.createMaterial(material);
        EXPECT_GT(gpu->filterError(), 0.0);
    }
    EXPECT_TRUE(seen);
}

// glGetError of a lost context never ends, and what is read back is nothing. The context is back
// afterwards, as after a reset.
TEST_P(FilterFault, AContextThatIsLostWhileMeasuringEndsTheCall)
{
    constexpr GLenum kContextLost = 0x0507;  // GL_CONTEXT_LOST, OpenGL 4.5
    const Material material = ramp(Storage::float32);
    int refused = 0;
    for (int after = 0; after < 4; ++after) {
        Hooks hooks(context().loader());
        gl::Renderer renderer(hooked(hooks));
        hooks.nextError = kContextLost;
        hooks.errorAfter = after;
        hooks.errorStays = true;
        hooks.errorsAsked = 0;
        try {
            renderer.createMaterial(material);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::gl);
            EXPECT_NE(std::string(error.what()).find("0x0507"), std::string::npos) << error.what();
            ++refused;
        }
        EXPECT_LT(hooks.errorsAsked, 400) << after;
        hooks.errorStays = false;
        hooks.nextError = GL_NO_ERROR;
        const auto gpu = renderer.createMaterial(material);
        EXPECT_GT(gpu->filterError(), 0.0);
        EXPECT_LT(gpu->filterError(), 0x1p-10 * contrastOf(material)) << "measured, not assumed";
    }
    EXPECT_EQ(refused, 4);
}

INSTANTIATE_TEST_SUITE_P(Backends, Ramps, ::testing::ValuesIn(modernVariants()), variantName);
INSTANTIATE_TEST_SUITE_P(Backends, Filtering, ::testing::ValuesIn(allVariants()), variantName);
INSTANTIATE_TEST_SUITE_P(Backends, Bounds, ::testing::ValuesIn(allVariants()), variantName);
INSTANTIATE_TEST_SUITE_P(Backends, FilterFault, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
