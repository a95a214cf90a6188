// Context.h - an OpenGL context without a display: EGL surfaceless (llvmpipe or a GPU) or OSMesa.
// Used by fbrdf-viewer, fbrdf-bench and the tests; the runtime itself never makes a context.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

enum class Backend { egl, osmesa };
const char* backendName(Backend backend);          ///< "egl", "osmesa"
Backend backendFromName(const std::string& name);  ///< throws Error(usage)

class HeadlessContext;

struct HeadlessOptions {
    Backend backend = Backend::egl;
    enum class Profile { core, compatibility, es } profile = Profile::core;
    int major = 3, minor = 3;  ///< requested version
    bool debug = true;         ///< ask for a debug context (EGL)
    /// A context of the same backend, with which textures, buffers and programs are shared, but not
    /// framebuffers.
    const HeadlessContext* sharedWith = nullptr;
    /// A number of headlessDevices() (EGL). Empty: what the environment variable FBRDF_EGL_DEVICE
    /// says, and without it the device that Mesa's surfaceless platform takes.
    std::optional<int> device = {};
};

/// What EGL can draw with on this machine, in EGL's order: the GL_RENDERER of each, or why it has
/// no OpenGL. Empty where EGL lists none (EGL_EXT_device_enumeration). Leaves no context current.
std::vector<std::string> headlessDevices();

/// A context. It is current on the thread that made it; makeCurrent() makes it current again.
class HeadlessContext {
public:
    /// Throws Error(gl) with the step that failed and the error of that step.
    explicit HeadlessContext(const HeadlessOptions& options);
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;

    void makeCurrent();
    /// Makes it current nowhere, so that another thread can make it current.
    void release();
    /// Finds a GL function by name; `user` is ignored. Fits gl::LoadFunction.
    static void* loadEgl(void* user, const char* name);
    static void* loadOsMesa(void* user, const char* name);
    using Load = void* (*)(void*, const char*);
    Load loader() const;
    const HeadlessOptions& options() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf
