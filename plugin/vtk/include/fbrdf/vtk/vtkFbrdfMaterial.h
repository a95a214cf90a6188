// vtkFbrdfMaterial.h - a measured material for vtkActors. Actors that have it are drawn with it in
// one pass, lit by every vtkLight of their renderer, of any kind and number, whether lights come or
// go: no shader is written anew for them. Where the renderer has UseImageBasedLighting on, its
// environment texture lights them, too: by the lobes of the material file, or by those that are
// fitted when they are first needed.
//
// A light counts as it does in VTK: a white Lambertian surface looks as a white vtkProperty of
// diffuse coefficient 1 does. What is stored is radiance times exposure through the transfer; alpha
// is the opacity of the actor. Of its vtkProperty representation, opacity, culling, edges and
// vertices stay in use, and LightingOff; colours, scalars and textures do not. As everywhere in VTK
// normals turn towards the viewer. Tangents matter to anisotropic materials only.
//
// Where a material cannot be drawn, VTK draws the actor as a diffuse one of the material's albedo,
// and the log has one line with the reason.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Transfer.h>

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

#include <memory>
#include <string>

class vtkActor;
class vtkRenderer;

class vtkFbrdfMaterial : public vtkObject {
public:
    static vtkFbrdfMaterial* New();
    vtkTypeMacro(vtkFbrdfMaterial, vtkObject);
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// Reads the file (.fbrdf, or what else fbrdf::readMaterial reads). False, with an error that
    /// has file and reason, for one that cannot be read: actors are then diffuse, and the name is
    /// kept.
    bool SetMaterialFile(const std::string& file);
    const std::string& GetMaterialFile() const;
    /// Reads the file again. Where that fails the material stays as it is.
    bool ReloadMaterial();
    /// A material from memory. False, with an error, for one that is not valid; actors are then
    /// diffuse.
    bool SetMaterial(const fbrdf::Material& material);
    /// Null where there is none.
    const fbrdf::Material* GetMaterial() const;
    /// In logs, beside the name of the file.
    void SetName(const std::string& name);
    const std::string& GetName() const;

    /// Radiance is multiplied by it; >= 0.
    void SetExposure(float exposure);
    float GetExposure() const;
    /// What is stored of exposure times radiance: linear (the default, exposure included), or a
    /// curve, as a window without sRGB needs. The fallback ignores exposure and transfer.
    void SetTransfer(fbrdf::Transfer transfer);
    fbrdf::Transfer GetTransfer() const;
    /// True: maps are filtered in the shader, 4 fetches for each look-up (8 in a volume), where a
    /// GPU's own filter, which may know as few as 256 places between two texels, is too coarse.
    void SetPreciseFiltering(bool precise);
    bool GetPreciseFiltering() const;
    /// False: tangents are those of the mesh (its point data's tangents), else those towards
    /// increasing s of its texture coordinates, else arbitrary. True: those of the texture
    /// coordinates, whatever tangents the mesh has.
    void SetDerivedTangents(bool derived);
    bool GetDerivedTangents() const;

    /// Draws the actor with this material from now on, instead of another that it may have had. The
    /// actor keeps the material alive. Any number of actors may have it, in any number of renderers
    /// and windows; one mapper must not serve actors of different materials (VTK has one program a
    /// mapper).
    void ApplyTo(vtkActor* actor);
    /// The actor is drawn by VTK alone again. Nothing happens to one without this material.
    void RemoveFrom(vtkActor* actor);
    /// The material that the actor has; null where it has none.
    static vtkFbrdfMaterial* Of(vtkActor* actor);

    /// Texels on a side of a face of the cube that materials look up of the renderer's environment:
    /// a power of two from 8 on. 0, the default: 512, or 256 where a CPU draws.
    static void SetEnvironmentFaceSize(vtkRenderer* renderer, int size);

    /// What the last draw of an actor did.
    struct Report {
        std::string technique;  ///< "single pass" or "diffuse fallback"; empty before
        std::string reason;     ///< why the fallback; empty otherwise
        int lightsUsed = 0;
        int lightsDropped = 0;  ///< lights with numbers that are not finite
        /// Why the environment of the renderer does not light it; empty where it does, or there is
        /// none.
        std::string whyNoEnvironment = {};
    };
    const Report& LastReport() const;

    class Internals;
    Internals& GetInternals() { return *internals_; }

protected:
    vtkFbrdfMaterial();
    ~vtkFbrdfMaterial() override;

private:
    vtkFbrdfMaterial(const vtkFbrdfMaterial&) = delete;
    void operator=(const vtkFbrdfMaterial&) = delete;

    std::unique_ptr<Internals> internals_;
};
