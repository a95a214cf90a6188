// VtkScene.h - lets VTK draw off screen, into floats, with the same meshes, lights and views as the
// tests of the plain runtime, which draws in the same context beside it.
#pragma once
#include "support/gl/CompareImages.h"

#include <fbrdf/environment/Panorama.h>
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkActor.h>
#include <vtkFramebufferPass.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf::test {

constexpr int kSize = 64;

/// Normals and tangents are those of the mesh.
vtkSmartPointer<vtkPolyData> vtkMesh(const gl::MeshData& mesh);
vtkSmartPointer<vtkActor> vtkActorOf(vtkPolyData* mesh);
vtkSmartPointer<vtkFbrdfMaterial> vtkMaterial(const Material& material);

/// A white Lambertian surface: VTK draws a property of its defaults alike.
Material whiteMaterial();

/// testLights() as far as VTK has such: no radius, cones with a sharp edge.
std::vector<Light> vtkTestLights(int count);
vtkSmartPointer<vtkLight> vtkLightOf(const Light& light);

/// A view of the origin from (0, 0, 4), upright: VTK, which places vertices by one matrix, and the
/// runtime, which does so by two, then round alike.
gl::View straightView();

/// compareImages of the pixels that both cover; few may be covered by one alone.
ImageDifference compareCovered(const std::vector<float>& found, std::vector<float> expected);

/// A GL function of the context that is current.
void* glxFunction(void*, const char* name);

/// How the plain runtime shows a mesh.
struct Shown {
    glm::mat4 place{1.0f};
    Transfer transfer = Transfer::linear;
    float exposure = 1.0f;
    const Panorama* environment = nullptr;
    int faceSize = 0;  ///< of its cube
    glm::mat3 rotation{1.0f};
};

/// A window off screen without multisampling, with a black renderer that is not lit.
class VtkView {
public:
    explicit VtkView(int size = kSize);
    ~VtkView();
    vtkRenderer& renderer() { return *renderer_; }
    vtkRenderWindow& window() { return *window_; }

    /// Square and in perspective; straightView() at first.
    void setView(const gl::View& taken);
    void setLights(const std::vector<Light>& lights);
    /// Draws, and returns the picture: RGBA, rows from the bottom, not rounded.
    std::vector<float> frame();
    /// The same as the window shows it: RGB, 8 bits.
    std::vector<unsigned char> bytes();

    /// What the plain runtime draws of the same in the same context.
    std::vector<float> runtime(const Material& material, const gl::MeshData& mesh,
                               const std::vector<Light>& lights, const Shown& shown = {});
    gl::View view;  ///< taken by runtime()

private:
    int size_;
    vtkNew<vtkRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkFramebufferPass> floats_;
};

/// Collects what VTK writes to its log as long as it lives.
class VtkLog {
public:
    VtkLog();
    ~VtkLog();
    std::string text() const;
    /// Lines that the plugin wrote.
    int count(const std::string& part) const;

private:
    struct Window;
    vtkSmartPointer<Window> window_;
    vtkSmartPointer<vtkObject> before_;
};

}  // namespace fbrdf::test
