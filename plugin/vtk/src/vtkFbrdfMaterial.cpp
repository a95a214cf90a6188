#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include "EnvironmentTexture.h"
#include "FbrdfPass.h"
#include "MaterialInternals.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>

#include <vtkActor.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <filesystem>

namespace {

fbrdf::Material readFile(const std::string& file)
{
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw fbrdf::Error(fbrdf::ErrorKind::input, file,
                           fbrdf::Found("no such file").expected("a material"));
    return fbrdf::readMaterial(file);
}

}  // namespace

vtkStandardNewMacro(vtkFbrdfMaterial);

vtkFbrdfMaterial::vtkFbrdfMaterial() : internals_(std::make_unique<Internals>()) {}
vtkFbrdfMaterial::~vtkFbrdfMaterial() = default;

void vtkFbrdfMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
    Superclass::PrintSelf(os, indent);
    const Internals& i = *internals_;
    os << indent << "Material: " << (i.material ? i.title() : "none") << "\n"
       << indent << "Exposure: " << i.exposure << "\n"
       << indent << "PreciseFiltering: " << i.precise << "\n"
       << indent << "DerivedTangents: " << i.derivedTangents << "\n"
       << indent << "LastTechnique: " << i.report.technique << "\n";
}

bool vtkFbrdfMaterial::SetMaterialFile(const std::string& file)
{
    internals_->file = file;
    if (ReloadMaterial()) return true;
    internals_->removeMaterial();
    return false;
}

const std::string& vtkFbrdfMaterial::GetMaterialFile() const
{
    return internals_->file;
}

bool vtkFbrdfMaterial::ReloadMaterial()
{
    try {
        internals_->replaceMaterial(readFile(internals_->file));
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        return false;
    }
    Modified();
    return true;
}

bool vtkFbrdfMaterial::SetMaterial(const fbrdf::Material& material)
{
    internals_->file.clear();
    Modified();
    try {
        fbrdf::validate(material, "material '" + material.name + "'");
        internals_->replaceMaterial(material);
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        internals_->removeMaterial();
        return false;
    }
    return true;
}

const fbrdf::Material* vtkFbrdfMaterial::GetMaterial() const
{
    return internals_->material ? &*internals_->material : nullptr;
}

void vtkFbrdfMaterial::SetName(const std::string& name)
{
    internals_->name = name;
}

const std::string& vtkFbrdfMaterial::GetName() const
{
    return internals_->name;
}

void vtkFbrdfMaterial::SetExposure(float exposure)
{
    internals_->exposure = std::max(exposure, 0.0f);
    Modified();
}

float vtkFbrdfMaterial::GetExposure() const
{
    return internals_->exposure;
}

void vtkFbrdfMaterial::SetTransfer(fbrdf::Transfer transfer)
{
    internals_->transfer = transfer;
    Modified();
}

fbrdf::Transfer vtkFbrdfMaterial::GetTransfer() const
{
    return internals_->transfer;
}

void vtkFbrdfMaterial::SetPreciseFiltering(bool precise)
{
    if (internals_->precise == precise) return;
    internals_->precise = precise;
    internals_->forgetMaps();
    Modified();
}

bool vtkFbrdfMaterial::GetPreciseFiltering() const
{
    return internals_->precise;
}

void vtkFbrdfMaterial::SetDerivedTangents(bool derived)
{
    internals_->derivedTangents = derived;
    internals_->shaderTime.Modified();
    Modified();
}

bool vtkFbrdfMaterial::GetDerivedTangents() const
{
    return internals_->derivedTangents;
}

void vtkFbrdfMaterial::ApplyTo(vtkActor* actor)
{
    if (!actor) return;
    const vtkSmartPointer<vtkFbrdfPass> before = vtkFbrdfPass::of(*actor);
    vtkSmartPointer<vtkFbrdfPass> pass = internals_->pass.Get();
    if (!pass) {
        pass = vtkSmartPointer<vtkFbrdfPass>::New();
        pass->setMaterial(*this);
        internals_->pass = pass;
    }
    if (before && before != pass) before->detach(*actor);
    pass->attach(*actor);
}

void vtkFbrdfMaterial::RemoveFrom(vtkActor* actor)
{
    if (!actor || Of(actor) != this) return;
    const vtkSmartPointer<vtkFbrdfPass> pass = vtkFbrdfPass::of(*actor);
    pass->detach(*actor);
}

vtkFbrdfMaterial* vtkFbrdfMaterial::Of(vtkActor* actor)
{
    vtkFbrdfPass* const pass = actor ? vtkFbrdfPass::of(*actor) : nullptr;
    return pass ? pass->material() : nullptr;
}

void vtkFbrdfMaterial::SetEnvironmentFaceSize(vtkRenderer* renderer, int size)
{
    vtkFbrdfEnvironmentTexture::in(*renderer).setFaceSize(size);
}

const vtkFbrdfMaterial::Report& vtkFbrdfMaterial::LastReport() const
{
    return internals_->report;
}
