// ShaderEdits.h - what is changed in the shaders that VTK writes for an actor. VTK fills in markers
// of a template; those of lights and textures are taken away before, and the material's text goes
// where they were once VTK is done, when the text shows what the fragment knows: normal, place,
// texture coordinates, edges.
#pragma once
#include <string>

namespace fbrdf::vtk {

/// The three shaders of a program; geometry may be empty.
struct ShaderTexts {
    std::string &vertex, &geometry, &fragment;
};

enum class Look {
    material,
    fallback,  ///< VTK's own lighting with the albedo in vtkFbrdfAlbedo
};

struct ShaderWish {
    std::string functions;         ///< MapTextures::functions
    bool isAnisotropic = false;    ///< tangents matter
    bool derivesTangents = false;  ///< of texture coordinates alone
    bool isDark = false;           ///< no light is on
    bool drawsFaces = true;        ///< not their edges or corners
};

/// Before VTK has filled the markers in.
void takeMarkers(const ShaderTexts& texts, Look look);

/// Afterwards.
void writeMaterial(const ShaderTexts& texts, const ShaderWish& wish);
void writeFallback(const ShaderTexts& texts);

}  // namespace fbrdf::vtk
