// Part.h - the mesh of the example.
#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// A bearing block as a scanner would hand it over: one surface of many triangles, a little uneven.
vtkSmartPointer<vtkPolyData> scannedPart();

/// A .ply, .stl or .obj. Null for another ending, and for a file without a surface.
vtkSmartPointer<vtkPolyData> readMesh(const std::string& file);

/// The same with normals, which smooth shading needs.
vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData& mesh);
