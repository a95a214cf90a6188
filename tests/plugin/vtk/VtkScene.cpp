#include "VtkScene.h"

#include "support/gl/Gl.h"
#include "support/gl/Scenes.h"

#include <fbrdf/gl/Environment.h>
#include <fbrdf/headless/Offscreen.h>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderStepsPass.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

// GLX has a type that is named as one of glad's; only this function of it is needed.
extern "C" void (*glXGetProcAddressARB(const unsigned char*))();

namespace fbrdf::test {
namespace {

vtkSmartPointer<vtkFloatArray> arrayOf(const std::vector<Vec3f>& vectors, const char* name)
{
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    for (const Vec3f& v : vectors) array->InsertNextTypedTuple(&v.x);
    return array;
}

/// Sets camera and clipping range; the view is square and in perspective.
void setCamera(vtkRenderer& renderer, const gl::View& view)
{
    const glm::dmat4 toWorld = glm::inverse(glm::dmat4(view.view)), projection(view.projection);
    const glm::dvec3 eye(toWorld[3]), centre = eye - glm::dvec3(toWorld[2]), up(toWorld[1]);
    const double a = projection[2][2], b = projection[3][2];
    vtkCamera* const camera = renderer.GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(centre.x, centre.y, centre.z);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(2.0 * std::atan(1.0 / projection[1][1]) * 180.0 / kPi);
    camera->SetClippingRange(b / (a - 1.0), b / (a + 1.0));
}

// Vertices are placed by one matrix in VTK and by two in the runtime: a pixel whose centre an edge
// passes within rounding is covered by one of them alone.
constexpr int kEdgePixels = 2;

}  // namespace

vtkSmartPointer<vtkPolyData> vtkMesh(const gl::MeshData& mesh)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf(mesh.positions, "Points"));
    data->SetPoints(points);
    data->GetPointData()->SetNormals(arrayOf(mesh.normals, "Normals"));
    if (!mesh.tangents.empty())
        data->GetPointData()->SetTangents(
            arrayOf(std::vector<Vec3f>(mesh.tangents.begin(), mesh.tangents.end()), "Tangents"));
    vtkNew<vtkCellArray> triangles;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles->InsertNextCell({static_cast<vtkIdType>(mesh.indices[i]),
                                   static_cast<vtkIdType>(mesh.indices[i + 1]),
                                   static_cast<vtkIdType>(mesh.indices[i + 2])});
    data->SetPolys(triangles);
    return data;
}

vtkSmartPointer<vtkActor> vtkActorOf(vtkPolyData* mesh)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
}

vtkSmartPointer<vtkFbrdfMaterial> vtkMaterial(const Material& material)
{
    auto result = vtkSmartPointer<vtkFbrdfMaterial>::New();
    result->SetMaterial(material);
    return result;
}

Material whiteMaterial()
{
    Material material = noiseMaterial(formIo(), Storage::half);
    for (float& texel : material.tables[0].texels) texel = 0.0f;
    material.scales = {Vec3f(static_cast<float>(1.0 / kPi))};
    material.name = "white";
    return material;
}

std::vector<Light> vtkTestLights(int count)
{
    std::vector<Light> lights = testLights(count);
    for (Light& light : lights) {
        light.radius = 0.0f;
        light.innerAngle = light.outerAngle;
    }
    return lights;
}

vtkSmartPointer<vtkLight> vtkLightOf(const Light& light)
{
    auto result = vtkSmartPointer<vtkLight>::New();
    const Vec3d colour = Vec3d(light.intensity) / kPi, position(light.position),
                towards = light.type == Light::Type::directional ? Vec3d(0.0)
                                                                 : position + Vec3d(light.axis);
    result->SetLightTypeToSceneLight();
    result->SetDiffuseColor(colour.x, colour.y, colour.z);
    result->SetPosition(position.x, position.y, position.z);
    result->SetFocalPoint(towards.x, towards.y, towards.z);
    result->SetPositional(light.type != Light::Type::directional);
    result->SetAttenuationValues(0.0, 0.0, 1.0);
    const bool isSpot = light.type == Light::Type::spot;
    result->SetConeAngle(isSpot ? static_cast<double>(light.outerAngle) * 180.0 / kPi : 90.0);
    result->SetExponent(0.0);
    return result;
}

ImageDifference compareCovered(const std::vector<float>& found, std::vector<float> expected)
{
    int alone = 0;
    for (size_t i = 0; i + 3 < found.size() && found.size() == expected.size(); i += 4) {
        if ((found[i + 3] > 0.0f) == (expected[i + 3] > 0.0f)) continue;
        ++alone;
        for (size_t c = i; c < i + 4; ++c) expected[c] = found[c];
    }
    EXPECT_LE(alone, kEdgePixels);
    return compareImages(found, expected);
}

void* glxFunction(void*, const char* name)
{
    return reinterpret_cast<void*>(
        glXGetProcAddressARB(reinterpret_cast<const unsigned char*>(name)));
}

gl::View straightView()
{
    gl::View view = perspectiveView();
    view.view = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -4.0f});
    return view;
}

VtkView::VtkView(int size) : view(straightView()), size_(size)
{
    window_->SetOffScreenRendering(1);
    window_->SetShowWindow(false);
    window_->SetMultiSamples(0);
    window_->SetSize(size, size);
    window_->AddRenderer(renderer_);
    renderer_->SetBackground(0.0, 0.0, 0.0);
    renderer_->AutomaticLightCreationOff();
    setView(view);
    vtkNew<vtkRenderStepsPass> steps;
    floats_->SetDelegatePass(steps);
    floats_->SetColorFormat(vtkTextureObject::Float32);
    floats_->SetDepthFormat(vtkTextureObject::Fixed24);
}

VtkView::~VtkView()
{
    floats_->ReleaseGraphicsResources(window_);
}

void VtkView::setView(const gl::View& taken)
{
    view = taken;
    setCamera(*renderer_, view);
}

void VtkView::setLights(const std::vector<Light>& lights)
{
    renderer_->RemoveAllLights();
    for (const Light& light : lights) renderer_->AddLight(vtkLightOf(light));
}

std::vector<float> VtkView::frame()
{
    renderer_->SetPass(floats_);
    window_->Render();
    renderer_->SetPass(nullptr);
    const GladGLContext gl = loadGl(glxFunction);
    std::vector<float> pixels(static_cast<size_t>(4 * size_ * size_));
    vtkTextureObject* const texture = floats_->GetColorTexture();
    gl.BindTexture(GL_TEXTURE_2D, texture->GetHandle());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
    gl.BindTexture(GL_TEXTURE_2D, 0);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return pixels;
}

std::vector<unsigned char> VtkView::bytes()
{
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetPixelData(0, 0, size_ - 1, size_ - 1, 0, pixels);
    const unsigned char* const first = pixels->GetPointer(0);
    return {first, first + pixels->GetNumberOfValues()};
}

std::vector<float> VtkView::runtime(const Material& material, const gl::MeshData& mesh,
                                    const std::vector<Light>& lights, const Shown& shown)
{
    window_->MakeCurrent();
    gl::RendererOptions rendererOptions;
    rendererOptions.load = glxFunction;
    gl::Renderer renderer(rendererOptions);
    const auto gpuMaterial = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(mesh);
    Offscreen target(glxFunction, {size_, size_, OffscreenFormat::rgba32f, true});
    target.clear();
    std::shared_ptr<gl::GpuEnvironment> map;
    gl::DrawOptions options;
    if (shown.environment) {
        map = renderer.createEnvironment(*shown.environment, {shown.faceSize, false});
        options.environment = {map.get(), shown.rotation};
        renderer.prepare(*gpuMaterial, options, static_cast<int>(lights.size()));
    }
    renderer.draw({target.framebuffer(), size_, size_, shown.transfer, shown.exposure}, view,
                  {{gpuMaterial.get(), gpuMesh.get(), shown.place}}, lights, options);
    return target.readPixels();
}

struct VtkLog::Window : vtkOutputWindow {
    static Window* New() { return new Window; }
    vtkTypeMacro(Window, vtkOutputWindow);
    void DisplayText(const char* text) override { lines += text; }
    std::string lines;
};

VtkLog::VtkLog() : window_(vtkSmartPointer<Window>::New()), before_(vtkOutputWindow::GetInstance())
{
    vtkOutputWindow::SetInstance(window_);
}

VtkLog::~VtkLog()
{
    vtkOutputWindow::SetInstance(vtkOutputWindow::SafeDownCast(before_));
}

std::string VtkLog::text() const
{
    return window_->lines;
}

int VtkLog::count(const std::string& part) const
{
    int found = 0;
    for (size_t at = 0; (at = window_->lines.find(part, at)) != std::string::npos; ++at) ++found;
    return found;
}

}  // namespace fbrdf::test
