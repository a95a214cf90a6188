// ShadowHook.h - the GLSL by which programs dim lights: fbrdfShadow of SurfaceInputs::shadowHook.
#pragma once
#include "ReceivedShadows.h"

#include <string>

namespace osgFbrdf {

/// What dims lights beside the runtime's own falloff.
struct LightHooks {
    bool attenuated = false;  ///< some lights are, by attenuation.glsl (OsgLights.h)
    ShadowMaps shadows;

    /// True where the programs of passes have the hook, and the uniform fbrdfLightNumbers.
    bool any() const { return attenuated || !shadows.empty(); }
    std::string key() const { return (attenuated ? "a" : "") + shadows.key(); }
    /// vec4 uniforms of the hook, without what each light has.
    int uniformVectors() const;
};

/// "" where there is nothing to dim. Map k is read from the sampler osgFbrdfShadowMap<k>, with the
/// matrix osgFbrdfShadowMatrices[k]; a light's number is explained at kShadowBit.
std::string shadowHook(const LightHooks& hooks);

}  // namespace osgFbrdf
