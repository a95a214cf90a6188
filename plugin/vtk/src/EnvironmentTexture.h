// EnvironmentTexture.h - the environment of a renderer (vtkRenderer::SetEnvironmentTexture, on
// where UseImageBasedLighting is) as the cube that materials look up: prefiltered once, by drawing,
// and again when the picture is another one. It lives with the renderer.
#pragma once
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkTexture.h>
#include <vtkWeakPointer.h>

#include <string>

class vtkInformationObjectBaseKey;
class vtkOpenGLRenderer;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;

class vtkFbrdfEnvironmentTexture : public vtkObject {
public:
    static vtkFbrdfEnvironmentTexture* New();
    vtkTypeMacro(vtkFbrdfEnvironmentTexture, vtkObject);

    /// True where the renderer is lit by an environment.
    static bool isOn(vtkRenderer& renderer);
    /// That of the renderer, not necessarily up to date.
    static vtkFbrdfEnvironmentTexture& in(vtkRenderer& renderer);
    /// The same, up to date. Expects that the environment is on, and the window current.
    static vtkFbrdfEnvironmentTexture& of(vtkOpenGLRenderer& renderer);

    /// Why there is no cube; empty where there is one.
    const std::string& whyNot() const { return whyNot_; }
    vtkTextureObject& texture() { return *texture_; }
    /// Expects that the texture is active. exposure multiplies the radiance.
    void setUniforms(vtkShaderProgram& program, vtkOpenGLRenderer& renderer, float exposure);

    /// Texels on a side of a face, a power of two from 8 on; 0: as the runtime chooses.
    void setFaceSize(int size) { faceSize_ = size; }

    static vtkInformationObjectBaseKey* ENVIRONMENT();

protected:
    vtkFbrdfEnvironmentTexture();
    ~vtkFbrdfEnvironmentTexture() override;

private:
    bool isCurrent(vtkOpenGLRenderer& renderer) const;
    void update(vtkOpenGLRenderer& renderer);
    void make(vtkOpenGLRenderer& renderer, vtkTexture& picture);

    vtkNew<vtkTextureObject> texture_;
    vtkWeakPointer<vtkTexture> picture_;
    vtkWeakPointer<vtkOpenGLRenderWindow> window_;
    unsigned long long time_ = 0;
    int faceSize_ = 0, madeSize_ = 0, size_ = 0;
    bool isCube_ = false;
    std::string whyNot_;
};
