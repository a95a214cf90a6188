// Renderer.h - draws materials in an OpenGL context that somebody else made.
//
// A Renderer belongs to one GL context; every call needs that context current on the calling
// thread. It links no GL: functions come from the loader handed to it. It touches only the state
// listed in README.md and puts it back. Colour is linear; the target receives radiance (seed Eq.
// 2), alpha 1 where something was drawn. No GL header is included here, so this one can follow or
// precede any.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fbrdf::gl {

/// Looks a GL function up by name: eglGetProcAddress, OSMesaGetProcAddress, glfwGetProcAddress, ...
using LoadFunction = void* (*)(void* user, const char* name);

enum class Severity { note, warning, error };

struct RendererOptions {
    LoadFunction load = nullptr;
    void* loadUser = nullptr;
    /// Called for every problem that a draw survives; may be empty. The library never prints.
    std::function<void(Severity, const std::string& text)> log;
    bool debugLabels = true;  ///< KHR_debug names and groups, where the context has them
};

/// Triangles of one object. Arrays are as long as positions, or empty where said. Object space.
struct MeshData {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;     ///< unit
    std::vector<Vec3f> tangents;    ///< unit; may be empty for isotropic materials
    std::vector<uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
};

class GpuMaterial;  ///< textures and programs of one Material
class GpuMesh;      ///< buffers of one MeshData

struct Item {
    const GpuMaterial* material = nullptr;
    const GpuMesh* mesh = nullptr;
    glm::mat4 model{1.0f};
};

struct View {
    glm::mat4 view{1.0f}, projection{1.0f};  ///< OpenGL's: camera looks along -z, depth in [-1, 1]
};

/// A colour buffer with depth that the host owns. Its internal format decides what accumulation can
/// be done in place.
struct Target {
    uint32_t framebuffer = 0;
    int width = 0, height = 0;
};

struct DrawOptions {
    Technique technique = Technique::single;
};

struct DrawStats {
    int passes = 0;  ///< of the item that needed most
    int drawCalls = 0;
    int lightsGiven = 0, lightsUsed = 0, lightsDropped = 0;
    int maxLookups = 0;  ///< texture look-ups executed by a fragment in any one pass, counted from
                         ///< the linked programs
    std::string accumulation;  ///< "RGBA32F", ...
};

class Renderer {
public:
    /// Throws Error(gl) naming what is missing: a loader that yields nothing, a version below 2.1,
    /// ...
    explicit Renderer(const RendererOptions& options);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const std::string& glRenderer() const;
    const std::string& glVersion() const;

    /// Throws Error(input) for an invalid material, Error(gl) where GL cannot hold it.
    std::shared_ptr<GpuMaterial> createMaterial(const Material& material);
    std::shared_ptr<GpuMesh> createMesh(const MeshData& mesh);

    /// Adds the items to the target (depth test LESS against what is there). Throws Error(gl) on a
    /// target that cannot be drawn to; nothing is drawn then. Dropped lights are counted, never
    /// silent.
    DrawStats draw(const Target& target, const View& view, const std::vector<Item>& items,
                   const std::vector<Light>& lights, const DrawOptions& options = {});

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf::gl
