// MapTextures.h - a material in one window: its maps as textures, the GLSL that evaluates it there,
// or why the window cannot draw it.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/shaders/TextureImage.h>

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkWeakPointer.h>

#include <string>
#include <vector>

class vtkShaderProgram;

namespace fbrdf::vtk {

/// "texture units: found 8, expected at least 9".
std::string tooFew(const std::string& what, int needed, int limit);

/// Why the fragment shader, but for its version, does not compile in the context that is current;
/// empty where it does. VTK draws nothing with one that does not.
std::string whyNotCompiled(const std::string& fragment);

class MapTextures {
public:
    /// The window is current.
    MapTextures(const Material& material, bool precise, vtkOpenGLRenderWindow& window);

    /// False where the window, or its context, has gone since.
    bool isAlive() const;
    bool isIn(vtkOpenGLRenderWindow& window) const { return window_ == &window && isAlive(); }
    /// Why the window cannot draw the material; empty where it can.
    const std::string& refusal() const { return refusal_; }
    /// materialFunctions of ShaderSource.h with the lights of lights.glsl, and shade.glsl. lobes:
    /// those that an environment lights; null: none do.
    const std::string& functions(const LobeTable* lobes = nullptr);
    /// Why lobes cannot be drawn in addition; empty where they can.
    const std::string& whyNoLobes(const LobeTable& lobes);

    /// Those that take a texture unit, in the order of the tables.
    const std::vector<vtkSmartPointer<vtkTextureObject>>& textures() const { return textures_; }
    /// Expects that the textures are active.
    void setUniforms(vtkShaderProgram& program, const std::vector<Vec3f>& scales) const;

private:
    struct Map {
        vtkTextureObject* texture = nullptr;  ///< null: knots
        std::vector<Vec3f> knots;
        Vec3f lower{0.0f}, extent{1.0f};
        bool ranged = false;
    };

    Map mapOf(const Table& table, const TextureImage& image, bool precise,
              vtkOpenGLRenderWindow& window);
    void makeMaps(const Material& material, bool precise, vtkOpenGLRenderWindow& window);
    std::string written(const LobeShare& lobes) const;

    vtkWeakPointer<vtkOpenGLRenderWindow> window_;
    std::vector<vtkSmartPointer<vtkTextureObject>> textures_;
    std::vector<Map> maps_;
    std::vector<TableEncoding> encodings_;
    Form form_;
    int freeVectors_ = 0;  ///< of uniforms, for lobes
    std::string functions_, refusal_, lobeFunctions_, lobeRefusal_;
};

}  // namespace fbrdf::vtk
