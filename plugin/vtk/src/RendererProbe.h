// RendererProbe.h - tells who renders an actor. VTK's hooks for shaders know the actor but not the
// renderer, whose lights and camera the material needs; textures of a vtkProperty are handed the
// renderer before each draw. The probe is such a texture, without a picture: a cube map, as mappers
// multiply 2D textures into the colour.
#pragma once
#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkOpenGLTexture.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <vector>

class vtkActor;
class vtkOpenGLRenderer;
class vtkRenderer;
class vtkTextureObject;

class vtkFbrdfRendererProbe : public vtkOpenGLTexture {
public:
    static vtkFbrdfRendererProbe* New();
    vtkTypeMacro(vtkFbrdfRendererProbe, vtkOpenGLTexture);

    /// The probe in the property of the actor, which is put there where it is missing.
    static vtkFbrdfRendererProbe& in(vtkActor& actor);

    /// The renderer that draws the actor now. A property that came without a probe has not been
    /// handed it: then it is one that shows the actor, in the window that is being drawn.
    static vtkOpenGLRenderer* rendererOf(vtkActor& actor);

    /// Shaders of the material are written anew when an environment is switched on or off.
    void addMaterial(vtkFbrdfMaterial& material);

    /// Frees the texture's unit after the draw.
    void deactivateLater(vtkTextureObject& texture);

    void Render(vtkRenderer* renderer) override;
    void PostRender(vtkRenderer* renderer) override;
    void ReleaseGraphicsResources(vtkWindow*) override {}

protected:
    vtkFbrdfRendererProbe();
    ~vtkFbrdfRendererProbe() override;

private:
    vtkRenderer* renderer_ = nullptr;  ///< only while an actor is drawn
    std::vector<vtkSmartPointer<vtkTextureObject>> active_;
    std::vector<vtkWeakPointer<vtkFbrdfMaterial>> materials_;
    bool isInEnvironment_ = false;  ///< the renderer of the last draw
};
