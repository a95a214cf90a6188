// A host that draws in the same context finds OpenGL's state after a frame with the effect as it is
// after a frame with an ordinary geometry instead.
#include "ContextState.h"
#include "EffectTest.h"
#include "EnvironmentTest.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/Texture2D>

#include <functional>

namespace fbrdf::test {
namespace {

// No effect uses as many here.
constexpr unsigned int kHostUnits = 6;

class StateLeft : public EffectTest {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        mesh_ = osgMesh(sphereMesh(24));
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE);
        for (unsigned int unit = 0; unit < kHostUnits; ++unit)
            host_->setTextureAttributeAndModes(unit, new osg::Texture2D(image));
    }

    /// The state after two frames, of which the first makes objects. OSG leaves the highest unit
    /// that had a texture active, and the alignment of the last image that was loaded; the host's
    /// own texture decides both here.
    ContextState stateAfter(osg::Node* node, const osgFbrdf::FactorizedBrdf* effect = nullptr)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->setStateSet(host_);
        root->addChild(node);
        root->addChild(osgLights(testLights(9)));
        view_->setScene(root);
        for (int frame = 0; frame < 2; ++frame) view_->draw();
        EXPECT_EQ(effect ? effect->lastReport().reason : "", "");
        return contextState(context().loader());
    }
    ContextState stateAfterGeometry() { return stateAfter(mesh_); }

    osg::ref_ptr<osg::Geometry> mesh_;
    osg::ref_ptr<osg::StateSet> host_ = new osg::StateSet;
};

TEST_F(StateLeft, IsThatOfAnOrdinaryGeometry)
{
    const auto expected = stateAfterGeometry();
    const std::vector<std::pair<bool, Transfer>> outputs{
        {true, Transfer::linear}, {false, Transfer::linear}, {false, Transfer::srgb}};
    for (const size_t kind : {size_t(0), size_t(4)})  // a product and a sum
        for (const auto& [floatTarget, transfer] : outputs)
            for (int technique = 0; technique <= osgFbrdf::kDiffuseFallback; ++technique) {
                const osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
                effect->setMaterial(new osgFbrdf::MaterialObject(testMaterials()[kind]));
                effect->setFloatTarget(floatTarget);
                effect->setTransfer(transfer);
                effect->selectTechnique(technique);
                effect->addChild(mesh_);
                EXPECT_EQ(changes(expected, stateAfter(effect, effect)), "")
                    << testMaterials()[kind].name << ", technique " << technique << ", "
                    << floatTarget << ", transfer " << static_cast<int>(transfer);
            }
    EXPECT_EQ(changes(expected, stateAfterGeometry()), "");
}

/// Without what OSG leaves of any cube map: it stays bound to its unit where a 2D texture takes the
/// place, and the alignment of its image stays.
ContextState withoutCubes(ContextState state)
{
    const std::string cubes = std::to_string(0x8514);  // GL_TEXTURE_BINDING_CUBE_MAP
    for (auto at = state.begin(); at != state.end();)
        at = at->first.find(cubes) != std::string::npos || at->first == "GL_UNPACK_ALIGNMENT"
                 ? state.erase(at)
                 : std::next(at);
    return state;
}

// The frame that makes the cube map of an environment draws and reads in the same context.
TEST_F(StateLeft, IsThatOfAnOrdinaryGeometryUnderAnEnvironment)
{
    const auto expected = withoutCubes(stateAfterGeometry());
    for (int technique = 0; technique <= osgFbrdf::kDiffuseFallback; ++technique) {
        const auto effect =
            osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(4));
        effect->setChild(0, mesh_);
        effect->selectTechnique(technique);
        const osg::ref_ptr<osg::Group> lit = new osg::Group;
        lit->addChild(effect);
        lit->addChild(osgEnvironment(testPanorama(16)));
        EXPECT_EQ(changes(expected, withoutCubes(stateAfter(lit, effect))), "")
            << "technique " << technique;
        EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
    }
    EXPECT_EQ(changes(expected, withoutCubes(stateAfterGeometry())), "");
}

/// Binds a framebuffer to read from, as a host does that copies pictures.
class ReadsFrom : public osg::Camera::DrawCallback {
public:
    explicit ReadsFrom(GLuint framebuffer) : framebuffer_(framebuffer) {}
    void operator()(osg::RenderInfo& info) const override
    {
        info.getState()->get<osg::GLExtensions>()->glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT,
                                                                     framebuffer_);
    }

private:
    GLuint framebuffer_;
};

TEST_F(StateLeft, ReadsFromWhereTheHostDid)
{
    view_->draw();
    const unsigned int id =
        view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    if (!osg::isGLExtensionOrVersionSupported(id, "GL_EXT_framebuffer_blit", 3.0f))
        GTEST_SKIP() << "needs framebuffers that are read apart from the one drawn to";
    const Offscreen source(context().loader(), {kSize, kSize, OffscreenFormat::rgba8, true});
    view_->viewer().getCamera()->setPreDrawCallback(new ReadsFrom(source.framebuffer()));
    const auto expected = stateAfterGeometry();
    EXPECT_EQ(expected.at("GL_READ_FRAMEBUFFER_BINDING").at(0), source.framebuffer());
    const auto effect = osgEffect(testMaterials()[4], sphereMesh(24));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const auto found = stateAfter(effect, effect);
    for (const char* name : {"GL_READ_FRAMEBUFFER_BINDING", "GL_DRAW_FRAMEBUFFER_BINDING"})
        EXPECT_EQ(found.at(name), expected.at(name)) << name;
}

/// Leaves something behind.
class Leak : public osg::Drawable::DrawCallback {
public:
    explicit Leak(std::function<void(const osg::GLExtensions&)> leak) : leak_(std::move(leak)) {}
    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override
    {
        drawable->drawImplementation(info);
        leak_(*info.getState()->get<osg::GLExtensions>());
    }

private:
    std::function<void(const osg::GLExtensions&)> leak_;
};

TEST_F(StateLeft, ALeakIsSeen)
{
    using Extensions = const osg::GLExtensions&;
    const std::vector<std::function<void(Extensions)>> leaks{
        [](Extensions) { glEnable(GL_SCISSOR_TEST); },
        [](Extensions) { glPixelStorei(GL_UNPACK_ALIGNMENT, 2); },
        [](Extensions) { glLogicOp(GL_XOR); },
        [](Extensions) { glLineWidth(3.0f); },
        [](Extensions gl) { gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 4000); },
        [](Extensions gl) { gl.glEnableVertexAttribArray(7); },
        [](Extensions gl) {
            gl.glActiveTexture(GL_TEXTURE3);
            glBindTexture(GL_TEXTURE_3D, 4000);
            gl.glActiveTexture(GL_TEXTURE0);
        }};
    for (size_t i = 0; i < leaks.size(); ++i) {
        const auto expected = stateAfterGeometry();
        mesh_->setDrawCallback(new Leak(leaks[i]));
        EXPECT_NE(changes(expected, stateAfterGeometry()), "") << "leak " << i;
        mesh_->setDrawCallback(nullptr);
    }
}

}  // namespace
}  // namespace fbrdf::test
