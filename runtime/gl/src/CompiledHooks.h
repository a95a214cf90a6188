// CompiledHooks.h - code of the host in our programs, and what else differs from object to object.
#pragma once
#include "MeshResources.h"

#include <fbrdf/shaders/ShaderSource.h>

#include <string>

namespace fbrdf::gl {

class CompiledHooks {
public:
    CompiledHooks(const DevicePtr& device, const Hooks& hooks)
        : device_(device), id_(device->nextHooks++), hooks_(hooks)
    {
    }

    const Device* device() const { return device_.get(); }
    uint64_t id() const { return id_; }  ///< unique on its device
    const Hooks& get() const { return hooks_; }

private:
    DevicePtr device_;
    uint64_t id_;
    Hooks hooks_;
};

/// How the surface of one object is shaded beside its material.
struct SurfaceOptions {
    const CompiledHooks* hooks = nullptr;
    GLuint normalMap = 0;
    bool derivedTangent = false;

    /// Distinguishes the programs that need different texts.
    std::string key() const;
    SurfaceInputs inputs(bool instanced) const;
};

/// Of an object with this form. Throws Error(usage) where the mesh lacks what a normal map needs.
SurfaceOptions surfaceOptions(const MeshResources& mesh, const Form& form,
                              const CompiledHooks* hooks, GLuint normalMap);

/// What is left of them beside what the hooks take of uniforms.
Capabilities remaining(Capabilities capabilities, const CompiledHooks* hooks);

/// The bounds within which the hooks may move what was inside.
Sphere reached(const Sphere& bounds, const CompiledHooks* hooks);

}  // namespace fbrdf::gl
