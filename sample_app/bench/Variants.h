// Variants.h - everything that is timed: each technique and form of the runtime, and the peers.
#pragma once
#include "bench/Stage.h"
#include "viewer/GlFunctions.h"

#include <functional>
#include <string>
#include <vector>

namespace fbrdf::bench {

/// Where a variant draws. It must outlive every drawing made from it.
struct Scene {
    const GladGLContext& gl;
    gl::Renderer& renderer;
    Stage stage;
    std::vector<Light> lights;
    gl::Target target;
};

using Draw = std::function<void()>;

/// What a pixel computes and fetches for each light, by the rule of ShaderCost.h: all passes with
/// what they do once, divided by the lights. Bytes are those of the texels that a look-up mixes
/// (four of a plane, eight of a volume), as they were uploaded, and of surfaces that a pass reads;
/// caches make fewer of them. Blending is not included.
struct LightCost {
    double multiplyAdds = 0.0, specials = 0.0, bytes = 0.0;
};

struct Variant {
    std::string name, description;
    /// Uploads and compiles; the result draws one frame into the scene's target.
    std::function<Draw(const Scene& scene)> make;
    std::function<LightCost(const Scene& scene)> cost;
};

/// `ggx` comes first, then the other peers, then "FORM TECHNIQUE" for each form and technique of
/// the runtime.
std::vector<Variant> allVariants();

}  // namespace fbrdf::bench
