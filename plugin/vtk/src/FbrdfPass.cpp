#include "FbrdfPass.h"

#include "EnvironmentTexture.h"
#include "LightTexture.h"
#include "MaterialInternals.h"
#include "RendererProbe.h"
#include "ShaderEdits.h"

#include <fbrdf/shaders/LobeRows.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <vtkActor.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkLightingMapPass.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkShaderProgram.h>
#include <vtkTextureUnitManager.h>

#include <glm/gtc/type_ptr.hpp>

namespace {

using fbrdf::vtk::Look;

int freeUnits(vtkOpenGLRenderWindow& window)
{
    vtkTextureUnitManager* const units = window.GetState()->GetTextureUnitManager();
    int count = 0;
    for (int i = 0; i < units->GetNumberOfTextureUnits(); ++i)
        count += units->IsAllocated(i) ? 0 : 1;
    return count;
}

vtkOpenGLRenderWindow* windowOf(vtkOpenGLRenderer* renderer)
{
    return renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
}

/// VTK stores the transposed matrix, so its elements in memory are those of OpenGL.
glm::dmat4 matrixOf(vtkMatrix4x4& transposed)
{
    return glm::make_mat4(transposed.GetData());
}

struct CameraMatrices {
    glm::dmat4 view, projection;
};

CameraMatrices matricesOf(vtkOpenGLRenderer& renderer)
{
    vtkMatrix4x4 *toView = nullptr, *toClip = nullptr, *both = nullptr;
    vtkMatrix3x3* normals = nullptr;
    static_cast<vtkOpenGLCamera*>(renderer.GetActiveCamera())
        ->GetKeyMatrices(&renderer, toView, normals, toClip, both);
    return {matrixOf(*toView), matrixOf(*toClip)};
}

void setCamera(vtkShaderProgram& program, vtkOpenGLRenderer& renderer, vtkActor& actor)
{
    const CameraMatrices camera = matricesOf(renderer);
    const glm::vec4 eye(fbrdf::eyeFromProjection(camera.projection));
    program.SetUniform4f("fbrdfEye", glm::value_ptr(eye));
    if (!program.IsUniformUsed("vtkFbrdfTangentMatrix")) return;
    // The mapper's own matrix may have the shift and scale of its buffers in it.
    const glm::dmat4 place = glm::transpose(matrixOf(*actor.GetMatrix()));
    glm::mat3 turn(glm::dmat3(camera.view * place));
    program.SetUniformMatrix3x3("vtkFbrdfTangentMatrix", glm::value_ptr(turn));
}

/// The units are freed by the probe when the actor has been drawn.
void activate(vtkTextureObject& texture, vtkFbrdfRendererProbe& probe)
{
    texture.Activate();
    probe.deactivateLater(texture);
}

int transferIndex(fbrdf::Transfer transfer)
{
    if (transfer == fbrdf::Transfer::srgb) return 1;
    return transfer == fbrdf::Transfer::toneMap ? 2 : 0;
}

/// Of keys that no actor has any more: they would not release their passes.
void emptyUnused(vtkInformation* keys)
{
    if (!keys || keys->GetReferenceCount() > 1) return;
    vtkInformationObjectBaseVectorKey* const passes = vtkOpenGLRenderPass::RenderPasses();
    while (keys->Length(passes) > 0) keys->Remove(passes, keys->Get(passes, 0));
}

/// A copy with a list of passes of its own.
vtkSmartPointer<vtkInformation> copyOf(vtkInformation* keys)
{
    auto copy = vtkSmartPointer<vtkInformation>::New();
    if (!keys) return copy;
    vtkInformationObjectBaseVectorKey* const passes = vtkOpenGLRenderPass::RenderPasses();
    copy->Copy(keys);
    copy->Remove(passes);
    for (int i = 0; i < keys->Length(passes); ++i) copy->Append(passes, keys->Get(passes, i));
    return copy;
}

/// Keeps a pass and a probe with an actor, until that goes: keys that die do not release their
/// passes.
class Keeper : public vtkCommand {
public:
    static Keeper* New() { return new Keeper; }
    vtkBaseTypeMacro(Keeper, vtkCommand);
    void Execute(vtkObject* caller, unsigned long event, void*) override
    {
        vtkActor& actor = *vtkActor::SafeDownCast(caller);
        if (event != vtkCommand::DeleteEvent) return keep(actor);
        const vtkSmartPointer<vtkFbrdfPass> kept = pass;  // beyond the end of this observer
        keys_ = nullptr;
        kept->detach(actor);
    }
    void keep(vtkActor& actor)
    {
        if (isBusy_) return;
        isBusy_ = true;
        // The keys may be those of an assembly: its other parts must not have the pass.
        if (vtkFbrdfPass::of(actor) != pass) {
            const vtkSmartPointer<vtkInformation> before = keys_;
            keys_ = copyOf(actor.GetPropertyKeys());
            keys_->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
            actor.SetPropertyKeys(keys_);
            emptyUnused(before);
        }
        vtkFbrdfRendererProbe::in(actor);
        isBusy_ = false;
    }

    vtkSmartPointer<vtkFbrdfPass> pass;

private:
    vtkSmartPointer<vtkInformation> keys_;  ///< those that the actor was given
    bool isBusy_ = false;
};

}  // namespace

vtkStandardNewMacro(vtkFbrdfPass);
vtkFbrdfPass::vtkFbrdfPass() = default;
vtkFbrdfPass::~vtkFbrdfPass() = default;

vtkFbrdfPass* vtkFbrdfPass::of(vtkProp& prop)
{
    vtkInformation* const keys = prop.GetPropertyKeys();
    const int count = keys ? keys->Length(RenderPasses()) : 0;
    for (int i = 0; i < count; ++i)
        if (auto* pass = SafeDownCast(keys->Get(RenderPasses(), i))) return pass;
    return nullptr;
}

void vtkFbrdfPass::attach(vtkActor& actor)
{
    if (of(actor) == this && observers_.count(&actor)) return;
    vtkNew<Keeper> keeper;
    keeper->pass = this;
    keeper->keep(actor);
    for (const unsigned long event : {vtkCommand::ModifiedEvent, vtkCommand::DeleteEvent})
        actor.AddObserver(event, keeper);
    observers_[&actor] = keeper;
}

void vtkFbrdfPass::detach(vtkActor& actor)
{
    actor.RemoveObserver(observers_[&actor]);
    observers_.erase(&actor);
    const vtkSmartPointer<vtkInformation> before = actor.GetPropertyKeys();
    const vtkSmartPointer<vtkInformation> keys = copyOf(before);
    keys->Remove(RenderPasses(), this);
    if (keys->Length(RenderPasses()) == 0) keys->Remove(RenderPasses());
    actor.SetPropertyKeys(keys);
    emptyUnused(before);
}

vtkMTimeType vtkFbrdfPass::GetShaderStageMTime()
{
    return material_->GetInternals().shaderTime.GetMTime();
}

std::string vtkFbrdfPass::refusalOf(vtkActor& actor)
{
    auto& internals = material_->GetInternals();
    if (!internals.material) return "no material";
    vtkOpenGLRenderWindow* const window = windowOf(vtkFbrdfRendererProbe::rendererOf(actor));
    if (!window) return "no renderer that shows the actor is known";
    const auto& maps = internals.mapsIn(*window);
    if (!maps.refusal().empty()) return maps.refusal();
    const int needed = static_cast<int>(maps.textures().size()) + 1, free = freeUnits(*window);
    return needed <= free ? "" : fbrdf::vtk::tooFew("texture units", needed, free);
}

void vtkFbrdfPass::report(const std::string& reason, int lights, int dropped)
{
    auto& internals = material_->GetInternals();
    internals.report = {reason.empty() ? "single pass" : "diffuse fallback", reason, lights,
                        dropped};
    if (!reason.empty() && internals.isNews(reason))
        vtkWarningWithObjectMacro(
            material_.Get(), << internals.title() << ": diffuse fallback is drawn: " << reason);
    if (dropped > 0 && internals.isNews("lights"))
        vtkWarningWithObjectMacro(material_.Get(),
                                  << internals.title() << ": lights are left out: found "
                                  << lights + dropped << ", " << lights << " of which are valid");
}

const fbrdf::LobeTable* vtkFbrdfPass::lobesIn(vtkOpenGLRenderer& renderer, std::string& whyNot)
{
    if (!vtkFbrdfEnvironmentTexture::isOn(renderer)) return nullptr;
    whyNot = vtkFbrdfEnvironmentTexture::of(renderer).whyNot();
    if (!whyNot.empty()) return nullptr;
    auto& internals = material_->GetInternals();
    const fbrdf::LobeTable* const lobes = internals.lobes(whyNot);
    if (!lobes) return nullptr;
    auto& maps = internals.mapsIn(*windowOf(&renderer));
    whyNot = maps.whyNoLobes(*lobes);
    const int needed = static_cast<int>(maps.textures().size()) + 2,
              free = freeUnits(*windowOf(&renderer));
    if (whyNot.empty() && needed > free) whyNot = fbrdf::vtk::tooFew("texture units", needed, free);
    return whyNot.empty() ? lobes : nullptr;
}

void vtkFbrdfPass::reportNoEnvironment(const std::string& reason)
{
    auto& internals = material_->GetInternals();
    internals.report.whyNoEnvironment = reason;
    if (!reason.empty() && internals.isNews("environment: " + reason))
        vtkWarningWithObjectMacro(
            material_.Get(), << internals.title() << ": drawn without the environment: " << reason);
}

bool vtkFbrdfPass::PreReplaceShaderValues(std::string& vertex, std::string& geometry,
                                          std::string& fragment, vtkAbstractMapper*, vtkProp* prop)
{
    auto* const actor = vtkActor::SafeDownCast(prop);
    // Pictures of normals and luminance for other tools are VTK's.
    vtkInformation* const keys = prop->GetPropertyKeys();
    isLeft_ = !actor || keys->Has(vtkLightingMapPass::RENDER_NORMALS()) ||
              keys->Has(vtkLightingMapPass::RENDER_LUMINANCE());
    if (isLeft_) return true;
    refusal_ = refusalOf(*actor);
    takeMarkers({vertex, geometry, fragment}, refusal_.empty() ? Look::material : Look::fallback);
    return true;
}

bool vtkFbrdfPass::PostReplaceShaderValues(std::string& vertex, std::string& geometry,
                                           std::string& fragment, vtkAbstractMapper*, vtkProp* prop)
{
    if (isLeft_) return true;
    const fbrdf::vtk::ShaderTexts texts{vertex, geometry, fragment};
    if (!refusal_.empty()) {
        report(refusal_, 0, 0);
        writeFallback(texts);
        return true;
    }
    auto& internals = material_->GetInternals();
    auto* const actor = vtkActor::SafeDownCast(prop);
    vtkOpenGLRenderer* const renderer = vtkFbrdfRendererProbe::rendererOf(*actor);
    vtkFbrdfRendererProbe::in(*actor).addMaterial(*material_);
    const fbrdf::LobeTable* const lobes = lobesIn(*renderer, whyNoEnvironment_);
    reportNoEnvironment(whyNoEnvironment_);
    writeMaterial(texts, {internals.mapsIn(*windowOf(renderer)).functions(lobes),
                          !fbrdf::isIsotropic(internals.material->form), internals.derivedTangents,
                          !lobes && vtkFbrdfLightTexture::of(*renderer).count() == 0,
                          actor->GetProperty()->GetRepresentation() == VTK_SURFACE});
    return true;
}

void vtkFbrdfPass::setEnvironment(vtkShaderProgram& program, vtkOpenGLRenderer& renderer,
                                  vtkFbrdfRendererProbe& probe)
{
    auto& environment = vtkFbrdfEnvironmentTexture::of(renderer);
    auto& internals = material_->GetInternals();
    const fbrdf::LobeTable* const lobes = internals.lobes(whyNoEnvironment_);
    if (!lobes || !environment.whyNot().empty()) return;
    activate(environment.texture(), probe);
    environment.setUniforms(program, renderer, internals.exposure);
    const auto rows = fbrdf::lobeRows(*lobes, fbrdf::wholeShare(fbrdf::layoutOf(*lobes)));
    program.SetUniform4fv("fbrdfLobes", static_cast<int>(rows.size()),
                          glm::value_ptr(rows.front()));
    const glm::vec2 bend = fbrdf::lobeBend(*lobes);
    program.SetUniform2f("fbrdfLobeBend", glm::value_ptr(bend));
}

bool vtkFbrdfPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop,
                                       vtkOpenGLVertexArrayObject*)
{
    auto& internals = material_->GetInternals();
    if (program->IsUniformUsed("vtkFbrdfAlbedo"))
        program->SetUniform3f("vtkFbrdfAlbedo", glm::value_ptr(internals.albedo));
    if (!program->IsUniformUsed("vtkFbrdfLights")) return true;
    auto* const actor = vtkActor::SafeDownCast(prop);
    vtkOpenGLRenderer* const renderer = vtkFbrdfRendererProbe::rendererOf(*actor);
    auto& probe = vtkFbrdfRendererProbe::in(*actor);
    const auto& maps = internals.mapsIn(*windowOf(renderer));
    auto& lights = vtkFbrdfLightTexture::of(*renderer);
    for (const auto& texture : maps.textures()) activate(*texture, probe);
    activate(lights.texture(), probe);
    maps.setUniforms(*program, internals.exposedScales());
    lights.setUniforms(*program);
    if (program->IsUniformUsed("fbrdfEnvironment")) setEnvironment(*program, *renderer, probe);
    program->SetUniformi("vtkFbrdfTransfer", transferIndex(internals.transfer));
    setCamera(*program, *renderer, *actor);
    report("", lights.count(), lights.dropped());
    internals.report.whyNoEnvironment = whyNoEnvironment_;
    return true;
}
