// LightTexture.h - the lights of a renderer as a texture that all materials of its actors read. It
// lives with the renderer, and is filled again when a light or the camera has changed.
#pragma once
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

class vtkInformationObjectBaseKey;
class vtkOpenGLRenderer;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;

class vtkFbrdfLightTexture : public vtkObject {
public:
    static vtkFbrdfLightTexture* New();
    vtkTypeMacro(vtkFbrdfLightTexture, vtkObject);

    /// That of the renderer, up to date. The window of the renderer is current.
    static vtkFbrdfLightTexture& of(vtkOpenGLRenderer& renderer);

    vtkTextureObject& texture() { return *texture_; }
    int count() const { return count_; }
    int dropped() const { return dropped_; }
    /// Expects that the texture is active.
    void setUniforms(vtkShaderProgram& program);

    static vtkInformationObjectBaseKey* LIGHTS();

protected:
    vtkFbrdfLightTexture();
    ~vtkFbrdfLightTexture() override;

private:
    void update(vtkOpenGLRenderer& renderer);
    bool isCurrent(vtkOpenGLRenderer& renderer) const;

    vtkNew<vtkTextureObject> texture_;
    vtkWeakPointer<vtkCamera> camera_;
    unsigned long long time_ = 0;
    int count_ = 0, attenuated_ = 0, dropped_ = 0;
};
