// A program outside of the project runs the lines of docs/vtk.md.
#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdio>
#include <string>

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string file = argv[1];
    // [page]
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);

    vtkNew<vtkFbrdfMaterial> material;
    material->SetMaterialFile(file);
    material->SetTransfer(fbrdf::Transfer::toneMap);  // for a window, which shows sRGB codes
    material->ApplyTo(actor);

    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(actor);
    vtkNew<vtkLight> lamp;
    lamp->SetPosition(2.0, 3.0, 3.0);
    lamp->SetPositional(true);
    lamp->SetAttenuationValues(0.0, 0.0, 0.1);
    renderer->AddLight(lamp);
    // [/page]
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(64, 64);
    window->AddRenderer(renderer);
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, 63, 63, 0, pixels);
    const int brightest = *std::max_element(pixels->GetPointer(0),
                                            pixels->GetPointer(0) + pixels->GetNumberOfValues());
    const std::string technique = material->LastReport().technique;
    std::printf("%s, %d\n", technique.c_str(), brightest);
    return technique == "single pass" && brightest > 20 ? 0 : 1;
}
