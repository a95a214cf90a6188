// Contexts that lack what the techniques need draw what they can, and the report has the reason.
#include "AreaLightsTest.h"
#include "EffectTest.h"
#include "EnvironmentTest.h"

#include <fbrdf/base/Error.h>

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <dlfcn.h>

#include <cstdlib>

namespace {

// OpenGL 3.0 defines these, and headers of OpenGL 2 lack them.
constexpr GLenum kReadBinding = 0x8CAA;
int readBindingAsked = 0;

}  // namespace

// The executable's functions come before libGL's, so the plugin's queries arrive here first.
extern "C" void glGetIntegerv(GLenum name, GLint* value)
{
    using Function = void (*)(GLenum, GLint*);
    static const auto kReal = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glGetIntegerv"));
    readBindingAsked += name == kReadBinding ? 1 : 0;
    kReal(name, value);
}

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

class LimitedContext : public EffectTest {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        if (view_) disabled_ = osg::getGLExtensionDisableString();
    }
    /// OSG keeps what it knows by the number of the context, and the next context has it again.
    void TearDown() override
    {
        if (!view_) return;
        osg::setGLExtensionDisableString(disabled_);
        osg::GLExtensions::Set(contextId(), nullptr);
        EffectTest::TearDown();
    }

    /// A sphere that needs surfaces, unless it is drawn in a single pass.
    osg::ref_ptr<FactorizedBrdf> effectWithSurfaces(int technique)
    {
        const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
        effect->setFloatTarget(false);
        effect->selectTechnique(technique);
        scene(effect, osgLights(testLights(9)));
        return effect;
    }
    unsigned int contextId()
    {
        return view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    }
    /// What OSG knows of the context; a test takes away here what the context is to lack.
    osg::GLExtensions& known()
    {
        view_->draw();
        return *osg::GLExtensions::Get(contextId(), true);
    }
    void expectFallback(FactorizedBrdf& effect, const std::string& words)
    {
        const Notices notices;
        effect.setLightsPerPass(5);  // asks the context anew
        for (int frame = 0; frame < 2; ++frame) view_->draw();
        EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
        EXPECT_EQ(effect.lastReport().technique, "diffuse fallback");
        EXPECT_NE(effect.lastReport().reason.find(words), std::string::npos)
            << effect.lastReport().reason;
        EXPECT_NE(notices.text().find(words), std::string::npos) << notices.text();
    }

private:
    std::string disabled_;
};

using LimitedDriver = OsgTest;
using PoorDriver = EffectTest;

GLenum GL_APIENTRY unsupported(GLenum)
{
    return GL_FRAMEBUFFER_UNSUPPORTED_EXT;
}

// Only drawing shows it, so that frame is lost and the next one has the fallback.
TEST_F(LimitedContext, WithoutFloatTargetsHasTheFallbackInTheNextFrame)
{
    view_->draw();
    known().glCheckFramebufferStatus = unsupported;
    const auto effect = effectWithSurfaces(osgFbrdf::kTwoLookups);
    const Notices notices;
    view_->draw();
    EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_NE(notices.text().find("no RGBA32F surface"), std::string::npos) << notices.text();
}

TEST_F(LimitedContext, WithoutFloatTargetsHasASinglePass)
{
    const auto effect = effectWithSurfaces(osgFX::Effect::AUTO_DETECT);
    known().glCheckFramebufferStatus = unsupported;
    effect->setLightsPerPass(5);
    const Notices notices;
    for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
        effect->setTransfer(transfer);
        for (int frame = 0; frame < 3; ++frame) view_->draw();
        EXPECT_EQ(effect->lastReport().technique, "single pass");
        EXPECT_EQ(notices.text(), "");
    }
    effect->setTransfer(Transfer::linear);
    const auto d = compareImages(view_->frame(),
                                 runtimeImage(testMaterials()[0], sphereMesh(24), testLights(9)));
    EXPECT_LT(d.maxRelative, 1e-4) << describe(d);
}

TEST_F(LimitedContext, WithoutFramebufferObjectsHasTheFallbackWhereSurfacesAreNeeded)
{
    const auto effect = effectWithSurfaces(osgFbrdf::kTwoLookups);
    known().isFrameBufferObjectSupported = false;
    view_->offscreen().clear();
    expectFallback(*effect, "no RGBA32F surface");
}

TEST_F(LimitedContext, WithoutFloatTexturesHasTheFallback)
{
    const auto effect = effectWithSurfaces(osgFX::Effect::AUTO_DETECT);
    auto& extensions = known();
    extensions.glVersion = 2.1f;
    osg::setGLExtensionDisableString("GL_ARB_texture_float");
    expectFallback(*effect, "no float textures");
}

// With glvnd every function exists, but a query is an error where the driver does not know it.
TEST_F(LimitedContext, WithoutBlitsIsNotAskedWhatReadsApart)
{
    const auto effect = effectWithSurfaces(osgFbrdf::kTwoLookups);
    const auto expected = view_->frame();
    const bool is30 = known().glVersion >= 3.0f;
    readBindingAsked = 0;
    view_->draw();
    EXPECT_EQ(readBindingAsked > 0, is30);
    known().glVersion = 2.1f;
    osg::setGLExtensionDisableString("GL_EXT_framebuffer_blit GL_ARB_framebuffer_object");
    readBindingAsked = 0;
    EXPECT_EQ(view_->frame(), expected);
    EXPECT_EQ(readBindingAsked, 0);
    EXPECT_EQ(effect->lastReport().reason, "");
}

// Here Mesa itself has neither textures nor framebuffers of RGBA32F.
TEST_F(LimitedDriver, WithoutFloatTexturesHasTheFallback)
{
    const char* missing = std::getenv("MESA_EXTENSION_OVERRIDE");
    if (!missing || std::string(missing).find("-GL_ARB_texture_float") == std::string::npos)
        GTEST_SKIP() << "needs a driver without float textures: see osg_as_no_floats";
    EXPECT_THROW(OsgView(context().loader(), OffscreenFormat::rgba32f), Error);
    OsgView view(context().loader(), OffscreenFormat::rgba8);
    view.setView(perspectiveView());
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->setFloatTarget(false);
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect);
    root->addChild(osgLights(testLights(9)));
    view.setScene(root);
    const Notices notices;
    for (int frame = 0; frame < 2; ++frame) EXPECT_GT(meanOf(view.frame(), 3), 0.3);
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_NE(notices.text().find("no float textures"), std::string::npos) << notices.text();
    // Nor can it have the cube map of an environment.
    const double dark = meanOf(view.frame(), 0);
    root->addChild(osgEnvironment(testPanorama(8)));
    for (int frame = 0; frame < 2; ++frame) EXPECT_GT(meanOf(view.frame(), 0), dark);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

bool lacks(const char* extension)
{
    const char* missing = std::getenv("MESA_EXTENSION_OVERRIDE");
    return missing && std::string(missing).find(extension) != std::string::npos;
}

// Shaders of GLSL 1.20 then cannot say which level of the cube map they want.
TEST_F(PoorDriver, WithoutAChoiceOfLevelsDrawsWithoutTheEnvironment)
{
    if (!lacks("-GL_ARB_shader_texture_lod"))
        GTEST_SKIP() << "needs a driver without a choice of levels: see osg_as_no_levels";
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto effect = osgEffect(material, sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto without = view_->frame();
    root->addChild(osgEnvironment(testPanorama(16)));
    const Notices notices;
    for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(view_->frame(), without);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
    const size_t at =
        notices.text().find("without the environment or area lights: found no choice of levels");
    ASSERT_NE(at, std::string::npos) << notices.text();
    EXPECT_EQ(notices.text().find("without the environment", at + 1), std::string::npos);
    // Area lights need no cube map.
    const auto areaLights = osgAreaLights({areaLightOf(AreaLight::Shape::sphere)});
    root->addChild(areaLights);
    const auto lit = view_->frame();
    EXPECT_GT(meanOf(lit, 0), 1.01 * meanOf(without, 0));
    EXPECT_EQ(effect->lastReport().lightsUsed, 10);
    root->removeChild(2, 1);
    EXPECT_EQ(view_->frame(), lit);
    EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
}

// A cube that is drawn where nothing is filtered across edges would be wrong there.
TEST_F(PoorDriver, WithoutSeamlessCubesTheCpuMakesTheEnvironment)
{
    if (!lacks("-GL_ARB_seamless_cube_map"))
        GTEST_SKIP() << "needs a driver without seamless cubes: see osg_as_no_seamless_cubes";
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto effect = osgEffect(material, sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto without = view_->frame();
    root->addChild(osgEnvironment(testPanorama(16)));
    EXPECT_EQ(view_->frame(), without) << "a black cube";
    for (int i = 0; i < 3000; ++i) {
        view_->draw();
        if (effect->lastReport().whyNoEnvironment.empty()) break;
        EXPECT_NE(effect->lastReport().whyNoEnvironment.find("the CPU prefilters"),
                  std::string::npos);
        OpenThreads::Thread::microSleep(10000);
    }
    EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
    EXPECT_GT(meanOf(view_->frame(), 0), 1.2 * meanOf(without, 0));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// OSG asks for the extensions of shaders where the version is too old to have them.
TEST_F(LimitedContext, OfAVersionBeforeShadersHasTheFallback)
{
    const char* version = std::getenv("MESA_GL_VERSION_OVERRIDE");
    if (!version || std::string(version) != "1.5")
        GTEST_SKIP() << "needs a driver of version 1.5: see osg_as_gl_1.5";
    EXPECT_FALSE(known().isGlslSupported);
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    scene(effect, osgLights(testLights(9)));
    expectFallback(*effect, "no GLSL");
    for (int technique = 0; technique < osgFbrdf::kDiffuseFallback; ++technique) {
        effect->selectTechnique(technique);
        EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
        EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
        EXPECT_NE(effect->lastReport().reason, "");
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace fbrdf::test
