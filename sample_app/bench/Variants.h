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

struct Variant {
    std::string name, description;
    /// Uploads and compiles; the result draws one frame into the scene's target.
    std::function<Draw(const Scene& scene)> make;
};

/// `ggx` comes first, then the other peers, then "FORM TECHNIQUE" for each form and technique of
/// the runtime.
std::vector<Variant> allVariants();

}  // namespace fbrdf::bench
