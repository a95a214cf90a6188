#include "LightTexture.h"

#include "RendererObject.h"
#include "ViewLights.h"

#include <vtkCamera.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <vector>

namespace {

constexpr size_t kRow = 256;  // texels, as lights.glsl counts

std::vector<glm::vec4> texelsOf(const fbrdf::vtk::ViewLights& all)
{
    std::vector<glm::vec4> texels;
    for (const fbrdf::LightVectors& light : all.lights)
        texels.insert(texels.end(), light.begin(), light.end());
    texels.insert(texels.end(), all.attenuations.begin(), all.attenuations.end());
    texels.resize(kRow * ((texels.size() + kRow) / kRow));
    return texels;
}

}  // namespace

vtkStandardNewMacro(vtkFbrdfLightTexture);
vtkInformationKeyMacro(vtkFbrdfLightTexture, LIGHTS, ObjectBase);

vtkFbrdfLightTexture::vtkFbrdfLightTexture() = default;
vtkFbrdfLightTexture::~vtkFbrdfLightTexture() = default;

vtkFbrdfLightTexture& vtkFbrdfLightTexture::of(vtkOpenGLRenderer& renderer)
{
    auto& lights = fbrdf::vtk::objectOf<vtkFbrdfLightTexture>(renderer, *LIGHTS());
    lights.update(renderer);
    return lights;
}

bool vtkFbrdfLightTexture::isCurrent(vtkOpenGLRenderer& renderer) const
{
    return texture_->GetHandle() != 0 && texture_->GetContext() == renderer.GetRenderWindow() &&
           camera_ == renderer.GetActiveCamera() && fbrdf::vtk::lightsTime(renderer) <= time_;
}

void vtkFbrdfLightTexture::update(vtkOpenGLRenderer& renderer)
{
    if (isCurrent(renderer)) return;
    const fbrdf::vtk::ViewLights all = fbrdf::vtk::viewLights(renderer);
    std::vector<glm::vec4> texels = texelsOf(all);
    texture_->SetContext(vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow()));
    texture_->Create2DFromRaw(kRow, static_cast<unsigned int>(texels.size() / kRow), 4, VTK_FLOAT,
                              texels.data());
    camera_ = renderer.GetActiveCamera();
    time_ = fbrdf::vtk::lightsTime(renderer);
    count_ = static_cast<int>(all.lights.size());
    attenuated_ = static_cast<int>(all.attenuations.size());
    dropped_ = all.dropped;
}

void vtkFbrdfLightTexture::setUniforms(vtkShaderProgram& program)
{
    program.SetUniformi("vtkFbrdfLights", texture_->GetTextureUnit());
    program.SetUniformi("fbrdfLightCount", count_);
    program.SetUniformi("vtkFbrdfAttenuated", attenuated_);
}
