// Renderer.h - draws materials in an OpenGL context that somebody else made.
//
// A Renderer belongs to one GL context; every call needs that context current on the calling
// thread, the destructors of renderer, materials and meshes included. It links no GL: functions
// come from the loader handed to it. It touches only the state listed in README.md and puts it
// back. Colour is linear inside; the target receives radiance (seed Eq. 2), or what its Output
// makes of it, alpha 1 where something was drawn. There are no globals: any number of renderers,
// contexts and threads may live side by side. No GL header is included here, so this one can follow
// or precede any.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/gl/Depth.h>
#include <fbrdf/gl/MaterialOptions.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::gl {

/// Looks a GL function up by name: HeadlessContext::loader(), or a wrapper of glfwGetProcAddress,
/// eglGetProcAddress, ... May return null for what does not exist.
using LoadFunction = void* (*)(void* user, const char* name);

enum class Severity { note, warning, error };

/// What becomes of the state that calls touch (README.md lists it).
enum class StateMode {
    restore,   ///< put back; costs one query a state and call
    defaults,  ///< left as in a new context, but for the viewport, which stays the target's; no
               ///< queries
    leave,     ///< left as the README says: for a host that sets what it needs; no queries
};

struct RendererOptions {
    LoadFunction load = nullptr;
    void* loadUser = nullptr;
    /// Called for every problem that a draw survives; may be empty. The library never prints.
    std::function<void(Severity, const std::string& text)> log;
    bool debugLabels = true;  ///< KHR_debug names and groups, where the context has them
    StateMode state = StateMode::restore;
    int firstTextureUnit = 0;  ///< units from here on are used and put back; one a map, and one
    /// Instead of what the context reports: for tests and for drivers that promise too much.
    std::optional<Capabilities> capabilities;
};

/// Triangles of one object. Arrays are as long as positions, or empty where said. Object space.
struct MeshData {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;  ///< need not be unit, must not be 0
    /// Need not be unit or orthogonal. May be empty: where a frame is needed it is then derived
    /// per pixel, towards increasing s of the texture coordinates; without those it is arbitrary.
    std::vector<Vec3f> tangents;
    std::vector<uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
    std::vector<glm::vec2> textureCoordinates = {};  ///< for normal maps and derived tangents
    std::vector<float> handedness = {};  ///< of given tangents: negative where s = -n x t, as under
                                         ///< mirrored texture coordinates; empty: s = n x t
    /// Up to kExtraArrays, for vertex hooks: fbrdfExtra0 is the first, ...
    std::vector<std::vector<glm::vec4>> extra = {};
};
constexpr size_t kExtraArrays = 4;

/// GLSL that the host puts into the programs of its objects, in the version of the context
/// (Capabilities::glsl): functions and what they need, without #version. Names that begin with
/// fbrdf are ours. In both, FBRDF_ATTRIBUTE and the other macros of version.glsl are defined.
struct Hooks {
    /// "": none. Defines  void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4
    /// tangent)  which moves a vertex in object space: skinning, morphing, wind. It may declare
    /// FBRDF_ATTRIBUTE vec4 fbrdfExtra0; (MeshData::extra).
    std::string vertex;
    /// Distance that it moves a vertex at most, object space: lights are culled by the bounds of
    /// the mesh and that. Infinity culls none.
    float reach = std::numeric_limits<float>::infinity();
    /// "": none. Defines  float fbrdfShadow(int light, vec3 position, vec3 toLight) : what passes
    /// of the light of that place in what draw() was given; eye space, toLight unit. Called above
    /// the horizon only, so it must not take derivatives. Its look-ups are not counted.
    std::string shadow;
    int shadowUniforms = 0;  ///< vec4 uniforms that `shadow` declares: so many fewer lights fit
    /// Sets the host's uniforms: called with the program current, once an item and program. May be
    /// empty. Its textures are bound by the host before the draw, to units outside of those that
    /// the renderer uses.
    std::function<void(uint32_t program)> setUniforms;
};

class GpuMaterial;  ///< textures and programs of one Material
class GpuMesh;      ///< buffers of one MeshData
class GpuLibrary;   ///< many materials: those of one layout draw in one call
class GpuHooks;     ///< Hooks that compile

struct Item {
    const GpuMaterial* material = nullptr;
    const GpuMesh* mesh = nullptr;
    glm::mat4 model{1.0f};  ///< invertible; may scale unevenly and mirror
    const GpuHooks* hooks = nullptr;
    /// Texture of the host (2D, sampled as its parameters say) or 0: 2 texel - 1 is the normal in
    /// the tangent frame, y along s. One more look-up in every pass, beyond
    /// DrawOptions::maxLookups.
    uint32_t normalMap = 0;
};

/// One object of a batch.
struct Instance {
    glm::mat4 model{1.0f};  ///< as of Item; affine
    int material = 0;       ///< index into the library
};

/// One mesh many times, each with a material of its own.
struct Batch {
    const GpuLibrary* library = nullptr;
    const GpuMesh* mesh = nullptr;
    std::vector<Instance> instances;
    const GpuHooks* hooks = nullptr;  ///< as of Item; the vertex hook may read gl_InstanceID
    uint32_t normalMap = 0;           ///< as of Item
};

struct View {
    /// The camera looks along -z; the view is rigid, the projection perspective or orthographic,
    /// and its far plane may be infinitely far.
    glm::mat4 view{1.0f}, projection{1.0f};
    /// What the projection and the depth buffer of the target agree on.
    DepthOptions depth = {};
};

/// A colour buffer with depth that the host owns: a framebuffer object, or 0 for the window's. Only
/// its first colour buffer is written. Its format decides whether lights add up in it (RGBA32F) or
/// in a surface of the renderer's own: RGBA32F, or RGBA8 where no float can be drawn to.
struct Target {
    uint32_t framebuffer = 0;
    int width = 0, height = 0;             ///< pixels, > 0; the viewport is all of it
    Transfer transfer = Transfer::linear;  ///< what is stored of the radiance
    float exposure = 1.0f;                 ///< > 0, finite
};

struct DrawOptions {
    Technique technique = Technique::single;
    int lightsPerPass = 8;  ///< Technique::batched only, >= 1
    int maxLookups = 0;     ///< texture look-ups in any pass; 0: what the technique says
    /// Of one item: the strongest at its bounds, others are dropped; with lists of lights, of one
    /// part of the view. 0: no limit.
    int maxLights = 0;
    /// Technique::single: lists of the lights that reach each part of the view, so that the cost
    /// follows the lights that reach a pixel, and uniforms set no limit. Built on the CPU for each
    /// draw; needs OpenGL 3.1, else it is as if false, with a warning.
    bool clustered = false;
};

struct DrawStats {
    int passes = 0;  ///< of the item that needed most; every time that the object is drawn counts
    int drawCalls = 0;    ///< of all items
    int itemsFailed = 0;  ///< not drawn; why was logged
    int lightsGiven = 0, lightsUsed = 0;
    int lightsDropped = 0;  ///< not valid (Light.h), or above maxLights for the item that lost
                            ///< most, or the part of the view
    int lightsCulled = 0;   ///< lights that do not reach an item, summed over items
    int maxLookups = 0;  ///< texture look-ups executed by a fragment in any one pass, counted from
                         ///< the linked programs: fetches, those in the light loop times its lights
    Technique technique = Technique::single;  ///< of the item that needed most passes
    std::string whyReplaced;   ///< why another technique than the one asked for was taken, or lists
                               ///< of lights were not; of the last item where it happened
    ErrorBound error;          ///< the largest of all items
    std::string accumulation;  ///< format of the surface in which lights add up: "RGBA32F", ...
};

class Renderer {
public:
    /// Throws Error(gl) naming what is missing: a loader that yields nothing, a version below 2.1
    /// or ES 2.0, a function, ...
    explicit Renderer(const RendererOptions& options);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const std::string& glRenderer() const;  ///< GL_RENDERER
    const std::string& glVersion() const;   ///< GL_VERSION
    const Capabilities& capabilities() const;

    /// Uploads the tables and builds the program of Technique::single for one light, so that a
    /// material that GL cannot draw is refused here. Throws Error(input) for an invalid material,
    /// Error(gl) where GL cannot hold it, Error(usage) for options out of range.
    std::shared_ptr<GpuMaterial> createMaterial(const Material& material,
                                                const MaterialOptions& options = {});
    /// Throws Error(input) for arrays that do not agree, Error(gl) where GL cannot hold them.
    std::shared_ptr<GpuMesh> createMesh(const MeshData& mesh);

    /// Throws Error(input) for hooks that do not compile, with the compiler's words.
    std::shared_ptr<GpuHooks> createHooks(const Hooks& hooks);

    /// Packs the maps of materials that differ in numbers only (sameLayout, PackedParameters.h)
    /// into texture arrays, so that one program and one bind draw them all; needs OpenGL 3.1. Where
    /// that cannot be, each material has textures of its own, see whyApart. Throws as
    /// createMaterial, naming the index. Recombined maps are not packed.
    std::shared_ptr<GpuLibrary> createLibrary(const std::vector<Material>& materials,
                                              const MaterialOptions& options = {});
    /// Another material in the place of one, of whatever layout. On failure, Error as of
    /// createMaterial, the library keeps the one it has.
    void replaceMaterial(GpuLibrary& library, int index, const Material& material);

    /// Builds the programs that a draw with these options and this number of lights will need, and
    /// so keeps the first draw from stopping for a compiler. Throws Error(gl).
    void prepare(const GpuMaterial& material, const DrawOptions& options, int lights);
    /// The same for an item with its hooks and normal map.
    void prepare(const Item& item, const DrawOptions& options, int lights);

    /// Draws the items into the target, in front of what its depth buffer contains
    /// (View::depth). Throws Error(gl) on a target that cannot be drawn to or a clip control that
    /// is missing, Error(usage) on options out of range; nothing is drawn then.
    /// Everything else is survived: an item that cannot be drawn is left out, logged and counted; a
    /// technique that the form or the target rules out is replaced by `single` with a warning.
    /// Lights left out are counted, never silent.
    DrawStats draw(const Target& target, const View& view, const std::vector<Item>& items,
                   const std::vector<Light>& lights, const DrawOptions& options = {});

    /// The same for all objects of a batch: one draw call a pass for all that share a layout, whose
    /// lights are culled, sorted and capped by the bounds of them all. Objects of materials that
    /// cannot be packed are drawn one by one, with a warning.
    DrawStats drawBatch(const Target& target, const View& view, const Batch& batch,
                        const std::vector<Light>& lights, const DrawOptions& options = {});

    /// The context is gone: forget every GL object without touching GL. Later calls throw
    /// Error(gl); destructors are safe.
    void abandonContext() noexcept;

    struct State;

private:
    std::unique_ptr<State> state_;
};

/// Why materials of a library are not in arrays; empty where all are.
const std::string& whyApart(const GpuLibrary& library);

}  // namespace fbrdf::gl
