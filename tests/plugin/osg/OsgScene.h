// OsgScene.h - OpenSceneGraph drawing without a display: a context of EGL's or OSMesa's, a float
// framebuffer, and the same meshes, lights and views as the tests of the plain runtime.
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

/// Black, no headlight, near and far as they are given, into a framebuffer object.
void setUpView(osgViewer::View& view);

/// A viewer in a context that is current, drawing to a framebuffer of its own. Black, no headlight.
class OsgView {
public:
    explicit OsgView(HeadlessContext::Load load, OffscreenFormat format = OffscreenFormat::rgba32f);
    ~OsgView();
    void setScene(osg::Node* scene);
    void setView(const gl::View& view);
    osgViewer::Viewer& viewer() { return *viewer_; }
    Offscreen& offscreen() { return offscreen_; }
    void draw();
    /// Draws; RGBA, rows from the bottom.
    std::vector<float> frame();

private:
    Offscreen offscreen_;
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

/// What osg::notify says while this lives; at WARN and above.
class Notices {
public:
    Notices();
    ~Notices();
    const std::string& text() const;

private:
    osg::ref_ptr<osg::NotifyHandler> before_, handler_;
};

/// Draws by EGL, or by what FBRDF_OSG_BACKEND says in the environment; osmesa needs LD_PRELOAD=
/// libOSMesa.so.8, as OSG takes whichever gl functions come first. Skips where there is no such
/// context; with CI=true in the environment that fails.
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

/// Mean over all pixels of a channel.
double meanOf(const std::vector<float>& image, int channel);

}  // namespace fbrdf::test
