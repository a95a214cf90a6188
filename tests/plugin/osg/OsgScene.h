// OsgScene.h - lets OpenSceneGraph draw without a display: in a context of EGL or OSMesa, into a
// float framebuffer, with the same meshes, lights and views as the tests of the plain runtime.
#pragma once
#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PointLights.h>

#include <fbrdf/gl/Renderer.h>
#include <fbrdf/headless/Context.h>
#include <fbrdf/headless/Offscreen.h>

#include <osg/Geometry>
#include <osg/Notify>
#include <osgViewer/Viewer>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf::test {

constexpr int kSize = 64;

osg::ref_ptr<osg::Geometry> osgMesh(const gl::MeshData& mesh);
osg::Matrixd osgMatrix(const glm::mat4& matrix);

/// Makes the view black and without a headlight, with near and far planes as they are given; it
/// draws into a framebuffer object.
void setUpView(osgViewer::View& view);

/// A viewer in a context that is current, which draws to a framebuffer of its own. The background
/// is black and there is no headlight.
class OsgView {
public:
    explicit OsgView(HeadlessContext::Load load, OffscreenFormat format = OffscreenFormat::rgba32f);
    ~OsgView();
    void setScene(osg::Node* scene);
    void setView(const gl::View& view);
    osgViewer::Viewer& viewer() { return *viewer_; }
    Offscreen& offscreen() { return offscreen_; }
    void draw();
    /// Draws, and returns the picture: RGBA, rows from the bottom.
    std::vector<float> frame();

private:
    Offscreen offscreen_;
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
    bool drawn_ = false;
};

/// Collects what is written to osg::notify, at WARN and above, as long as it lives.
class Notices {
public:
    Notices();
    ~Notices();
    const std::string& text() const;

private:
    osg::ref_ptr<osg::NotifyHandler> before_, handler_;
};

/// Draws by EGL, or by the backend that FBRDF_OSG_BACKEND names in the environment. osmesa needs
/// LD_PRELOAD=libOSMesa.so.8, as OSG takes whichever gl functions come first. Where there is no
/// such context the test is skipped, or fails with CI=true in the environment.
class OsgTest : public ::testing::Test {
protected:
    void SetUp() override;
    HeadlessContext& context() { return *context_; }

    static std::unique_ptr<HeadlessContext> newContext();

private:
    std::unique_ptr<HeadlessContext> context_;
};

/// The effect over a mesh.
osg::ref_ptr<osgFbrdf::FactorizedBrdf> osgEffect(const Material& material,
                                                 const gl::MeshData& mesh);
osg::ref_ptr<osgFbrdf::PointLights> osgLights(const std::vector<Light>& lights);

/// Multisampled cameras have no memory where libGL has a function of an extension that the driver
/// lacks: OSG 3.6.5 calls it. To be called when the context is current and before the first frame.
void haveSamples(const osg::GraphicsContext& context);

/// The mean of one channel over all pixels.
double meanOf(const std::vector<float>& image, int channel);

}  // namespace fbrdf::test
