// LightCost.h - what a pixel computes and fetches for each light, of the runtime and of peers.
#pragma once
#include "bench/ShaderPeer.h"

#include <fbrdf/brdf/Material.h>
#include <fbrdf/gl/MaterialOptions.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/shaders/TextureImage.h>

#include <vector>

namespace fbrdf::bench {

/// By the rule of ShaderCost.h: all passes with what they do once, divided by the lights. Bytes are
/// those of the texels that a look-up mixes (four of a plane, eight of a volume), as they were
/// uploaded, and of surfaces that a pass reads; caches make fewer of them. Blending is not
/// included.
struct LightCost {
    double multiplyAdds = 0.0, specials = 0.0, bytes = 0.0;
};

/// A material as the renderer uploads it, of which the cost is asked: recombining maps takes long.
struct UploadedMaterial {
    Form form;
    bool signs = false;                ///< hasSigns of the material
    std::vector<TextureImage> images;  ///< one for each table; empty for knots in uniforms
};
UploadedMaterial uploadedMaterial(const Material& material, const gl::MaterialOptions& options,
                                  const Capabilities& capabilities);

/// Of the passes that planPasses makes for a request with at least one light; zeros where there is
/// no plan. request.signs is taken from the material. capabilities: those it is uploaded for.
LightCost runtimeCost(const UploadedMaterial& material, PlanRequest request,
                      const Capabilities& capabilities);

/// lights: >= 1.
LightCost peerCost(const ShaderPeer& peer, int lights);

}  // namespace fbrdf::bench
