#include "OsgScene.h"

#include <fbrdf/base/Error.h>

#include "support/BuiltFile.h"
#include "support/DataDir.h"

#include <osg/Camera>
#include <osg/Geode>
#include <osgDB/Registry>

#include <cstdlib>

namespace fbrdf::test {
namespace {

class Recorder : public osg::NotifyHandler {
public:
    void notify(osg::NotifySeverity severity, const char* message) override
    {
        if (severity <= osg::WARN) text += message;
    }
    std::string text;
};

osg::ref_ptr<osg::Vec3Array> arrayOf(const std::vector<Vec3f>& vectors)
{
    osg::ref_ptr<osg::Vec3Array> array = new osg::Vec3Array;
    for (const Vec3f& v : vectors) array->push_back({v.x, v.y, v.z});
    return array;
}

}  // namespace

osg::ref_ptr<osg::Geometry> osgMesh(const gl::MeshData& mesh)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(arrayOf(mesh.positions));
    geometry->setNormalArray(arrayOf(mesh.normals), osg::Array::BIND_PER_VERTEX);
    if (!mesh.tangents.empty())
        geometry->setVertexAttribArray(osgFbrdf::kTangentAttribute, arrayOf(mesh.tangents),
                                       osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, mesh.indices.begin(), mesh.indices.end()));
    return geometry;
}

osg::Matrixd osgMatrix(const glm::mat4& matrix)
{
    osg::Matrixd result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result(i, j) = static_cast<double>(matrix[i][j]);
    return result;
}

void setUpView(osgViewer::View& view)
{
    view.setLightingMode(osg::View::NO_LIGHT);
    osg::Camera* camera = view.getCamera();
    camera->setClearColor({0.0f, 0.0f, 0.0f, 0.0f});
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
}

OsgView::OsgView(HeadlessContext::Load load, OffscreenFormat format)
    : offscreen_(load, {kSize, kSize, format, true}),
      viewer_(new osgViewer::Viewer),
      window_(viewer_->setUpViewerAsEmbeddedInWindow(0, 0, kSize, kSize))
{
    window_->setDefaultFboId(offscreen_.framebuffer());
    viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    setUpView(*viewer_);
}

OsgView::~OsgView()
{
    viewer_->setSceneData(nullptr);
}

void OsgView::setScene(osg::Node* scene)
{
    viewer_->setSceneData(scene);
}

void OsgView::setView(const gl::View& view)
{
    viewer_->getCamera()->setViewMatrix(osgMatrix(view.view));
    viewer_->getCamera()->setProjectionMatrix(osgMatrix(view.projection));
}

void OsgView::draw()
{
    const auto* gl = osg::GLExtensions::Get(window_->getState()->getContextID(), true);
    if (!viewer_->isRealized()) viewer_->realize();
    if (!drawn_) {
        // An osg::State takes its context to be new. Where another viewer drew before, the active
        // unit may be any, and the first texture would be bound to that one.
        gl->glActiveTexture(GL_TEXTURE0);
        drawn_ = true;
    }
    gl->glBindFramebuffer(GL_FRAMEBUFFER, offscreen_.framebuffer());
    viewer_->frame();
}

std::vector<float> OsgView::frame()
{
    draw();
    return offscreen_.readPixels();
}

Notices::Notices() : before_(osg::getNotifyHandler()), handler_(new Recorder)
{
    osg::setNotifyHandler(handler_);
}

Notices::~Notices()
{
    osg::setNotifyHandler(before_);
}

const std::string& Notices::text() const
{
    return static_cast<const Recorder&>(*handler_).text;
}

std::unique_ptr<HeadlessContext> OsgTest::newContext()
{
    const char* backend = std::getenv("FBRDF_OSG_BACKEND");
    // OSG's own windows ask for 1.0 too, and get the newest compatible version. In a core profile
    // GL errors would flood the log, as Debian's OSG is built for OpenGL 2.
    return std::make_unique<HeadlessContext>(
        HeadlessOptions{backend ? backendFromName(backend) : Backend::egl,
                        HeadlessOptions::Profile::compatibility, 1, 0, false});
}

void OsgTest::SetUp()
{
    // A user sets this; it makes OSG check for errors after every change of state.
    setenv("OSG_LIBRARY_PATH", builtFile("FBRDF_OSG_LIBRARIES", FBRDF_OSG_LIBRARY_PATH).c_str(), 1);
    setenv("OSG_GL_ERROR_CHECKING", "ONCE_PER_ATTRIBUTE", 1);
    osgDB::Registry::instance()->initLibraryFilePathList();
    // OSG knows extensions by the number of a context, which the context of the last test had too.
    for (unsigned int number = 0; number < 8; ++number) osg::GLExtensions::Set(number, nullptr);
    try {
        context_ = newContext();
    } catch (const Error& error) {
        if (dataIsMandatory()) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
}

osg::ref_ptr<osgFbrdf::FactorizedBrdf> osgEffect(const Material& material, const gl::MeshData& mesh)
{
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
    effect->setMaterial(new osgFbrdf::MaterialObject(material));
    effect->setFloatTarget(true);
    effect->addChild(osgMesh(mesh));
    return effect;
}

osg::ref_ptr<osgFbrdf::PointLights> osgLights(const std::vector<Light>& lights)
{
    osg::ref_ptr<osgFbrdf::PointLights> node = new osgFbrdf::PointLights;
    node->setLights(lights);
    return node;
}

void haveSamples(const osg::GraphicsContext& context)
{
    osg::GLExtensions::Get(context.getState()->getContextID(), true)
        ->glRenderbufferStorageMultisampleCoverageNV = nullptr;
}

double meanOf(const std::vector<float>& image, int channel)
{
    double sum = 0.0;
    for (size_t i = static_cast<size_t>(channel); i < image.size(); i += 4)
        sum += static_cast<double>(image[i]);
    return 4.0 * sum / static_cast<double>(image.size());
}

}  // namespace fbrdf::test
