// Passes add up in halves or in scaled bytes where that is asked for, or where a context has
// nothing finer, and the picture is what the runtime draws with such sums.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// Inputs that differ by an ulp of a float may be rounded to neighbouring halves.
constexpr double kHalfStep = 2e-3;
// Bounds that differ by an ulp change the scale of a sum, and with it the code of every pixel: what
// both lose is compared.
constexpr double kCode = 1.0 / 255.0;

struct Apart {
    double most = 0.0, mean = 0.0;
};

Apart apart(const std::vector<float>& a, const std::vector<float>& b)
{
    Apart result;
    for (size_t i = 0; i < a.size(); ++i) {
        const double distance = std::abs(static_cast<double>(a[i] - b[i]));
        result.most = std::max(result.most, distance);
        result.mean += distance / static_cast<double>(a.size());
    }
    return result;
}

/// Lights around the sphere, at about one distance.
std::vector<Light> distantRing(int count, float brightest)
{
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const float turn =
            2.0f * static_cast<float>(kPi) * static_cast<float>(i) / static_cast<float>(count);
        Light light;
        light.position = Vec3f(4.0f * std::cos(turn), 4.0f * std::sin(turn), 8.0f);
        light.intensity = Vec3f(1.0f, 0.9f, 0.8f) * (brightest * 60.0f / static_cast<float>(count));
        lights.push_back(light);
    }
    return lights;
}

/// OSG's own bounds of a sphere are those of the box around it, and peaks depend on them.
struct UnitSphere : public osg::Node::ComputeBoundingSphereCallback {
    osg::BoundingSphere computeBound(const osg::Node&) const override { return {{}, 1.0f}; }
};

class Accumulation : public EffectTest {
protected:
    osg::ref_ptr<FactorizedBrdf> effect(const Material& material, int technique,
                                        ColourFormat accumulation)
    {
        const auto effect = osgEffect(material, sphereMesh(16));
        effect->setComputeBoundingSphereCallback(new UnitSphere);
        effect->setFloatTarget(false);
        effect->selectTechnique(technique);
        effect->setAccumulation(accumulation);
        return effect;
    }

    /// What the effect shows in a target of a format.
    std::vector<float> shown(FactorizedBrdf& effect, const std::vector<Light>& lights,
                             OffscreenFormat format)
    {
        OsgView view(context().loader(), format);
        view.setView(perspectiveView());
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(&effect);
        root->addChild(osgLights(lights));
        view.setScene(root);
        view.frame();
        return view.frame();
    }

    /// What the runtime draws there when it takes RGBA32F, or RGBA16F too, to be missing.
    std::vector<float> runtimes(const Material& material, const std::vector<Light>& lights,
                                OffscreenFormat format, ColourFormat accumulation,
                                const gl::DrawOptions& options, Transfer transfer)
    {
        gl::RendererOptions wanted;
        wanted.load = context().loader();
        wanted.capabilities = gl::Renderer(wanted).capabilities();
        wanted.capabilities->floatTargets = false;
        wanted.capabilities->halfTargets = accumulation == ColourFormat::rgba16f;
        gl::Renderer renderer(wanted);
        const auto gpu = renderer.createMaterial(material);
        const auto mesh = renderer.createMesh(sphereMesh(16));
        Offscreen target(context().loader(), {kSize, kSize, format, true});
        target.clear();
        const auto stats =
            renderer.draw({target.framebuffer(), kSize, kSize, transfer}, perspectiveView(),
                          {{gpu.get(), mesh.get()}}, lights, options);
        EXPECT_EQ(stats.accumulation, colourFormatName(accumulation)) << stats.whyReplaced;
        error_ = stats.error;
        return target.readPixels();
    }

    ErrorBound error_;  ///< of what the runtime drew last
};

TEST_F(Accumulation, InHalvesIsTheRuntimes)
{
    const auto lights = distantRing(5, 0.5f);
    for (const size_t index : {size_t(0), size_t(2), size_t(4)})
        for (const int technique : {int(osgFbrdf::kBatched), int(osgFbrdf::kTwoLookups)}) {
            const Material material = testMaterials()[index];
            const auto effect = this->effect(material, technique, ColourFormat::rgba16f);
            // A curve shows the sum in floats: in a linear target of floats nothing would add up
            // off screen.
            effect->setFloatTarget(true);
            effect->setTransfer(Transfer::srgb);
            effect->setLightsPerPass(2);
            const auto image = shown(*effect, lights, OffscreenFormat::rgba32f);
            EXPECT_EQ(effect->lastReport().accumulation, "RGBA16F");
            EXPECT_EQ(effect->lastReport().reason, "");
            const auto d = compareImages(
                image, runtimes(material, lights, OffscreenFormat::rgba32f, ColourFormat::rgba16f,
                                {static_cast<Technique>(technique), 2}, Transfer::srgb));
            EXPECT_LT(d.maxRelative, kHalfStep) << index << ' ' << technique << describe(d);
            // This tests the test: floats are finer.
            effect->setAccumulation(ColourFormat::rgba32f);
            const auto fine = shown(*effect, lights, OffscreenFormat::rgba32f);
            EXPECT_EQ(effect->lastReport().accumulation, "RGBA32F");
            EXPECT_GT(compareImages(image, fine).meanRelative, 3.0 * d.meanRelative + 1e-5);
        }
}

TEST_F(Accumulation, InScaledBytesIsTheRuntimes)
{
    for (const Form& form : {formPqp(8, 0.5), formPqpr(8, 0.5, 6)})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
            const bool curved = isCurved(transfer);
            const auto lights = distantRing(curved ? 2 : 4, curved ? 0.08f : 0.15f);
            const Material material = calmMaterial(form);
            const auto effect = this->effect(material, osgFbrdf::kTwoLookups, ColourFormat::rgba8);
            effect->setTransfer(transfer);
            // Exposure counts as light does.
            effect->setExposure(2.0f);
            auto half = lights;
            for (Light& light : half) light.intensity *= 0.5f;
            const auto image = shown(*effect, half, OffscreenFormat::rgba8);
            EXPECT_EQ(effect->lastReport().accumulation, "RGBA8");
            EXPECT_EQ(effect->lastReport().reason, "");
            const auto expected = runtimes(material, lights, OffscreenFormat::rgba8,
                                           ColourFormat::rgba8, {Technique::twoLookup}, transfer);
            effect->setAccumulation(ColourFormat::rgba32f);
            const auto exact = shown(*effect, half, OffscreenFormat::rgba8);
            const Apart ours = apart(image, exact), theirs = apart(expected, exact);
            EXPECT_GT(theirs.mean, 0.1 * kCode) << "nothing is lost, so nothing is shown";
            EXPECT_LT(ours.mean, 1.2 * theirs.mean) << form.name;
            EXPECT_LT(ours.most, 1.5 * theirs.most + kCode) << form.name;
            EXPECT_LT(ours.most, error_.absolute + kCode) << form.name;
        }
}

TEST_F(Accumulation, ThatIsTooCoarseIsFiner)
{
    // In steep tables the sum that is possible is far above the one that occurs.
    const Material steep = noiseMaterial(formPqp(8, 0.5), Storage::half);
    const auto bytes = effect(steep, osgFbrdf::kTwoLookups, ColourFormat::rgba8);
    shown(*bytes, distantRing(12, 0.25f), OffscreenFormat::rgba8);
    EXPECT_EQ(bytes->lastReport().technique, "two look-ups per pass");
    EXPECT_EQ(bytes->lastReport().accumulation, "RGBA16F");
    shown(*bytes, distantRing(200, 0.25f), OffscreenFormat::rgba8);
    EXPECT_EQ(bytes->lastReport().accumulation, "RGBA32F");
    EXPECT_EQ(bytes->lastReport().reason, "");
    // Nothing bounds what a light does within the bounds of the object.
    auto lights = distantRing(3, 0.1f);
    const auto calm =
        effect(calmMaterial(formPqp(8, 0.5)), osgFbrdf::kTwoLookups, ColourFormat::rgba8);
    shown(*calm, lights, OffscreenFormat::rgba8);
    EXPECT_EQ(calm->lastReport().accumulation, "RGBA8");
    lights[1].position = Vec3f(0.0f, 0.0f, 0.9f);
    shown(*calm, lights, OffscreenFormat::rgba8);
    EXPECT_EQ(calm->lastReport().accumulation, "RGBA16F");
}

/// As a driver that draws to no surface of RGBA32F.
GLenum GL_APIENTRY withoutFloats(GLenum target)
{
    GLint format = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    (void)target;
    return format == GL_RGBA32F_ARB ? GL_FRAMEBUFFER_UNSUPPORTED_EXT : GL_FRAMEBUFFER_COMPLETE_EXT;
}

TEST_F(Accumulation, IsCoarserWhereThereIsNothingFiner)
{
    view_->draw();
    const unsigned int id =
        view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    osg::GLExtensions::Get(id, true)->glCheckFramebufferStatus = withoutFloats;
    const auto effect =
        this->effect(testMaterials()[0], osgFbrdf::kTwoLookups, ColourFormat::rgba32f);
    const auto root = scene(effect, osgLights(testLights(9)));
    const Notices notices;
    for (int frame = 0; frame < 2; ++frame) view_->draw();
    EXPECT_EQ(effect->lastReport().technique, "two look-ups per pass");
    EXPECT_EQ(effect->lastReport().accumulation, "RGBA16F");
    const auto d = compareImages(view_->frame(),
                                 runtimeImage(testMaterials()[0], sphereMesh(16), testLights(9)));
    EXPECT_LT(d.maxRelative, 2e-2) << describe(d);
    EXPECT_EQ(notices.text(), "");
    osg::GLExtensions::Set(id, nullptr);
}

}  // namespace
}  // namespace fbrdf::test
