// FbrdfPass.h - how a material enters the shaders of an actor: as one of the vtkOpenGLRenderPasses
// that the actor's property keys list, which every mapper asks when it writes a program and when it
// sets uniforms. It is no pass of a renderer.
#pragma once
#include <fbrdf/vtk/vtkFbrdfMaterial.h>

#include <vtkCommand.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>

class vtkActor;
class vtkFbrdfRendererProbe;
class vtkOpenGLRenderer;

class vtkFbrdfPass : public vtkOpenGLRenderPass {
public:
    static vtkFbrdfPass* New();
    vtkTypeMacro(vtkFbrdfPass, vtkOpenGLRenderPass);

    /// The pass keeps the material alive, and actors the pass.
    void setMaterial(vtkFbrdfMaterial& material) { material_ = &material; }
    vtkFbrdfMaterial* material() const { return material_; }
    /// That of an actor; null where it has none.
    static vtkFbrdfPass* of(vtkProp& prop);

    /// Puts the pass into the actor's keys, and again whenever the actor is given other keys (a
    /// vtkAssembly gives its own to its parts in every frame) or another property.
    void attach(vtkActor& actor);
    void detach(vtkActor& actor);

    void Render(const vtkRenderState*) override {}
    bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                vtkAbstractMapper* mapper, vtkProp* prop) override;
    bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                 vtkAbstractMapper* mapper, vtkProp* prop) override;
    bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                             vtkOpenGLVertexArrayObject* arrays) override;
    vtkMTimeType GetShaderStageMTime() override;

protected:
    vtkFbrdfPass();
    ~vtkFbrdfPass() override;

private:
    /// Why VTK has to draw the actor, now; empty where the material can be.
    std::string refusalOf(vtkActor& actor);
    /// The lobes that the renderer's environment lights; null where it has none, or with the
    /// reason.
    const fbrdf::LobeTable* lobesIn(vtkOpenGLRenderer& renderer, std::string& whyNot);
    void setEnvironment(vtkShaderProgram& program, vtkOpenGLRenderer& renderer,
                        vtkFbrdfRendererProbe& probe);
    void report(const std::string& reason, int lights, int dropped);
    void reportNoEnvironment(const std::string& reason);

    vtkSmartPointer<vtkFbrdfMaterial> material_;
    std::map<vtkActor*, vtkSmartPointer<vtkCommand>> observers_;
    // Of the program that is being written.
    bool isLeft_ = false;  ///< to VTK
    std::string refusal_, whyNoEnvironment_;
};
