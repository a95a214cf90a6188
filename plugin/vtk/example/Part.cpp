#include "Part.h"

#include <vtkBox.h>
#include <vtkCylinder.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImplicitBoolean.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <cmath>

namespace {

constexpr int kCells = 140;  // along each axis of what is scanned, 2 units

void addBox(vtkImplicitBoolean& shape, const double (&bounds)[6])
{
    vtkNew<vtkBox> box;
    box->SetBounds(bounds);
    shape.AddFunction(box);
}

/// Along z, or along y where it is upright.
void addCylinder(vtkImplicitBoolean& shape, double x, double y, double radius, bool upright)
{
    vtkNew<vtkCylinder> cylinder;
    cylinder->SetCenter(x, y, 0.0);
    cylinder->SetRadius(radius);
    cylinder->SetAxis(0.0, upright ? 1.0 : 0.0, upright ? 0.0 : 1.0);
    shape.AddFunction(cylinder);
}

/// Negative inside of the part.
vtkSmartPointer<vtkImplicitBoolean> bearingBlock()
{
    vtkNew<vtkImplicitBoolean> foot, housing, whole;
    auto part = vtkSmartPointer<vtkImplicitBoolean>::New();
    addBox(*foot, {-0.85, 0.85, -0.6, -0.35, -0.4, 0.4});
    addCylinder(*housing, 0.0, 0.05, 0.5, false);
    addBox(*housing, {-0.6, 0.6, -0.6, 0.6, -0.3, 0.3});
    housing->SetOperationTypeToIntersection();
    whole->SetOperationTypeToUnion();
    whole->AddFunction(foot);
    whole->AddFunction(housing);
    part->SetOperationTypeToDifference();
    part->AddFunction(whole);
    addCylinder(*part, 0.0, 0.05, 0.28, false);
    addCylinder(*part, -0.68, 0.0, 0.09, true);
    addCylinder(*part, 0.68, 0.0, 0.09, true);
    return part;
}

template <class Reader>
vtkSmartPointer<vtkPolyData> readBy(const std::string& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

bool endsWith(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

vtkSmartPointer<vtkPolyData> scannedPart()
{
    const auto part = bearingBlock();
    vtkNew<vtkImageData> grid;
    grid->SetDimensions(kCells + 1, kCells + 1, kCells + 1);
    grid->SetOrigin(-1.0, -1.0, -1.0);
    grid->SetSpacing(2.0 / kCells, 2.0 / kCells, 2.0 / kCells);
    grid->AllocateScalars(VTK_FLOAT, 1);
    auto* const values = static_cast<float*>(grid->GetScalarPointer());
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
        double at[3];
        grid->GetPoint(i, at);
        // What is left of casting, and of the scanner: waves of a thousandth of the size.
        const double uneven =
            0.002 * std::sin(23.0 * at[0]) * std::sin(19.0 * at[1]) * std::sin(21.0 * at[2]);
        values[i] = static_cast<float>(part->EvaluateFunction(at) + uneven);
    }
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputData(grid);
    surface->SetValue(0, 0.0);
    surface->ComputeNormalsOff();
    surface->ComputeScalarsOff();
    vtkNew<vtkWindowedSincPolyDataFilter> smooth;
    smooth->SetInputConnection(surface->GetOutputPort());
    smooth->SetNumberOfIterations(30);
    smooth->SetPassBand(0.08);
    smooth->Update();
    return smooth->GetOutput();
}

vtkSmartPointer<vtkPolyData> readMesh(const std::string& file)
{
    vtkSmartPointer<vtkPolyData> mesh;
    if (endsWith(file, ".ply")) mesh = readBy<vtkPLYReader>(file);
    if (endsWith(file, ".stl")) mesh = readBy<vtkSTLReader>(file);
    if (endsWith(file, ".obj")) mesh = readBy<vtkOBJReader>(file);
    return mesh && mesh->GetNumberOfCells() > 0 ? mesh : nullptr;
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData& mesh)
{
    if (mesh.GetPointData()->GetNormals()) return &mesh;
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(&mesh);
    normals->SetFeatureAngle(40.0);
    normals->Update();
    return normals->GetOutput();
}
