// Renderer.h - draws materials in an OpenGL context that somebody else made.
//
// A renderer belongs to one GL context. Every call needs that context current on the calling
// thread, the destructors of the renderer and of its handles (Handles.h) included. It links no GL:
// functions come from the loader that the host hands in. There are no globals: any number of
// renderers, contexts and threads may exist side by side. No GL header is included here, so this
// one can follow or precede any.
//
// Colour is linear inside. The target receives the radiance (docs/method.md, Eq. 2), or what its
// Transfer makes of it, and alpha 1 where something was drawn.
//
// State. What a draw touches, StateMode says what becomes of it:
//   program; vertex array and array buffer (below OpenGL 3.0 also attributes 0 to 7 and the element
//   buffer); the current value of attribute 2; draw framebuffer; viewport 0, depth range 0; depth
//   test, function, mask and clear value; blending of draw buffer 0; colour masks; scissor 0;
//   culling, stencil test, logic op, dither, polygon mode, offset, smooth and stipple, alpha test,
//   alpha to coverage and to one, sample coverage and mask, clip distances, rasterizer discard,
//   FRAMEBUFFER_SRGB, primitive restart (both), depth clamp, fragment colour clamp, clip control,
//   and of extensions depth bounds, conservative rasterization, shading rates, exclusive scissor
//   and raster multisampling; the active unit and, on the units in use, 2D, 3D, array, cube and
//   buffer texture and sampler; seamless cube maps, where maps are cube maps or there is an
//   environment; where the GPU makes lists of lights, storage buffers 0 to 2 and the one without an
//   index.
// createX also touches unpacking, pixel transfer, the unpack buffer and the renderbuffer; the first
// materials, for which filters are measured (FilterPrecision), also packing, the pack buffer and
// the read framebuffer. createEnvironment draws, and so touches both lists. In every mode no vertex
// array of the renderer stays bound. An active transform feedback, conditional rendering and
// queries are not touched.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/gl/Draw.h>
#include <fbrdf/gl/Hooks.h>
#include <fbrdf/gl/MaterialOptions.h>
#include <fbrdf/gl/MeshData.h>
#include <fbrdf/gl/PassWatch.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Light.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::gl {

/// Looks a GL function up by name: a wrapper of glfwGetProcAddress, eglGetProcAddress, ... May
/// return null for what does not exist. Called in the constructor of a renderer only.
using LoadFunction = void* (*)(void* user, const char* name);

enum class Severity { note, warning, error };

/// What becomes of the state that calls touch (listed above).
enum class StateMode {
    restore,  ///< put back; costs one query for each state and call
    /// Left as in a new context, without queries; the viewport stays the target's.
    defaults,
    leave,  ///< left as the call used it, without queries: for a host that sets what it needs
};

struct RendererOptions {
    LoadFunction load = nullptr;
    void* loadUser = nullptr;
    /// Called for every problem that a draw survives; may be empty. The library never prints. A
    /// problem that every frame would report is reported once.
    std::function<void(Severity, const std::string& text)> log;
    PassWatch passes = {};    ///< told of each pass of a draw
    bool debugLabels = true;  ///< KHR_debug names and groups, where the context has them
    StateMode state = StateMode::restore;
    /// Texture units from this one on are used: one for each map, and one for a surface that is
    /// read.
    int firstTextureUnit = 0;
    /// Programs that living materials have needed and the last 256 draws did not: beyond so many
    /// those that have not been used longest are deleted, and built again where they are needed.
    size_t idlePrograms = 256;
    /// Taken instead of what the context reports: for tests and for drivers that promise too much.
    std::optional<Capabilities> capabilities;
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
    /// Error(gl) where GL cannot store it, Error(usage) for options out of range.
    std::shared_ptr<GpuMaterial> createMaterial(const Material& material,
                                                const MaterialOptions& options = {});
    /// Copies the arrays. Throws Error(input) for arrays that do not agree, Error(gl) where GL
    /// cannot store them.
    std::shared_ptr<GpuMesh> createMesh(const MeshData& mesh);
    /// Binds buffers that the host has. Throws Error(input) for arrays that end beyond their
    /// buffers or are missing, Error(gl) for names that are no buffers.
    std::shared_ptr<GpuMesh> createMesh(const MeshBuffers& mesh);

    /// Prefilters a panorama, by drawing where the context can draw cubes of floats and else on the
    /// CPU, with a note; one wider than textures may be is made smaller. Throws Error(input) for an
    /// invalid panorama, Error(usage) for a size that is none, Error(gl) where GL cannot store it.
    std::shared_ptr<GpuEnvironment> createEnvironment(const Panorama& panorama,
                                                      const EnvironmentOptions& options = {});
    /// The same for radiance that is on the GPU already. Throws Error(gl) for a name that is no
    /// such texture and where GL cannot draw cubes of floats.
    std::shared_ptr<GpuEnvironment> createEnvironment(const HostEnvironment& source,
                                                      const EnvironmentOptions& options = {});
    /// Uploads what prefiltered() has made (Prefilter.h). Throws Error(input) for a cube that is
    /// none, else as above.
    std::shared_ptr<GpuEnvironment> createEnvironment(const CubeImage& prefiltered,
                                                      const EnvironmentOptions& options = {});

    /// Draws about `texels` (>= 1) texels more of an environment that was created to come
    /// gradually, its sharpest lobes last, and returns whether it is finished. All of one with
    /// faces of N texels are 8 N^2, and each costs hundreds of look-ups. Throws Error(usage) for an
    /// environment of another renderer, Error(gl) where GL fails.
    bool refine(GpuEnvironment& environment, long long texels);

    /// Throws Error(input) for hooks that do not compile, with the compiler's words.
    std::shared_ptr<GpuHooks> createHooks(const Hooks& hooks);

    /// Packs the maps of materials that differ in numbers only (sameLayout, PackedParameters.h)
    /// into texture arrays, so that one program and one bind draw them all; this needs OpenGL 3.1.
    /// Materials that cannot be packed have textures of their own, see GpuLibrary::whyNotPacked.
    /// Recombined maps are not packed. Throws as createMaterial, naming the index.
    std::shared_ptr<GpuLibrary> createLibrary(const std::vector<Material>& materials,
                                              const MaterialOptions& options = {});
    /// Puts another material, of whatever layout, into the place of one. Throws Error as
    /// createMaterial; the library then keeps the material that it has.
    void replaceMaterial(GpuLibrary& library, int index, const Material& material);

    /// Builds the programs that draws of the material with these options and this number of lights
    /// will need, and so keeps the first draw from waiting for a compiler. It knows neither mesh
    /// nor target: the programs are those of a plain item (without hooks and normal map, on a mesh
    /// with tangents) in a linear RGBA32F target. With an environment it waits for the lobes of a
    /// material that has none. Throws Error(gl).
    void prepare(const GpuMaterial& material, const DrawOptions& options, int lights);
    /// The same with the hooks and the normal map of an item, and with tangents derived where its
    /// mesh has none.
    void prepare(const Item& item, const DrawOptions& options, int lights);

    /// Draws the items into the target, in front of what its depth buffer contains (View::depth).
    /// Throws Error(gl) for a target that cannot be drawn to or a clip control that is missing,
    /// Error(usage) for options out of range; nothing is drawn then. Everything else is survived:
    /// an item that cannot be drawn is left out, logged and counted; a technique that the form or
    /// the target rules out is replaced by `single` with a warning. Lights that are left out are
    /// counted, never silent.
    DrawStats draw(const Target& target, const View& view, const std::vector<Item>& items,
                   const std::vector<Light>& lights, const DrawOptions& options = {});

    /// The same for all objects of a batch: one draw call for each pass and for all objects that
    /// share a layout, whose lights are culled, sorted and capped by the bounds of them all.
    /// Objects of materials that are not packed are drawn one by one, with a warning.
    DrawStats drawBatch(const Target& target, const View& view, const Batch& batch,
                        const std::vector<Light>& lights, const DrawOptions& options = {});

    /// To be called when the context is gone: forgets every GL object without touching GL. Later
    /// calls throw Error(gl); destructors are safe.
    void abandonContext() noexcept;

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf::gl
