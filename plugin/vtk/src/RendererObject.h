// RendererObject.h - objects that live with a renderer, in its information.
#pragma once
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace fbrdf::vtk {

/// That of the renderer by a key, which is made where there is none.
template <class T>
T& objectOf(vtkRenderer& renderer, vtkInformationObjectBaseKey& key)
{
    vtkInformation* information = renderer.GetInformation();
    if (!information) {
        vtkNew<vtkInformation> made;
        renderer.SetInformation(made);
        information = made;
    }
    if (auto* known = T::SafeDownCast(information->Get(&key))) return *known;
    vtkNew<T> made;
    information->Set(&key, made);
    return *made;
}

}  // namespace fbrdf::vtk
