#include "RendererProbe.h"

#include "EnvironmentTexture.h"
#include "MaterialInternals.h"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkTextureObject.h>

#include <algorithm>

namespace {

constexpr const char* kName = "vtkFbrdfRendererProbe";

/// A renderer that shows the prop, or an assembly that it is a part of.
vtkOpenGLRenderer* rendererShowing(vtkProp& prop)
{
    for (int i = 0; i < prop.GetNumberOfConsumers(); ++i) {
        vtkObject* const consumer = prop.GetConsumer(i);
        auto* renderer = vtkOpenGLRenderer::SafeDownCast(consumer);
        if (auto* whole = vtkProp::SafeDownCast(consumer)) renderer = rendererShowing(*whole);
        vtkRenderWindow* const window = renderer ? renderer->GetRenderWindow() : nullptr;
        if (window && window->IsCurrent()) return renderer;
    }
    return nullptr;
}

}  // namespace

vtkStandardNewMacro(vtkFbrdfRendererProbe);

vtkFbrdfRendererProbe::vtkFbrdfRendererProbe()
{
    CubeMapOn();
}

vtkFbrdfRendererProbe::~vtkFbrdfRendererProbe() = default;

vtkFbrdfRendererProbe& vtkFbrdfRendererProbe::in(vtkActor& actor)
{
    vtkProperty* const property = actor.GetProperty();
    if (auto* probe = SafeDownCast(property->GetTexture(kName))) return *probe;
    vtkSmartPointer<vtkFbrdfRendererProbe> probe = vtkSmartPointer<vtkFbrdfRendererProbe>::New();
    property->SetTexture(kName, probe);
    return *probe;
}

vtkOpenGLRenderer* vtkFbrdfRendererProbe::rendererOf(vtkActor& actor)
{
    auto* known = vtkOpenGLRenderer::SafeDownCast(in(actor).renderer_);
    return known ? known : rendererShowing(actor);
}

void vtkFbrdfRendererProbe::deactivateLater(vtkTextureObject& texture)
{
    active_.emplace_back(&texture);
}

void vtkFbrdfRendererProbe::Render(vtkRenderer* renderer)
{
    renderer_ = renderer;
    const bool isInEnvironment = vtkFbrdfEnvironmentTexture::isOn(*renderer);
    if (isInEnvironment == isInEnvironment_) return;
    isInEnvironment_ = isInEnvironment;
    for (const auto& material : materials_)
        if (material) material->GetInternals().shaderTime.Modified();
}

void vtkFbrdfRendererProbe::addMaterial(vtkFbrdfMaterial& material)
{
    if (std::find(materials_.begin(), materials_.end(), &material) == materials_.end())
        materials_.emplace_back(&material);
}

void vtkFbrdfRendererProbe::PostRender(vtkRenderer*)
{
    for (const auto& texture : active_) texture->Deactivate();
    active_.clear();
    renderer_ = nullptr;
}
