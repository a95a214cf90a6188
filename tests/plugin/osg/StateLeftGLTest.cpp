// A host that draws in the same context finds OpenGL's state after a frame with the effect as it is
// after a frame with an ordinary geometry instead.
#include "ContextState.h"
#include "EffectTest.h"
#include "EnvironmentTest.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/Texture2D>

#include <iterator>

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

using Extensions = const osg::GLExtensions&;

/// Leaves something behind when the second frame is drawn, which is the last: no draw call comes
/// after it, as what some leaks leave must not be drawn with. An enabled array without memory, for
/// one, may end the program.
class Leak : public osg::Drawable::DrawCallback {
public:
    explicit Leak(void (*leak)(Extensions)) : leak_(leak) {}
    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override
    {
        drawable->drawImplementation(info);
        if (++frames_ == 2) leak_(*info.getState()->get<osg::GLExtensions>());
    }

private:
    void (*leak_)(Extensions);
    mutable int frames_ = 0;
};

/// Something that a guest may leave behind, and what undoes it.
struct Leaking {
    void (*leak)(Extensions);
    void (*undo)(Extensions);
};

const Leaking kLeaks[] = {
    {[](Extensions) { glEnable(GL_SCISSOR_TEST); }, [](Extensions) { glDisable(GL_SCISSOR_TEST); }},
    {[](Extensions) { glPixelStorei(GL_UNPACK_ALIGNMENT, 2); },
     [](Extensions) { glPixelStorei(GL_UNPACK_ALIGNMENT, 1); }},
    {[](Extensions) { glLogicOp(GL_XOR); }, [](Extensions) { glLogicOp(GL_COPY); }},
    {[](Extensions) { glLineWidth(3.0f); }, [](Extensions) { glLineWidth(1.0f); }},
    {[](Extensions gl) {
         GLuint name = 0;
         gl.glGenBuffers(1, &name);
         gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, name);
     },
     [](Extensions gl) {
         GLint name = 0;
         glGetIntegerv(GL_ARRAY_BUFFER_BINDING_ARB, &name);
         const auto buffer = static_cast<GLuint>(name);
         gl.glDeleteBuffers(1, &buffer);
     }},
    {[](Extensions gl) { gl.glEnableVertexAttribArray(7); },
     [](Extensions gl) { gl.glDisableVertexAttribArray(7); }},
    {[](Extensions gl) {
         gl.glActiveTexture(GL_TEXTURE3);
         GLuint name = 0;
         glGenTextures(1, &name);
         glBindTexture(GL_TEXTURE_3D, name);
         gl.glActiveTexture(GL_TEXTURE0);
     },
     [](Extensions gl) {
         gl.glActiveTexture(GL_TEXTURE3);
         GLint name = 0;
         glGetIntegerv(GL_TEXTURE_BINDING_3D, &name);
         const auto texture = static_cast<GLuint>(name);
         glDeleteTextures(1, &texture);
         gl.glActiveTexture(GL_TEXTURE0);
     }}};

TEST_F(StateLeft, ALeakIsSeen)
{
    const auto expected = stateAfterGeometry();
    for (size_t i = 0; i < std::size(kLeaks); ++i) {
        mesh_->setDrawCallback(new Leak(kLeaks[i].leak));
        EXPECT_NE(changes(expected, stateAfterGeometry()), "") << "leak " << i;
        mesh_->setDrawCallback(nullptr);
        const unsigned int id =
            view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
        kLeaks[i].undo(*osg::GLExtensions::Get(id, true));
        EXPECT_EQ(changes(expected, stateAfterGeometry()), "") << "after leak " << i;
    }
}

}  // namespace
}  // namespace fbrdf::test
