// Variants.h - everything that is timed: each technique and form of the runtime, and the peers.
#pragma once
#include "bench/LightCost.h"
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
    std::function<LightCost(const Scene& scene)> cost;
};

/// How a material is drawn beside its technique: "", "parabolic", "cube" (recombined maps) or
/// "precise" (filtered in the shader). Throws Error(usage) for another word.
gl::MaterialOptions materialOptionsFromWord(const std::string& word);

/// `ggx` comes first, then the other peers, then "FORM TECHNIQUE" for each form (Materials.h) and
/// technique of the runtime, then "FORM WORD single" for some that materialOptionsFromWord changes.
std::vector<Variant> allVariants();

/// The variants that a name stands for: one of allVariants(), or "FORM", "FORM WORD",
/// "FORM TECHNIQUE" or "FORM WORD TECHNIQUE" of any form, without a technique in all of them.
/// Throws Error(usage) for anything else.
std::vector<Variant> variantsNamed(const std::string& name);

}  // namespace fbrdf::bench
