#include "CompiledHooks.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/plan/LightVectors.h>

#include <algorithm>

namespace fbrdf::gl {

SurfaceInputs SurfaceOptions::inputs(bool instanced) const
{
    SurfaceInputs inputs;
    inputs.instanced = instanced;
    inputs.derivedTangent = derivedTangent;
    inputs.normalMap = normalMap != 0;
    if (hooks) {
        inputs.vertexHook = hooks->get().vertex;
        inputs.shadowHook = hooks->get().shadow;
    }
    return inputs;
}

SurfaceOptions surfaceOptions(const MeshResources& mesh, const MaterialResources& material,
                              const CompiledHooks* hooks, GLuint normalMap)
{
    if (normalMap != 0 && !mesh.has(kTextureCoordinate))
        throw Error(ErrorKind::usage, "item",
                    Found("a normal map on a mesh without texture coordinates").expected("them"));
    const bool needsFrame = normalMap != 0 || material.isAnisotropic();
    return {hooks, normalMap, needsFrame && !mesh.hasTangents() && mesh.has(kTextureCoordinate)};
}

// With a shadow hook each light has a number beside its vectors. In the worst case the number takes
// a uniform vector of its own.
Capabilities remaining(Capabilities capabilities, const CompiledHooks* hooks)
{
    if (!hooks || hooks->get().shadow.empty()) return capabilities;
    const int room = std::max(0, capabilities.maxUniformVectors - hooks->get().shadowUniforms);
    capabilities.maxUniformVectors = room * kVectorsPerLight / (kVectorsPerLight + 1);
    return capabilities;
}

Sphere reached(const Sphere& bounds, const CompiledHooks* hooks)
{
    if (!hooks || hooks->get().vertex.empty()) return bounds;
    return {bounds.centre, bounds.radius + hooks->get().reach};
}

}  // namespace fbrdf::gl
