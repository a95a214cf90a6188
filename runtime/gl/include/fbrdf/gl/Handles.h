// Handles.h - what a renderer makes of a host's data: materials, meshes, libraries of materials and
// hooks, as objects of its context.
//
// Lifetime. A draw reads what its items and batches point to until it returns; a handle may be
// released right after, for OpenGL keeps what pending commands need. A handle may outlive its
// renderer. Its last owner must release it with the context current, or after
// Renderer::abandonContext. Nothing refers to the data that a handle was made from.
//
// Threads. A handle belongs to the context of its renderer and to the thread on which that is
// current; nothing is locked. Only whyNotRecombined, lookUpError, filterError, name and the like
// may be called from any thread.
#pragma once
#include <fbrdf/plan/LightSelection.h>

#include <cstddef>
#include <memory>
#include <string>

namespace fbrdf::gl {

class MaterialResources;
class MeshResources;
class LibraryResources;
class CompiledHooks;

/// A Material on the GPU: its tables as textures and uniforms. Programs belong to the renderer,
/// which deletes them when no material needs them.
class GpuMaterial {
public:
    explicit GpuMaterial(std::shared_ptr<const MaterialResources> resources)
        : resources_(std::move(resources))
    {
    }
    GpuMaterial(const GpuMaterial&) = delete;
    GpuMaterial& operator=(const GpuMaterial&) = delete;

    /// The name of the material, or that of its form where it has none.
    const std::string& name() const;
    /// Why maps are looked up natively although MaterialOptions said otherwise; empty where none
    /// are.
    const std::string& whyNotRecombined() const;
    /// How far products may be from those of the tables because maps are recombined, |log2|; 0
    /// where none are.
    double lookUpError() const;
    /// How far they may be because the context filters textures coarsely, |log2|: as measured, or 0
    /// where the shader filters (MaterialOptions::precise).
    double filterError() const;

    const MaterialResources& resources() const { return *resources_; }  ///< for the renderer

private:
    std::shared_ptr<const MaterialResources> resources_;
};

/// A mesh: buffers of its own (MeshData), or those of the host (MeshBuffers).
class GpuMesh {
public:
    explicit GpuMesh(std::shared_ptr<const MeshResources> resources)
        : resources_(std::move(resources))
    {
    }
    GpuMesh(const GpuMesh&) = delete;
    GpuMesh& operator=(const GpuMesh&) = delete;

    /// A sphere that contains the positions, in object space.
    const Sphere& bounds() const;

    const MeshResources& resources() const { return *resources_; }  ///< for the renderer

private:
    std::shared_ptr<const MeshResources> resources_;
};

/// Many materials. Those that differ in numbers only are packed into texture arrays, and a batch
/// draws all objects that have them in one call.
class GpuLibrary {
public:
    explicit GpuLibrary(std::shared_ptr<LibraryResources> resources)
        : resources_(std::move(resources))
    {
    }
    GpuLibrary(const GpuLibrary&) = delete;
    GpuLibrary& operator=(const GpuLibrary&) = delete;

    size_t size() const;  ///< number of materials
    /// Why some materials are not in arrays, and their objects drawn one by one; empty where all
    /// are.
    const std::string& whyNotPacked() const;

    const LibraryResources& resources() const { return *resources_; }  ///< for the renderer
    LibraryResources& resources() { return *resources_; }              ///< for the renderer

private:
    std::shared_ptr<LibraryResources> resources_;
};

/// Hooks that compile in the context. What Hooks::setUniforms captures lives as long as this.
class GpuHooks {
public:
    explicit GpuHooks(std::shared_ptr<const CompiledHooks> compiled)
        : compiled_(std::move(compiled))
    {
    }
    GpuHooks(const GpuHooks&) = delete;
    GpuHooks& operator=(const GpuHooks&) = delete;

    const CompiledHooks& compiled() const { return *compiled_; }  ///< for the renderer

private:
    std::shared_ptr<const CompiledHooks> compiled_;
};

}  // namespace fbrdf::gl
