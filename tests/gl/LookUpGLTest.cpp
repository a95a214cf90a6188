// Maps recombined into parabolic and cube maps are compared with the tables in double, within the
// bound that follows from the interpolation error and the plan.
#include <gtest/gtest.h>

#include "support/ExpectError.h"
#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr LookUp kRecombined[] = {LookUp::parabolic, LookUp::cube};

/// p(wo) q(h) p(wi) [r(theta_d)] of smooth lobes, so that maps of 64 texels are within percents.
Material lobes(const Form& form, Storage storage = Storage::half)
{
    Material material = noiseMaterial(form, storage);
    for (Table& table : material.tables) {
        const auto* disc = std::get_if<DiscDomain>(&table.domain);
        if (!disc) continue;
        table.storage = Storage::float32;
        for (int i = 0; i < texelCount(table.domain); ++i) {
            const Vec3d d = directionFromDiscPosition(*disc, {i % disc->size, i / disc->size});
            for (int c = 0; c < 3; ++c)
                table.texels[3 * static_cast<size_t>(i) + static_cast<size_t>(c)] =
                    static_cast<float>(-2.0 * (1.0 - d.z) + 0.7 * d.x + 0.3 * c * d.x * d.y);
        }
        table = quantized(table, storage);
    }
    return material;
}

/// A form of other directions than wi, wo and h.
Form otherDirections()
{
    const DiscDomain disc = DiscDomain::fitting(16, 1.0);
    return {"other",
            {{"a", disc}, {"b", disc}, {"c", disc}},
            {{{{0, Direction::d}, {1, Direction::mirror}}},
             {{{2, Direction::combination(1.0, 0.5, 0.25)}}}}};
}

class LookUpMaps : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        mesh_ = sphereMesh(16);
        gpuMesh_ = renderer_->createMesh(mesh_);
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, mesh_, glm::mat4(1.0f), perspectiveView());
    }
    void TearDown() override
    {
        gpuMesh_.reset();
        RendererTest::TearDown();
    }

    /// The largest deviation of any technique, as a share of its bound.
    double worstShare(gl::Renderer& renderer, const Material& material,
                      const gl::MaterialOptions& options, const gl::GpuMesh& mesh,
                      const std::vector<Technique>& techniques = {allTechniques().begin(),
                                                                  allTechniques().end()})
    {
        const auto lights = testLights(3);
        const auto exact = referenceImage(material, geometry_, lights, perspectiveView());
        const auto gpu = renderer.createMaterial(material, options);
        EXPECT_EQ(gpu->whyNotRecombined(), "");
        double worst = 0.0;
        for (const auto technique : techniques) {
            const Drawn drawn = drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), &mesh}},
                                          lights, {technique, 2});
            EXPECT_EQ(drawn.stats.whyReplaced, "");
            EXPECT_LE(drawn.stats.maxLookups, technique == Technique::twoLookup ? 2 : 12);
            const double maps = std::exp2(gpu->lookUpError() + gpu->filterError()) - 1.0;
            EXPECT_GT(drawn.stats.error.relative, maps);
            EXPECT_LT(drawn.stats.error.relative, maps + 1e-4);
            const auto deviation = deviationOf(drawn.pixels, exact, drawn.stats.error);
            EXPECT_LE(deviation.share, 1.0)
                << material.form.name << " " << lookUpName(options.lookUp) << " "
                << techniqueName(technique) << " " << deviation.relative << " of "
                << drawn.stats.error.relative;
            worst = std::max(worst, deviation.share);
        }
        return worst;
    }

    gl::MeshData mesh_;
    std::shared_ptr<gl::GpuMesh> gpuMesh_;
    GeometryBuffer geometry_;
};

TEST_P(LookUpMaps, AreWithinWhatThePlanStates)
{
    double worst = 0.0;
    for (const LookUp lookUp : kRecombined)
        for (const Form& form : {formPqp(16, 0.5), formPqpr(16, 0.5, 16), otherDirections()}) {
            // Discs of gamma 1 are parabolic maps.
            if (lookUp == LookUp::parabolic && form.name == "other") continue;
            worst = std::max(worst, worstShare(*renderer_, lobes(form), {lookUp, 64}, *gpuMesh_));
        }
    EXPECT_GT(worst, 0.2) << "a bound that nothing comes near says nothing";
}

TEST_P(LookUpMaps, AreWithinItWithTexelsOfEveryKind)
{
    for (int kind = 0; kind < 3; ++kind) {
        gl::RendererOptions options = rendererOptions();
        options.capabilities = renderer_->capabilities();
        options.capabilities->softwareSampling = false;  // 16 bits over the range
        options.capabilities->unorm16Textures = kind != 1;
        if (kind == 2) options.capabilities->seamlessCubes = false;
        gl::Renderer renderer(options);
        const auto mesh = renderer.createMesh(mesh_);
        for (const LookUp lookUp : kRecombined)
            worstShare(renderer, lobes(formPqp(16, 1.0)), {lookUp, 32}, *mesh, {Technique::single});
    }
}

TEST_P(LookUpMaps, AreWithinItInEveryVersionOfShaders)
{
    for (const int glsl : {120, 140, 150, 330, 450}) {
        if (glsl > renderer_->capabilities().glsl) continue;
        gl::RendererOptions options = rendererOptions();
        options.capabilities = renderer_->capabilities();
        options.capabilities->glsl = glsl;
        gl::Renderer renderer(options);
        const auto mesh = renderer.createMesh(mesh_);
        worstShare(renderer, lobes(formPqpr(16, 0.5, 16)), {LookUp::cube, 32}, *mesh,
                   {Technique::twoLookup});
    }
}

TEST_P(LookUpMaps, OfAParabolicTableAreThatTable)
{
    const auto gpu = renderer_->createMaterial(lobes(formPqp(16, 1.0)), {LookUp::parabolic});
    EXPECT_EQ(gpu->lookUpError(), 0.0);
    EXPECT_EQ(gpu->whyNotRecombined(), "");
}

TEST_P(LookUpMaps, StayNativeWhereTheyCannotBeAndSayWhy)
{
    for (const Material& material :
         {noiseMaterial(formHdio({8, 4, 4}), Storage::log8), waterlooMaterial()}) {
        log.clear();
        const auto gpu = renderer_->createMaterial(material, {LookUp::cube});
        EXPECT_NE(gpu->whyNotRecombined(), "");
        EXPECT_EQ(gpu->lookUpError(), 0.0);
        ASSERT_EQ(log.size(), 1u);
        EXPECT_NE(log[0].find("no cube maps"), std::string::npos) << log[0];
        const auto native = renderer_->createMaterial(material);
        const auto draw = [&](const gl::GpuMaterial& m) {
            return drawItems(*renderer_, kSize, perspectiveView(), {{&m, gpuMesh_.get()}},
                             testLights(3));
        };
        EXPECT_EQ(draw(*gpu).pixels, draw(*native).pixels);
    }
}

TEST_P(LookUpMaps, OfALibraryAreApart)
{
    const Material material = lobes(formPqp(16, 1.0));
    const auto library = renderer_->createLibrary({material, material}, {LookUp::cube, 16});
    EXPECT_NE(library->whyNotPacked().find("cube maps"), std::string::npos);
    Offscreen offscreen = makeOffscreen(kSize);
    const auto stats = renderer_->drawBatch(
        {offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
        {library.get(), gpuMesh_.get(), {{glm::mat4(1.0f), 0}, {glm::mat4(1.0f), 1}}},
        testLights(2));
    EXPECT_EQ(stats.itemsFailed, 0);
    EXPECT_EQ(stats.drawCalls, 2);
}

TEST_P(LookUpMaps, TooLargeAreRefused)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = renderer_->capabilities();
    options.capabilities->maxCubeSize = 32;
    gl::Renderer renderer(options);
    const Material material = lobes(formPqp(16, 1.0));
    expectError(ErrorKind::gl, "64 texels", [&] {
        renderer.createMaterial(material, {LookUp::cube, 64});
    });
    expectError(ErrorKind::usage, "even number", [&] {
        renderer.createMaterial(material, {LookUp::cube, 33});
    });
    renderer.createMaterial(material, {LookUp::cube, 32});
}

INSTANTIATE_TEST_SUITE_P(Backends, LookUpMaps, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
