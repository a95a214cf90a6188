// MaterialInternals.h - what vtkFbrdfMaterial knows of itself: shared by the class that users see
// and the pass that draws.
#pragma once
#include "FbrdfPass.h"
#include "MapTextures.h"

#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkTimeStamp.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

class vtkFbrdfMaterial::Internals {
public:
    std::string file, name;
    std::optional<fbrdf::Material> material;
    fbrdf::Vec3f albedo{0.5f};
    float exposure = 1.0f;
    fbrdf::Transfer transfer = fbrdf::Transfer::linear;
    bool precise = false, derivedTangents = false;
    /// When the text of shaders last changed.
    vtkTimeStamp shaderTime;
    vtkWeakPointer<vtkFbrdfPass> pass;
    Report report;

    void replaceMaterial(const fbrdf::Material& value);
    void removeMaterial();
    /// Textures are made again.
    void forgetMaps();
    /// Expects that there is a material. The window is current.
    fbrdf::vtk::MapTextures& mapsIn(vtkOpenGLRenderWindow& window);
    std::vector<fbrdf::Vec3f> exposedScales() const;
    /// By which it reflects an environment: those of the file, else fitted when first asked for.
    /// Null, with the reason, where that fails.
    const fbrdf::LobeTable* lobes(std::string& whyNot);
    /// "'name', file", as far as there are such.
    std::string title() const;
    /// True for the first report of this kind since the material was set.
    bool isNews(const std::string& problem);

private:
    std::vector<std::unique_ptr<fbrdf::vtk::MapTextures>> maps_;
    std::set<std::string> reported_;
    fbrdf::LobeTable lobes_;
    std::string whyNoLobes_;
};
