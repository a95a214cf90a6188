// EGL without a window system: platform "surfaceless", no config, no surface. The default
// framebuffer of such a context is undefined, so whoever draws brings a framebuffer object.
// Reference: EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context, EGL_KHR_no_config_context,
// EGL_EXT_device_enumeration, EGL_EXT_platform_device.
#include "Native.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

namespace fbrdf {
namespace {

std::string failureOf(const char* call)
{
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
    return std::string(call) + " failed with " + code;
}

[[noreturn]] void failEgl(const char* call)
{
    throw Error(
        ErrorKind::gl, "EGL",
        Found("that " + failureOf(call))
            .expected("OpenGL on Mesa's surfaceless platform (Debian: libegl1, libgl1-mesa-dri)"));
}

[[noreturn]] void failForVersion(const HeadlessOptions& options)
{
    throw Error(
        ErrorKind::gl, "EGL",
        Found("no OpenGL " + versionName(options) + " (" + failureOf("eglCreateContext") + ")")
            .expected("a driver that has it"));
}

std::vector<EGLDeviceEXT> eglDevices()
{
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (!queryDevices || !queryDevices(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
    if (!queryDevices(count, devices.data(), &count)) return {};
    devices.resize(static_cast<size_t>(count));
    return devices;
}

/// The number of FBRDF_EGL_DEVICE. Throws where that is no number.
std::optional<int> deviceOfEnvironment()
{
    const char* const text = std::getenv("FBRDF_EGL_DEVICE");
    if (!text || !*text) return {};
    char* end = nullptr;
    const long number = std::strtol(text, &end, 10);
    if (*end != '\0' || number < 0 || number > 1000)
        throw Error(ErrorKind::usage, "FBRDF_EGL_DEVICE",
                    Found("'" + std::string(text) + "'").expected("the number of a device"));
    return static_cast<int>(number);
}

// The display stays initialised: it is one for the process, and eglTerminate would end the contexts
// of everybody else who uses it (EGL_KHR_display_reference is not in Mesa 22).
EGLDisplay initialisedDisplay(EGLenum platform, void* native, const char* call)
{
    const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!getPlatformDisplay) failEgl("eglGetProcAddress(eglGetPlatformDisplayEXT)");
    const EGLDisplay display = getPlatformDisplay(platform, native, nullptr);
    if (display == EGL_NO_DISPLAY) failEgl(call);
    if (!eglInitialize(display, nullptr, nullptr)) failEgl("eglInitialize");
    return display;
}

EGLDisplay displayOf(const HeadlessOptions& options)
{
    const std::optional<int> device = options.device ? options.device : deviceOfEnvironment();
    if (!device)
        return initialisedDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                  "eglGetPlatformDisplayEXT(surfaceless)");
    const std::vector<EGLDeviceEXT> devices = eglDevices();
    if (*device < 0 || static_cast<size_t>(*device) >= devices.size())
        throw Error(ErrorKind::usage, "EGL",
                    Found("device " + std::to_string(*device))
                        .expected(devices.empty() ? "none: EGL lists no devices here"
                                                  : "0 to " + std::to_string(devices.size() - 1)));
    return initialisedDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(*device)],
                              "eglGetPlatformDisplayEXT(device)");
}

std::vector<EGLint> eglAttributes(const HeadlessOptions& options)
{
    using Profile = HeadlessOptions::Profile;
    std::vector<EGLint> list{EGL_CONTEXT_MAJOR_VERSION, options.major, EGL_CONTEXT_MINOR_VERSION,
                             options.minor};
    const bool hasProfiles = options.major > 3 || (options.major == 3 && options.minor >= 2);
    if (options.profile != Profile::es && hasProfiles)
        list.insert(list.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 options.profile == Profile::core
                                     ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                     : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT});
    if (options.debug) list.insert(list.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    list.push_back(EGL_NONE);
    return list;
}

class EglContext : public NativeContext {
public:
    EglContext(const HeadlessOptions& options, const EglContext* sharedWith)
        : display_(sharedWith ? sharedWith->display_ : displayOf(options)),
          api_(options.profile == HeadlessOptions::Profile::es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)
    {
        if (!eglBindAPI(api_)) failEgl("eglBindAPI");
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR,
                                    sharedWith ? sharedWith->context_ : EGL_NO_CONTEXT,
                                    eglAttributes(options).data());
        if (context_ == EGL_NO_CONTEXT) failForVersion(options);
    }

    ~EglContext() override
    {
        release();
        eglDestroyContext(display_, context_);
    }

    void makeCurrent() override
    {
        // OSMesa may have taken the thread's context slot without EGL noticing; a bind of what EGL
        // believes to be bound already would then do nothing.
        release();
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            failEgl("eglMakeCurrent");
    }

    void release() override
    {
        if (!eglBindAPI(api_))
            return;  // the API is a state of the thread, and what follows depends on it
        if (eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

private:
    EGLDisplay display_;
    EGLenum api_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::string rendererOf(int device)
{
    HeadlessOptions options;
    options.device = device;
    options.debug = false;
    try {
        const HeadlessContext context(options);
        const auto getString = reinterpret_cast<const unsigned char* (*)(unsigned)>(
            context.loader()(nullptr, "glGetString"));
        constexpr unsigned kRenderer = 0x1F01;  // GL_RENDERER
        const auto* text = getString ? getString(kRenderer) : nullptr;
        return text ? reinterpret_cast<const char*>(text) : "a context without GL_RENDERER";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

std::vector<std::string> headlessDevices()
{
    std::vector<std::string> renderers;
    for (size_t i = 0; i < eglDevices().size(); ++i)
        renderers.push_back(rendererOf(static_cast<int>(i)));
    return renderers;
}

std::unique_ptr<NativeContext> createEglContext(const HeadlessOptions& options,
                                                const NativeContext* sharedWith)
{
    return std::make_unique<EglContext>(options, static_cast<const EglContext*>(sharedWith));
}

void* HeadlessContext::loadEgl(void*, const char* name)
{
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

}  // namespace fbrdf
