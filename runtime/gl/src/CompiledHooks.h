// CompiledHooks.h - the host's code in our programs, and what else differs from object to object.
#pragma once
#include "MaterialResources.h"
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

    ~CompiledHooks() { device_->retiredHooks.push_back(id_); }
    CompiledHooks(const CompiledHooks&) = delete;
    CompiledHooks& operator=(const CompiledHooks&) = delete;

    const Device* device() const { return device_.get(); }
    uint64_t id() const { return id_; }  ///< unique on its device
    const Hooks& get() const { return hooks_; }

private:
    DevicePtr device_;
    uint64_t id_;
    Hooks hooks_;
};

/// What the programs of one object depend on beside its material.
struct SurfaceOptions {
    const CompiledHooks* hooks = nullptr;
    GLuint normalMap = 0;
    bool derivedTangent = false;

    SurfaceInputs inputs(bool instanced) const;
};

/// The options of an object of this material. Throws Error(usage) where the mesh lacks what a
/// normal map needs.
SurfaceOptions surfaceOptions(const MeshResources& mesh, const MaterialResources& material,
                              const CompiledHooks* hooks, GLuint normalMap);

/// The capabilities less the uniforms that the hooks take.
Capabilities remaining(Capabilities capabilities, const CompiledHooks* hooks);

/// The bounds enlarged by how far the hooks may move a vertex.
Sphere reached(const Sphere& bounds, const CompiledHooks* hooks);

}  // namespace fbrdf::gl
