// Boundary.h - what stands behind each handle, and how exceptions of the library become results and
// lines of the log.
#pragma once
#include "Descriptor.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/gl/MaterialBinding.h>
#include <fbrdf/gl/Renderer.h>

#include <map>
#include <memory>
#include <new>
#include <string>

namespace fbrdf::capi {

/// Every handle of a renderer shares this, so handles may be released in any order.
struct Shared {
    gl::Renderer renderer;
    fbrdf_log log{};
};
using SharedPtr = std::shared_ptr<Shared>;

}  // namespace fbrdf::capi

struct fbrdf_material {
    fbrdf::Material material;
};

struct fbrdf_renderer {
    fbrdf::capi::SharedPtr shared;
};

struct fbrdf_gpu_material {
    fbrdf::capi::SharedPtr shared;
    std::shared_ptr<fbrdf::gl::GpuMaterial> gpu;
    fbrdf::gl::MaterialOptions options;
    std::map<uint64_t, std::string> functions;  ///< texts given to the host, by version and lights
};

struct fbrdf_mesh {
    fbrdf::capi::SharedPtr shared;
    std::shared_ptr<fbrdf::gl::GpuMesh> gpu;
};

struct fbrdf_hooks {
    fbrdf::capi::SharedPtr shared;
    std::shared_ptr<fbrdf::gl::GpuHooks> gpu;
};

struct fbrdf_environment {
    fbrdf::capi::SharedPtr shared;
    std::shared_ptr<fbrdf::gl::GpuEnvironment> gpu;
};

struct fbrdf_library {
    fbrdf::capi::SharedPtr shared;
    std::shared_ptr<fbrdf::gl::GpuLibrary> gpu;
};

struct fbrdf_binding {
    fbrdf::capi::SharedPtr shared;
    fbrdf::gl::MaterialBinding binding;
};

namespace fbrdf::capi {

inline fbrdf_result resultOf(ErrorKind kind)
{
    switch (kind) {
        case ErrorKind::usage: return FBRDF_RESULT_ERROR_ARGUMENT;
        case ErrorKind::gl: return FBRDF_RESULT_ERROR_GL;
        case ErrorKind::input:
        case ErrorKind::fit:
        case ErrorKind::output: return FBRDF_RESULT_ERROR_INPUT;
    }
    return FBRDF_RESULT_ERROR_INTERNAL;
}

inline fbrdf_result fail(const fbrdf_log* log, fbrdf_result result, const char* text) noexcept
{
    if (log && log->function) log->function(log->user, FBRDF_SEVERITY_ERROR, result, text);
    return result;
}

/// The log of a handle's renderer, or NULL where there is no handle.
template <class Handle>
const fbrdf_log* logOf(const Handle* handle)
{
    return handle ? &handle->shared->log : nullptr;
}

/// Runs `act`; whatever it throws becomes a result and a log line.
template <class Act>
fbrdf_result guarded(const fbrdf_log* log, Act act) noexcept
{
    try {
        act();
        return FBRDF_RESULT_OK;
    } catch (const Failure& failure) {
        return fail(log, failure.result, failure.what());
    } catch (const Error& error) {
        return fail(log, resultOf(error.kind()), error.what());
    } catch (const std::bad_alloc&) {  // a sentence that is put together would need memory
        return fail(log, FBRDF_RESULT_ERROR_MEMORY, "found no memory, expected some");
    } catch (const std::exception& error) {
        return fail(log, FBRDF_RESULT_ERROR_INTERNAL, error.what());
    } catch (...) {
        return fail(log, FBRDF_RESULT_ERROR_INTERNAL, "found an exception of another kind");
    }
}

template <class T>
T& required(T* pointer, const char* name)
{
    if (!pointer)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      std::string(name) + ": " + Found("NULL").expected("one"));
    return *pointer;
}

/// The same for functions that make something: *out is NULL unless `make` returns.
template <class T, class Make>
fbrdf_result created(const fbrdf_log* log, T** out, Make make) noexcept
{
    return guarded(log, [&] {
        required(out, "out") = nullptr;
        *out = make();
    });
}

/// The enumerator that a host gave as a number. Throws Failure above `last`.
template <class Enum>
Enum enumerator(uint32_t value, Enum last, const char* name)
{
    if (value > static_cast<uint32_t>(last))
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      std::string(name) + ": " +
                          Found(std::to_string(value))
                              .expected("at most " + std::to_string(static_cast<uint32_t>(last))));
    return static_cast<Enum>(value);
}

}  // namespace fbrdf::capi
