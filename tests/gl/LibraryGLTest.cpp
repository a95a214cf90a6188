// Many materials in one draw call are compared with a draw call for each object.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "support/ExpectError.h"
#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <limits>

namespace fbrdf::test {
namespace {

constexpr int kSize = 96;
constexpr int kColumns = 25;
// The arithmetic is equal, but compilers may order the products of two programs differently.
constexpr double kRounding = 1e-5;
// Textures of UNORM16 texels may be filtered with other rounding than arrays of them.
constexpr double kFiltering = 1e-3;

std::vector<Material> noiseMaterials(const Form& form, Storage storage, int count)
{
    std::vector<Material> materials;
    for (int i = 0; i < count; ++i)
        materials.push_back(noiseMaterial(form, storage, static_cast<unsigned>(i + 1)));
    return materials;
}

/// Small turned objects in rows, some stretched, one of each material in turn.
std::vector<gl::Instance> rows(int count, int materials)
{
    std::vector<gl::Instance> instances;
    const float step = 2.2f / kColumns;
    for (int i = 0; i < count; ++i) {
        const Vec3f place(-1.05f + step * static_cast<float>(i % kColumns),
                          -1.0f + step * static_cast<float>(i / kColumns), 0.0f);
        const float turn = 0.3f * static_cast<float>(i);
        const Vec3f scale(0.06f, i % 3 == 0 ? 0.04f : 0.06f, 0.06f);
        glm::mat4 model = glm::translate(glm::mat4(1.0f), place);
        model = glm::rotate(model, turn, Vec3f(0.0f, 0.0f, 1.0f));
        instances.push_back({glm::scale(model, scale), i % materials});
    }
    return instances;
}

class Library : public GlTest {
protected:
    bool packs() const { return !GetParam().legacy; }

    Drawn drawBatch(gl::Renderer& renderer, const gl::GpuLibrary& library, const gl::GpuMesh& mesh,
                    const std::vector<gl::Instance>& instances, const gl::DrawOptions& options = {},
                    int lights = 3)
    {
        Offscreen offscreen = makeOffscreen(kSize);
        Drawn drawn;
        drawn.stats =
            renderer.drawBatch({offscreen.framebuffer(), kSize, kSize}, orthographicView(),
                               {&library, &mesh, instances}, testLights(lights), options);
        drawn.pixels = offscreen.readPixels();
        return drawn;
    }

    Drawn drawApart(gl::Renderer& renderer, const std::vector<Material>& materials,
                    const gl::GpuMesh& mesh, const std::vector<gl::Instance>& instances,
                    int lights = 3, const gl::MaterialOptions& options = {})
    {
        std::vector<std::shared_ptr<gl::GpuMaterial>> made;
        for (const Material& material : materials)
            made.push_back(renderer.createMaterial(material, options));
        std::vector<gl::Item> items;
        for (const gl::Instance& i : instances)
            items.push_back({made[static_cast<size_t>(i.material)].get(), &mesh, i.model});
        return drawItems(renderer, kSize, orthographicView(), items, testLights(lights));
    }

    static void expectEqual(const Drawn& a, const Drawn& b, double most, const std::string& what)
    {
        const auto difference = compareImages(a.pixels, b.pixels);
        EXPECT_TRUE(difference.comparable) << what;
        EXPECT_LE(difference.maxRelative, most) << what << ": " << describe(difference);
    }
};

TEST_P(Library, FiveHundredMaterialsDrawInOneCall)
{
    constexpr int kMaterials = 500;
    gl::Renderer renderer = makeRenderer();
    const auto mesh = renderer.createMesh(sphereMesh(6));
    const auto materials = noiseMaterials(formPqp(8, 0.5), Storage::log8, kMaterials);
    const auto library = renderer.createLibrary(materials);
    const auto instances = rows(kMaterials, kMaterials);
    const Drawn one = drawBatch(renderer, *library, *mesh, instances),
                many = drawApart(renderer, materials, *mesh, instances);
    EXPECT_EQ(many.stats.drawCalls, kMaterials);
    EXPECT_EQ(one.stats.drawCalls, packs() ? 1 : kMaterials);
    EXPECT_EQ(one.stats.itemsFailed, 0);
    EXPECT_EQ(library->whyNotPacked().empty(), packs()) << library->whyNotPacked();
    EXPECT_EQ(log.empty(), packs());
    expectEqual(one, many, kRounding, "500 materials");
}

TEST_P(Library, EveryFormAndTechniqueDrawsWhatSeparateMaterialsDraw)
{
    gl::Renderer renderer = makeRenderer();
    // Techniques round places between texels differently, which coarse filters step over.
    const gl::MaterialOptions exact = exactOptions(renderer);
    const auto mesh = renderer.createMesh(sphereMesh(6));
    for (const Material& one : testMaterials()) {
        std::vector<Material> materials(4, one);
        for (size_t i = 0; i < materials.size(); ++i) {
            materials[i].scales[0] *= 1.0f + static_cast<float>(i);
            for (float& texel : materials[i].tables.back().texels)
                texel *= 1.0f - 0.2f * static_cast<float>(i);
        }
        const auto library = renderer.createLibrary(materials, exact);
        const auto instances = rows(40, 4);
        const Drawn apart = drawApart(renderer, materials, *mesh, instances, 9, exact);
        for (const Technique technique : allTechniques()) {
            gl::DrawOptions options;
            options.technique = technique;
            options.lightsPerPass = 4;
            expectEqual(drawBatch(renderer, *library, *mesh, instances, options, 9), apart, 1e-4,
                        one.name + std::string(" ") + techniqueName(technique));
        }
        gl::DrawOptions lists;
        lists.clustered = true;
        expectEqual(drawBatch(renderer, *library, *mesh, instances, lists, 9), apart, 1e-4,
                    one.name + " in lists");
    }
}

TEST_P(Library, IntegerTexelsKeepTheirRanges)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->softwareSampling = false;
    gl::Renderer renderer(options);
    const auto mesh = renderer.createMesh(sphereMesh(6));
    std::vector<Material> materials;
    for (const Storage storage : {Storage::log8, Storage::linear8, Storage::half})
        for (unsigned seed = 1; seed < 4; ++seed)
            materials.push_back(noiseMaterial(formPqpr(8, 0.5, 6), storage, seed));
    const auto library = renderer.createLibrary(materials);
    const auto instances = rows(90, 9);
    const Drawn one = drawBatch(renderer, *library, *mesh, instances);
    EXPECT_EQ(one.stats.drawCalls, packs() ? 3 : 90) << "a call for each layout";
    expectEqual(one, drawApart(renderer, materials, *mesh, instances), kFiltering, "ranges");
}

TEST_P(Library, VolumesAreDrawnOneByOneWithAReason)
{
    gl::Renderer renderer = makeRenderer();
    const auto mesh = renderer.createMesh(sphereMesh(6));
    const auto library = renderer.createLibrary({everythingMaterial(), everythingMaterial()});
    EXPECT_NE(library->whyNotPacked().find(packs() ? "three dimensions" : "OpenGL 3.1"),
              std::string::npos);
    EXPECT_EQ(drawBatch(renderer, *library, *mesh, rows(10, 2)).stats.drawCalls, 10);
    EXPECT_EQ(log.size(), 1u);
}

TEST_P(Library, FewLayersOrTexelsMakeMoreGroups)
{
    if (!packs()) GTEST_SKIP() << "arrays need OpenGL 3.1";
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->maxArrayLayers = 4;
    gl::Renderer renderer(options);
    const auto mesh = renderer.createMesh(sphereMesh(6));
    const auto materials = noiseMaterials(formPqp(8, 0.5), Storage::half, 10);
    const auto library = renderer.createLibrary(materials);
    const auto instances = rows(30, 10);
    const Drawn three = drawBatch(renderer, *library, *mesh, instances);
    EXPECT_EQ(three.stats.drawCalls, 3);
    expectEqual(three, drawApart(renderer, materials, *mesh, instances), kRounding, "groups");
}

TEST_P(Library, AMaterialIsReplacedByOneOfAnyLayout)
{
    gl::Renderer renderer = makeRenderer();
    const auto mesh = renderer.createMesh(sphereMesh(6));
    auto materials = noiseMaterials(formPqp(8, 0.5), Storage::half, 3);
    const auto library = renderer.createLibrary(materials);
    const auto instances = rows(30, 3);
    const std::vector<Material> next = {noiseMaterial(formPqp(8, 0.5), Storage::half, 77),
                                        noiseMaterial(formPqp(12, 0.5), Storage::half, 78),
                                        noiseMaterial(formPqp(8, 0.5), Storage::half, 79),
                                        everythingMaterial()};
    for (const Material& material : next) {
        materials[1] = material;
        renderer.replaceMaterial(*library, 1, material);
        expectEqual(drawBatch(renderer, *library, *mesh, instances),
                    drawApart(renderer, materials, *mesh, instances), kRounding, material.name);
    }
}

TEST_P(Library, WhatIsRefusedLeavesTheLibraryAsItIs)
{
    gl::Renderer renderer = makeRenderer(), other = makeRenderer();
    const auto mesh = renderer.createMesh(sphereMesh(6));
    auto materials = noiseMaterials(formPqp(8, 0.5), Storage::half, 3);
    const auto library = renderer.createLibrary(materials);
    const auto instances = rows(30, 3);
    const Drawn before = drawBatch(renderer, *library, *mesh, instances);
    Material broken = materials[0];
    broken.tables[0].texels[5] = std::numeric_limits<float>::quiet_NaN();
    expectError(ErrorKind::input, "material 1 of a library",
                [&] { renderer.replaceMaterial(*library, 1, broken); });
    expectError(ErrorKind::input, "material 2 of a library", [&] {
        renderer.createLibrary({materials[0], materials[1], broken});
    });
    for (const int index : {-1, 3})
        expectError(ErrorKind::usage, "expected one of 3",
                    [&] { renderer.replaceMaterial(*library, index, materials[0]); });
    expectError(ErrorKind::usage, "another renderer",
                [&] { other.replaceMaterial(*library, 0, materials[0]); });
    EXPECT_EQ(drawBatch(renderer, *library, *mesh, instances).pixels, before.pixels);
}

TEST_P(Library, ObjectsThatCannotBeDrawnAreLeftOutAndCounted)
{
    gl::Renderer renderer = makeRenderer();
    const auto mesh = renderer.createMesh(sphereMesh(6));
    const auto library = renderer.createLibrary(noiseMaterials(formPqp(8, 0.5), Storage::half, 3));
    auto instances = rows(30, 3);
    const Drawn before = drawBatch(renderer, *library, *mesh, instances);
    instances.push_back({glm::mat4(1.0f), 3});
    instances.push_back({glm::mat4(1.0f), -1});
    instances.push_back({glm::mat4(0.0f), 0});
    const Drawn after = drawBatch(renderer, *library, *mesh, instances);
    EXPECT_EQ(after.stats.itemsFailed, 3);
    EXPECT_EQ(after.pixels, before.pixels);
    EXPECT_EQ(drawBatch(renderer, *library, *mesh, {}).stats.drawCalls, 0);
    expectError(ErrorKind::usage, "expected a library and a mesh", [&] {
        Offscreen offscreen = makeOffscreen(kSize);
        renderer.drawBatch({offscreen.framebuffer(), kSize, kSize}, orthographicView(), {}, {});
    });
}

TEST_P(Library, NothingIsLeftBehind)
{
    Hooks hooks(context().loader());
    {
        gl::Renderer renderer(hooked(hooks));
        const auto mesh = renderer.createMesh(sphereMesh(6));
        const auto library =
            renderer.createLibrary(noiseMaterials(formPqp(8, 0.5), Storage::half, 3));
        drawBatch(renderer, *library, *mesh, rows(30, 3));
        const int made = hooks.made;
        drawBatch(renderer, *library, *mesh, rows(20, 3));
        EXPECT_EQ(hooks.made, made);
    }
    EXPECT_GT(hooks.made, 0);
    EXPECT_EQ(hooks.made, hooks.deleted);
}

INSTANTIATE_TEST_SUITE_P(Backends, Library, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
