// Draw.h - what one draw is about: items or a batch, a view, a target, options, and what came of
// it.
#pragma once
#include <fbrdf/gl/Depth.h>
#include <fbrdf/gl/Environment.h>
#include <fbrdf/gl/Handles.h>
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::gl {

/// One object. What the pointers point to must live until the draw returns.
struct Item {
    const GpuMaterial* material = nullptr;
    const GpuMesh* mesh = nullptr;
    glm::mat4 model{1.0f};            ///< invertible; may scale unevenly and mirror
    const GpuHooks* hooks = nullptr;  ///< may be null
    /// Name of a 2D texture of the host, sampled as its parameters say, or 0: 2 texel - 1 is the
    /// normal in the tangent frame, y along s. It costs one more look-up in every pass, beyond
    /// DrawOptions::maxLookups.
    uint32_t normalMap = 0;
};

/// One object of a batch.
struct Instance {
    glm::mat4 model{1.0f};  ///< affine and invertible
    int material = 0;       ///< index into the library
};

/// One mesh many times, each with a material of its own. Pointers as in Item.
struct Batch {
    const GpuLibrary* library = nullptr;
    const GpuMesh* mesh = nullptr;
    std::vector<Instance> instances;
    const GpuHooks* hooks = nullptr;  ///< as in Item; the vertex hook may read gl_InstanceID
    uint32_t normalMap = 0;           ///< as in Item
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
/// in a surface of the renderer's own. Surfaces belong to the framebuffer that they were made for
/// and are deleted in the next draw after the host deletes it or draws to it in another size.
struct Target {
    uint32_t framebuffer = 0;
    int width = 0, height = 0;  ///< pixels, > 0; the viewport is all of it
    /// What is stored of the radiance. The default suits float targets that the host maps to a
    /// display itself; in a window it is too dark, and Transfer::srgb is right.
    Transfer transfer = Transfer::linear;
    /// Multiplies the radiance before a curve of `transfer`, which must not be linear for that; > 0
    /// and finite.
    float exposure = 1.0f;
};

/// Who makes lists of lights (DrawOptions::clustered). automatic: the GPU where it has compute
/// shaders (OpenGL 4.3) and is one; a renderer in software makes them more slowly than the CPU does
/// otherwise.
enum class ListsBy { automatic, cpu, gpu };

struct DrawOptions {
    Technique technique = Technique::single;
    int lightsPerPass = 8;  ///< Technique::batched only, >= 1
    int maxLookups = 0;     ///< texture look-ups in any pass; 0: what the technique says
    /// Maximum number of lights, and of area lights, for each item or, with lists of lights, for
    /// each part of the view; the weakest are dropped. 0: unlimited.
    int maxLights = 0;
    /// Technique::single only: builds lists of the lights that reach each part of the view, so that
    /// the cost follows the lights that reach a pixel, and uniforms set no limit. They are made for
    /// each draw in which a light or a matrix has changed: by the GPU, or by up to four threads of
    /// the CPU (listsBy). They need OpenGL 3.1; without it lights are drawn as if this were false,
    /// with a warning. Up to 8 lights are drawn without lists, which is faster. Area lights have
    /// lists of their own, from 3 on.
    bool clustered = false;
    /// Light from everywhere, beside the lights. An item that cannot have it is drawn without, see
    /// DrawStats::whyNoEnvironment.
    EnvironmentLight environment = {};
    /// Lights with a shape, beside the others. Materials reflect them by their lobes, as they do an
    /// environment (EnvironmentLight::lobes limits both), without any look-up. A shadow hook
    /// receives the number of lights plus the index in this list, and the direction to the centre.
    std::vector<AreaLight> areaLights = {};
    /// The format of the surfaces in which lights add up; empty: the smallest one whose error is
    /// within sumTolerance of the target (Plan.h). One that cannot be had is replaced likewise.
    std::optional<ColourFormat> accumulation = {};
    /// Who makes the lists. What the GPU cannot make (a limit of lights, more than its buffers can
    /// have, a shader that does not compile) the CPU does, see DrawStats::whyListsByCpu; the
    /// picture is the same.
    ListsBy listsBy = ListsBy::automatic;
};

struct DrawStats {
    int passes = 0;                       ///< of the item that needed most
    int drawCalls = 0;                    ///< of all items
    int itemsFailed = 0;                  ///< not drawn; the reasons were logged
    int lightsGiven = 0, lightsUsed = 0;  ///< area lights included
    /// Lights that are not valid (Light.h, AreaLight.h) or above maxLights, for the item or the
    /// part of the view that lost most.
    int lightsDropped = 0;
    int lightsCulled = 0;  ///< lights that do not reach an item, summed over items
    /// Texture look-ups that a fragment executes in any one pass, counted from the linked programs:
    /// fetches, those in the light loop times its lights: those of the longest list or, where the
    /// GPU makes the lists, all that are seen.
    int maxLookups = 0;
    Technique technique = Technique::single;  ///< of the item that needed most passes
    Filter filter = Filter::hardware;         ///< of the maps of that item
    /// Why another technique than the one asked for was taken, or lists of lights were not; of the
    /// last item where that happened.
    std::string whyReplaced;
    ErrorBound error;             ///< the largest of all items
    std::string accumulation;     ///< format of the surface in which lights add up: "RGBA32F", ...
    std::string whyAccumulation;  ///< why that one, where there was a choice
    /// The largest LobeTable::error of the items whose lobes were drawn with an environment or area
    /// lights.
    double environmentError = 0.0;
    /// Items drawn without the environment or the area lights; the reasons were logged.
    int itemsWithoutEnvironment = 0;
    std::string whyNoEnvironment;  ///< of the last one of them
    /// Why an item was drawn by its lobes although EnvironmentLight::samples asks for directions;
    /// of the last item where that happened.
    std::string whyNotSampled;
    ListsBy listsBy = ListsBy::automatic;  ///< who made lists of lights; automatic: there are none
    std::string whyListsByCpu;             ///< where the CPU made them
};

}  // namespace fbrdf::gl
