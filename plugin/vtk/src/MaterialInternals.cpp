#include "MaterialInternals.h"

#include "FbrdfPass.h"

#include <fbrdf/environment/LobeFit.h>

#include <vtkOpenGLRenderWindow.h>

#include <algorithm>

void vtkFbrdfMaterial::Internals::replaceMaterial(const fbrdf::Material& value)
{
    material = value;
    albedo = fbrdf::diffuseAlbedo(value);
    lobes_ = value.lobes;
    whyNoLobes_.clear();
    forgetMaps();
}

void vtkFbrdfMaterial::Internals::removeMaterial()
{
    material.reset();
    albedo = fbrdf::Vec3f(0.5f);
    forgetMaps();
}

void vtkFbrdfMaterial::Internals::forgetMaps()
{
    maps_.clear();
    reported_.clear();
    shaderTime.Modified();
}

fbrdf::vtk::MapTextures& vtkFbrdfMaterial::Internals::mapsIn(vtkOpenGLRenderWindow& window)
{
    for (auto& maps : maps_)
        if (maps->isIn(window)) return *maps;
    maps_.erase(std::remove_if(maps_.begin(), maps_.end(),
                               [](const auto& maps) { return !maps->isAlive(); }),
                maps_.end());
    maps_.push_back(std::make_unique<fbrdf::vtk::MapTextures>(*material, precise, window));
    return *maps_.back();
}

std::vector<fbrdf::Vec3f> vtkFbrdfMaterial::Internals::exposedScales() const
{
    std::vector<fbrdf::Vec3f> scales = material->scales;
    for (fbrdf::Vec3f& scale : scales) scale *= exposure;
    return scales;
}

const fbrdf::LobeTable* vtkFbrdfMaterial::Internals::lobes(std::string& whyNot)
{
    if (lobes_.isEmpty() && whyNoLobes_.empty()) try {
            lobes_ = fbrdf::fitLobes(*material);
        } catch (const std::exception& error) {
            whyNoLobes_ = error.what();
        }
    whyNot = whyNoLobes_;
    return lobes_.isEmpty() ? nullptr : &lobes_;
}

std::string vtkFbrdfMaterial::Internals::title() const
{
    if (name.empty()) return file.empty() ? "a material without a name" : file;
    return "'" + name + "'" + (file.empty() ? "" : ", " + file);
}

bool vtkFbrdfMaterial::Internals::isNews(const std::string& problem)
{
    return reported_.insert(problem).second;
}
