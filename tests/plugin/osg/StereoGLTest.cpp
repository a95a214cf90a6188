// OSG's stereo has two cull visitors for one camera, halves of a viewport, colour masks, and a
// stencil that OSG's state does not know of. Each eye must see what a camera at its place sees.
#include "EffectTest.h"
#include "Pictures.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/MatrixTransform>
#include <osg/Shape>
#include <osg/ShapeDrawable>
#include <osgUtil/SceneView>
#include <osgViewer/Renderer>

namespace fbrdf::test {
namespace {

using Mode = osg::DisplaySettings::StereoMode;
using Picture = std::vector<float>;

struct Eye {
    osg::Matrixd view, projection;
};

osg::ref_ptr<osg::Node> at(const osg::Vec3d& place, osg::Node* node)
{
    osg::ref_ptr<osg::MatrixTransform> above =
        new osg::MatrixTransform(osg::Matrixd::translate(place));
    above->addChild(node);
    return above;
}

/// How the effect is drawn: in the target, or by way of surfaces.
struct Way {
    const char* name;
    size_t material;
    int technique;
    bool surfaces;
};

class Stereo : public EffectTest, public ::testing::WithParamInterface<Way> {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        effect_ = osgEffect(testMaterials()[GetParam().material], sphereMesh(24));
        effect_->setFloatTarget(!GetParam().surfaces);
        effect_->setExposure(0.2f);
        if (GetParam().surfaces) effect_->setTransfer(Transfer::toneMap);
        effect_->selectTechnique(GetParam().technique);
        osg::ref_ptr<osg::ShapeDrawable> box = new osg::ShapeDrawable(new osg::Box({}, 1.0f));
        root_->addChild(at({-0.4, 0.0, 0.0}, effect_));
        root_->addChild(at({0.8, 0.2, 0.5}, box));  // before and behind the sphere
        root_->addChild(osgLights(testLights(9)));
        view_->setScene(root_);
        view_->viewer().setLightingMode(osg::View::HEADLIGHT);
        addStencil();
    }

    /// VERTICAL_INTERLACE draws through a stencil.
    void addStencil()
    {
        const auto* state = view_->viewer().getCamera()->getGraphicsContext()->getState();
        const auto* gl = osg::GLExtensions::Get(state->getContextID(), true);
        GLuint buffer = 0;
        gl->glGenRenderbuffers(1, &buffer);
        gl->glBindRenderbuffer(GL_RENDERBUFFER_EXT, buffer);
        gl->glRenderbufferStorage(GL_RENDERBUFFER_EXT, GL_DEPTH24_STENCIL8_EXT, kSize, kSize);
        gl->glBindFramebuffer(GL_FRAMEBUFFER_EXT, view_->offscreen().framebuffer());
        for (const GLenum attachment :
             std::initializer_list<GLenum>{GL_DEPTH_ATTACHMENT_EXT, GL_STENCIL_ATTACHMENT_EXT})
            gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachment, GL_RENDERBUFFER_EXT,
                                          buffer);
        gl->glBindFramebuffer(GL_FRAMEBUFFER_EXT, 0);
        gl->glDeleteRenderbuffers(1, &buffer);  // lives as long as it is attached
    }

    Picture drawn(Mode mode)
    {
        osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings;
        settings->setStereo(true);
        settings->setStereoMode(mode);
        settings->setSplitStereoHorizontalSeparation(0);
        view_->viewer().getCamera()->setDisplaySettings(settings);
        view_->frame();
        const Picture picture = view_->frame();
        auto& renderer =
            dynamic_cast<osgViewer::Renderer&>(*view_->viewer().getCamera()->getRenderer());
        const osgUtil::SceneView& scene = *renderer.getSceneView(0);
        const osg::Matrixd view = view_->viewer().getCamera()->getViewMatrix(),
                           projection = view_->viewer().getCamera()->getProjectionMatrix();
        left_ = {scene.computeLeftEyeView(view), scene.computeLeftEyeProjection(projection)};
        right_ = {scene.computeRightEyeView(view), scene.computeRightEyeProjection(projection)};
        view_->viewer().getCamera()->setDisplaySettings(nullptr);
        EXPECT_EQ(effect_->lastReport().reason, "");
        keepPicture(picture, kSize,
                    std::string("stereo-") + GetParam().name + std::to_string(mode));
        return picture;
    }

    /// What a camera at the eye draws into the viewport.
    Picture mono(const Eye& eye, int x = 0, int width = kSize)
    {
        osg::Camera* camera = view_->viewer().getCamera();
        const osg::Matrixd view = camera->getViewMatrix(),
                           projection = camera->getProjectionMatrix();
        osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings;
        settings->setStereo(false);
        camera->setDisplaySettings(settings);
        camera->setViewMatrix(eye.view);
        camera->setProjectionMatrix(eye.projection);
        camera->setViewport(x, 0, width, kSize);
        view_->offscreen().clear();
        const Picture picture = view_->frame();
        EXPECT_GT(meanOf(picture, 0), 0.02);
        camera->setViewMatrix(view);
        camera->setProjectionMatrix(projection);
        camera->setViewport(0, 0, kSize, kSize);
        return picture;
    }

    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect_;
    osg::ref_ptr<osg::Group> root_ = new osg::Group;
    Eye left_, right_;
};

TEST_P(Stereo, OneEyeIsACameraThere)
{
    const Picture found = drawn(osg::DisplaySettings::LEFT_EYE);
    EXPECT_EQ(found, mono(left_));
    EXPECT_NE(found, mono(right_));
}

TEST_P(Stereo, HalvesOfTheViewportAreTheEyes)
{
    const Picture found = drawn(osg::DisplaySettings::HORIZONTAL_SPLIT);
    Picture expected = mono(left_, 0, kSize / 2);
    const Picture right = mono(right_, kSize / 2, kSize / 2);
    for (size_t i = 0; i < expected.size(); ++i)
        if (i / 4 % kSize >= kSize / 2) expected[i] = right[i];
    EXPECT_EQ(found, expected);
}

// OpenGL draws only red for one eye and the rest for the other, into surfaces as well: the channels
// that are masked there are never read.
TEST_P(Stereo, ColoursAreTheEyes)
{
    const Picture found = drawn(osg::DisplaySettings::ANAGLYPHIC);
    const Picture left = mono(left_), right = mono(right_);
    for (size_t i = 0; i < found.size(); i += 4) {
        EXPECT_EQ(found[i], left[i]) << i;
        EXPECT_EQ(found[i + 1], right[i + 1]) << i;
        EXPECT_EQ(found[i + 2], right[i + 2]) << i;
    }
}

TEST_P(Stereo, ColumnsAreTheEyes)
{
    const Picture found = drawn(osg::DisplaySettings::VERTICAL_INTERLACE);
    const Picture left = mono(left_), right = mono(right_);
    for (size_t i = 0; i < found.size(); i += 4)
        for (size_t c = i; c < i + 3; ++c)
            EXPECT_EQ(found[c], i / 4 % 2 == 0 ? left[c] : right[c]) << i / 4;
}

INSTANTIATE_TEST_SUITE_P(
    Ways, Stereo,
    ::testing::Values(Way{"SinglePass", 0, osgFbrdf::kSinglePass, false},
                      Way{"TwoLookups", 0, osgFbrdf::kTwoLookups, false},
                      Way{"TwoLookupsInSurfaces", 0, osgFbrdf::kTwoLookups, true},
                      Way{"SumInSurfaces", 4, osgFbrdf::kTwoLookups, true}),
    [](const ::testing::TestParamInfo<Way>& way) { return std::string(way.param.name); });

}  // namespace
}  // namespace fbrdf::test
