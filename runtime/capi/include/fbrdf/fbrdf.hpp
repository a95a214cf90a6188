// fbrdf.hpp - fbrdf.h for C++: handles that release what they own. Header only; nothing throws.
// Lifetimes and threads are those of fbrdf.h.
//     fbrdf::abi::Renderer renderer;
//     if (renderer.create(fbrdf_renderer_create, &desc) != FBRDF_RESULT_OK) ...
//     fbrdf_draw(renderer.get(), &draw, nullptr);
#pragma once
#include <fbrdf/fbrdf.h>

#include <utility>

namespace fbrdf::abi {

/// Owns one handle; moves, does not copy, is empty at first.
template <class T, void (*release)(T*)>
class Handle {
public:
    Handle() = default;
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept
    {
        if (this != &other) {
            reset();
            handle_ = std::exchange(other.handle_, nullptr);
        }
        return *this;
    }

    T* get() const { return handle_; }
    explicit operator bool() const { return handle_ != nullptr; }
    void reset() { release(std::exchange(handle_, nullptr)); }

    /// Calls a function whose last parameter is T** with the arguments before it. On failure the
    /// handle keeps what it owned before.
    template <class... Parameters, class... Arguments>
    [[nodiscard]] fbrdf_result create(fbrdf_result (*function)(Parameters...),
                                      Arguments... arguments)
    {
        T* made = nullptr;
        const fbrdf_result result = function(arguments..., &made);
        if (result == FBRDF_RESULT_OK) {
            reset();
            handle_ = made;
        }
        return result;
    }

private:
    T* handle_ = nullptr;
};

using Material = Handle<fbrdf_material, fbrdf_material_release>;
using Renderer = Handle<fbrdf_renderer, fbrdf_renderer_release>;
using GpuMaterial = Handle<fbrdf_gpu_material, fbrdf_gpu_material_release>;
using Mesh = Handle<fbrdf_mesh, fbrdf_mesh_release>;
using Library = Handle<fbrdf_library, fbrdf_library_release>;
using Hooks = Handle<fbrdf_hooks, fbrdf_hooks_release>;
using Environment = Handle<fbrdf_environment, fbrdf_environment_release>;
using Binding = Handle<fbrdf_binding, fbrdf_binding_release>;

/// A descriptor of zeros with its size set.
template <class T>
T describe()
{
    T descriptor{};
    descriptor.struct_size = static_cast<uint32_t>(sizeof(T));
    return descriptor;
}

}  // namespace fbrdf::abi
