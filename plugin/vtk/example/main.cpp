// fbrdf-vtk-part shows a scanned part of a measured material in the light of ParaView: a kit of
// four lights about the camera, before a grey gradient.
//   fbrdf-vtk-part [--off-screen PICTURE.png] MATERIAL.fbrdf [MESH.ply|.stl|.obj]
#include "Part.h"

#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

struct Arguments {
    std::string material, mesh, picture;
    bool valid = true;
};

Arguments argumentsOf(int argc, char** argv)
{
    Arguments result;
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--off-screen" && i + 1 < argc)
            result.picture = argv[++i];
        else
            names.push_back(word);
    }
    result.valid = (names.size() == 1 || names.size() == 2) && names[0].rfind("--", 0) != 0;
    if (result.valid) result.material = names[0];
    if (names.size() == 2) result.mesh = names[1];
    return result;
}

bool savePicture(vtkRenderWindow& window, const std::string& file)
{
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(&window);
    picture->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputConnection(picture->GetOutputPort());
    writer->Write();
    return writer->GetErrorCode() == 0;
}

}  // namespace

int main(int argc, char** argv)
{
    const Arguments arguments = argumentsOf(argc, argv);
    if (!arguments.valid) {
        std::cerr << "usage: fbrdf-vtk-part [--off-screen PICTURE.png] MATERIAL.fbrdf "
                     "[MESH.ply|.stl|.obj]\n";
        return 2;
    }
    const auto mesh = arguments.mesh.empty() ? scannedPart() : readMesh(arguments.mesh);
    if (!mesh) {
        std::cerr << "fbrdf-vtk-part: " << arguments.mesh
                  << ": found no surface, expected a .ply, .stl or .obj\n";
        return 3;
    }

    // 1. The part, and what it is made of.
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(withNormals(*mesh));
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkNew<vtkFbrdfMaterial> material;
    if (!material->SetMaterialFile(arguments.material)) return 3;
    material->SetTransfer(fbrdf::Transfer::toneMap);  // for a window, which shows sRGB codes
    material->SetExposure(1.5f);
    material->ApplyTo(actor);

    // 2. The scene: ParaView's background and its kit of lights.
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(0.06, 0.06, 0.08);
    renderer->SetBackground2(0.32, 0.34, 0.43);
    renderer->GradientBackgroundOn();
    renderer->AddActor(actor);
    vtkNew<vtkLightKit> lights;
    lights->AddLightsToRenderer(renderer);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(arguments.picture.empty() ? 0 : 1);
    window->SetShowWindow(arguments.picture.empty());
    window->SetSize(640, 480);
    window->SetWindowName("fbrdf-vtk-part");
    window->AddRenderer(renderer);
    renderer->GetActiveCamera()->SetPosition(1.3, 0.9, 2.2);
    renderer->GetActiveCamera()->SetViewAngle(26.0);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.15);

    // 3. It is saved or shown.
    if (!arguments.picture.empty()) return savePicture(*window, arguments.picture) ? 0 : 5;
    vtkNew<vtkRenderWindowInteractor> interactor;
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetInteractorStyle(style);
    interactor->SetRenderWindow(window);
    window->Render();
    interactor->Start();
    return 0;
}
