// What nobody needs any more is deleted: programs of materials and hooks that are gone, surfaces of
// targets that are gone or have another size. Counts GL's objects, and bytes of the heap.
#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <malloc.h>

namespace fbrdf::test {
namespace {

constexpr int kSize = 8;

class Eviction : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        hooks_ = std::make_unique<Hooks>(context().loader());
        renderer_ = std::make_unique<gl::Renderer>(hooked(*hooks_));
        mesh_ = renderer_->createMesh(sphereMesh(4));
    }
    void TearDown() override
    {
        mesh_.reset();
        renderer_.reset();
        hooks_.reset();
        GlTest::TearDown();
    }

    int alive(const char* kind) const { return hooks_->alive[kind]; }
    gl::DrawStats draw(const Offscreen& target, const gl::GpuMaterial& material,
                       const gl::GpuHooks* hooks = nullptr, Technique technique = Technique::single)
    {
        return renderer_->draw(
            {target.framebuffer(), target.width(), target.height()}, perspectiveView(),
            {{&material, mesh_.get(), glm::mat4(1.0f), hooks}}, testLights(2), {technique});
    }
    /// Every number of knots needs a program of its own.
    static Material ownProgram(int knots)
    {
        return noiseMaterial(formPqpr(4, 0.5, 2 + knots), Storage::log8);
    }
    static gl::Hooks ownHooks(int number)
    {
        gl::Hooks hooks;
        hooks.shadow = "float fbrdfShadow(int light, vec3 position, vec3 toLight) { return 1.0 / " +
                       std::to_string(number + 1) + ".0; }\n";
        return hooks;
    }
    /// Bytes of the heap in use, once the driver has run all commands.
    size_t heapInUse() const
    {
        gl().Finish();
        return mallinfo2().uordblks;
    }
    Offscreen bytes(int size) { return makeOffscreen(size, OffscreenFormat::rgba8); }

    std::unique_ptr<Hooks> hooks_;
    std::unique_ptr<gl::Renderer> renderer_;
    std::shared_ptr<gl::GpuMesh> mesh_;
};

TEST_P(Eviction, ProgramsOfMaterialsThatAreGoneAreDeleted)
{
    constexpr int kKept = 8;  // ProgramCache::kMostUnused
    const Offscreen target = makeOffscreen(kSize);
    for (int i = 0; i < 2 * kKept; ++i) {
        const auto material = renderer_->createMaterial(ownProgram(i));
        draw(target, *material);
    }
    const auto last = renderer_->createMaterial(ownProgram(0));
    const int programs = alive("Program");
    EXPECT_LE(programs, kKept + 2);
    EXPECT_LE(alive("Shader"), 1);
    for (int i = 0; i < 2 * kKept; ++i) {
        const auto material = renderer_->createMaterial(ownProgram(i));
        draw(target, *material);
    }
    EXPECT_LE(alive("Program"), programs + 2);  // those of the last one, until the next call
}

TEST_P(Eviction, ProgramsOfHooksThatAreGoneAreDeleted)
{
    const Offscreen target = makeOffscreen(kSize);
    const auto material = renderer_->createMaterial(ownProgram(0));
    int programs = 0;
    for (int i = 0; i < 40; ++i) {
        const auto hooks = renderer_->createHooks(ownHooks(i));
        EXPECT_EQ(draw(target, *material, hooks.get()).itemsFailed, 0);
        if (i == 20) programs = alive("Program");
    }
    EXPECT_EQ(alive("Program"), programs);
}

TEST_P(Eviction, ProgramsOfLivingMaterialsStay)
{
    const Offscreen target = makeOffscreen(kSize);
    std::vector<std::shared_ptr<gl::GpuMaterial>> materials;
    for (int i = 0; i < 12; ++i) materials.push_back(renderer_->createMaterial(ownProgram(i)));
    for (const auto& material : materials) draw(target, *material);
    const int made = hooks_->made;
    renderer_->createMaterial(ownProgram(0));
    const int textures = hooks_->made - made;
    for (const auto& material : materials) draw(target, *material);
    EXPECT_EQ(hooks_->made, made + textures);
}

TEST_P(Eviction, ProgramsThatNoDrawUsesAreDeletedBeyondTheLimit)
{
    constexpr int kIdleDraws = 256;  // ProgramCache::kIdleDraws
    const Offscreen target = makeOffscreen(kSize);
    for (const size_t limit : {2u, 256u}) {
        gl::RendererOptions options = hooked(*hooks_);
        options.idlePrograms = limit;
        mesh_.reset();
        renderer_ = std::make_unique<gl::Renderer>(options);
        mesh_ = renderer_->createMesh(sphereMesh(4));
        const auto material = renderer_->createMaterial(ownProgram(1));
        std::vector<std::shared_ptr<gl::GpuHooks>> hooks;
        for (int i = 0; i < 6; ++i) hooks.push_back(renderer_->createHooks(ownHooks(i)));
        for (const auto& hook : hooks) draw(target, *material, hook.get());
        const int made = alive("Program");
        for (int i = 0; i < 2 * kIdleDraws; ++i) draw(target, *material, hooks[5].get());
        EXPECT_EQ(alive("Program"), limit == 2 ? 3 : made) << "the one that is used, and two";
        EXPECT_EQ(draw(target, *material, hooks[0].get()).itemsFailed, 0) << "it is built again";
        EXPECT_EQ(alive("Program"), limit == 2 ? 4 : made);
    }
}

TEST_P(Eviction, AMaterialReleasedBeforeTheNextOfItsFormNeedsNoCompiler)
{
    const Offscreen target = makeOffscreen(kSize);
    auto material = renderer_->createMaterial(ownProgram(0));
    draw(target, *material);
    material.reset();
    draw(target, *renderer_->createMaterial(ownProgram(1)));
    hooks_->corruptShaders = true;
    material = renderer_->createMaterial(ownProgram(0));
    EXPECT_EQ(draw(target, *material).itemsFailed, 0);
    EXPECT_TRUE(log.empty());
}

// Without light every form is black and needs the same program, whatever tables it has.
TEST_P(Eviction, AProgramMadeForAFormOfMoreTablesDrawsOneOfFewer)
{
    const Offscreen target = makeOffscreen(kSize);
    for (const Material& material :
         {everythingMaterial(), noiseMaterial(formHdio({2, 2, 2}), Storage::log8)}) {
        const auto gpu = renderer_->createMaterial(material);
        const auto stats = renderer_->draw({target.framebuffer(), kSize, kSize}, perspectiveView(),
                                           {{gpu.get(), mesh_.get()}}, {});
        EXPECT_EQ(stats.itemsFailed, 0);
    }
}

// An editor does this all day: it makes a material of new numbers and releases the old one. What a
// reload leaked before programs were evicted, an entry of the cache with its key, was over 100
// bytes.
TEST_P(Eviction, TenThousandReloadsLeaveNothingBehind)
{
    constexpr int kReloads = 10000, kSettled = 1000;
    constexpr size_t kNoise = 64 << 10;  // 8 bytes a reload; llvmpipe was seen to vary by 200 bytes
    const Offscreen target = makeOffscreen(kSize);
    const Material first = noiseMaterial(formHdio({2, 2, 2}), Storage::log8, 1),
                   second = noiseMaterial(formHdio({2, 2, 2}), Storage::log8, 2);
    std::shared_ptr<gl::GpuMaterial> material;
    size_t heap = 0;
    std::map<std::string, int> objects;
    for (int i = 0; i < kReloads; ++i) {
        material = renderer_->createMaterial(i % 2 == 0 ? first : second);
        if (i % 100 == 0) {
            draw(target, *material);
            gl().Finish();  // as a frame ends: the driver's queues grow until then
        }
        if (i != kSettled) continue;
        objects = hooks_->alive;
        heap = heapInUse();
    }
    EXPECT_EQ(hooks_->alive, objects);
    EXPECT_LE(heapInUse(), heap + kNoise);
}

TEST_P(Eviction, ProblemsOfManyMaterialsLeaveABoundedMemory)
{
    constexpr int kMaterials = 3000;
    const Offscreen target = makeOffscreen(kSize);
    gl::MeshData bare = sphereMesh(4);
    bare.tangents.clear();
    const auto mesh = renderer_->createMesh(bare);
    size_t heap = 0;
    for (int i = 0; i < kMaterials; ++i) {
        Material material = ownProgram(0);
        material.name =
            "material of a very long name, so that the memory can be seen " + std::to_string(i);
        const auto gpu = renderer_->createMaterial(material);
        renderer_->draw({target.framebuffer(), kSize, kSize}, perspectiveView(),
                        {{gpu.get(), mesh.get()}}, testLights(1));
        // As a frame ends: where its threads fall behind, llvmpipe keeps another 38 MB from then
        // on.
        gl().Finish();
        log.clear();
        if (i == kMaterials / 2) heap = heapInUse();
    }
    EXPECT_LE(heapInUse(), heap + (128 << 10));
}

TEST_P(Eviction, SurfacesOfTargetsThatAreGoneAreDeleted)
{
    const auto material = renderer_->createMaterial(ownProgram(0));
    const auto passes = Technique::twoLookup;
    const Offscreen kept = bytes(8);
    draw(kept, *material, nullptr, passes);
    const auto surfaces = hooks_->alive;
    ASSERT_GE(surfaces.at("Framebuffers"), 3);
    {
        const Offscreen large = bytes(64);
        draw(large, *material, nullptr, passes);
        EXPECT_GT(alive("Framebuffers"), surfaces.at("Framebuffers"));
    }
    draw(makeOffscreen(kSize), *material);  // needs no surface
    for (const char* kind : {"Framebuffers", "Renderbuffers", "Textures"})
        EXPECT_EQ(alive(kind), surfaces.at(kind)) << kind;
}

TEST_P(Eviction, TargetsThatAlternateKeepTheirSurfaces)
{
    const auto material = renderer_->createMaterial(ownProgram(0));
    const Offscreen small = bytes(8), large = bytes(24), twin = bytes(24);
    int made = 0;
    for (int i = 0; i < 3; ++i) {
        for (const Offscreen* target : {&small, &large, &twin})
            draw(*target, *material, nullptr, Technique::twoLookup);
        if (i == 0) made = hooks_->made;
    }
    EXPECT_EQ(hooks_->made, made);
    EXPECT_EQ(alive("Renderbuffers"), 2);  // a depth buffer for each size
}

TEST_P(Eviction, ATargetOfAnotherSizeLeavesNoSurfacesOfTheFormerOne)
{
    const auto material = renderer_->createMaterial(ownProgram(0));
    const Offscreen target = bytes(32);
    for (const int size : {32, 16, 24, 32})
        renderer_->draw({target.framebuffer(), size, size}, perspectiveView(),
                        {{material.get(), mesh_.get()}}, testLights(2), {Technique::twoLookup});
    EXPECT_EQ(alive("Renderbuffers"), 1);
    EXPECT_EQ(alive("Framebuffers"), 3);
}

// What is deleted depends on the renderer alone, and compiling takes long: one backend suffices.
INSTANTIATE_TEST_SUITE_P(Backends, Eviction, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
