// OSMesa: a context that draws into memory. The library is opened at run time and stays open:
// linking it would put its gl* symbols before those of libGL, and a program with a window needs the
// latter.
#include "Native.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <dlfcn.h>
#include <GL/osmesa.h>

#include <array>
#include <vector>

namespace fbrdf {
namespace {

struct Library {
    decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaGetCurrentContext) currentContext = nullptr;
    decltype(&OSMesaGetProcAddress) procAddress = nullptr;
    std::string problem;
};

template <class Function>
void find(void* handle, const char* name, Function& function, std::string& problem)
{
    function = reinterpret_cast<Function>(dlsym(handle, name));
    if (!function) problem = std::string("no ") + name + " in libOSMesa.so.8";
}

Library openLibrary()
{
    Library library;
    void* const handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
        library.problem = dlerror();
        return library;
    }
    find(handle, "OSMesaCreateContextAttribs", library.createContext, library.problem);
    find(handle, "OSMesaDestroyContext", library.destroyContext, library.problem);
    find(handle, "OSMesaMakeCurrent", library.makeCurrent, library.problem);
    find(handle, "OSMesaGetCurrentContext", library.currentContext, library.problem);
    find(handle, "OSMesaGetProcAddress", library.procAddress, library.problem);
    return library;
}

[[noreturn]] void failOsMesa(const std::string& what)
{
    throw Error(ErrorKind::gl, "OSMesa", what);
}

// Immutable once made; throws where the library or one of its functions is missing.
const Library& library()
{
    static const Library opened = openLibrary();
    if (!opened.problem.empty()) failOsMesa(opened.problem);
    return opened;
}

std::vector<int> osMesaAttributes(const HeadlessOptions& options)
{
    const bool core = options.profile == HeadlessOptions::Profile::core;
    return {OSMESA_FORMAT,
            OSMESA_RGBA,
            OSMESA_DEPTH_BITS,
            24,
            OSMESA_PROFILE,
            core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
            OSMESA_CONTEXT_MAJOR_VERSION,
            options.major,
            OSMESA_CONTEXT_MINOR_VERSION,
            options.minor,
            0};
}

class OsMesaContext : public NativeContext {
public:
    OsMesaContext(const HeadlessOptions& options, const OsMesaContext* sharedWith)
    {
        if (options.profile == HeadlessOptions::Profile::es)
            failOsMesa(Found("a request for OpenGL ES").expected("OpenGL"));
        context_ = library().createContext(osMesaAttributes(options).data(),
                                           sharedWith ? sharedWith->context_ : nullptr);
        if (!context_)
            failOsMesa(
                Found("no OpenGL " + versionName(options) + " (OSMesaCreateContextAttribs failed)")
                    .expected("a driver that has it"));
    }

    ~OsMesaContext() override
    {
        release();
        library().destroyContext(context_);
    }

    void makeCurrent() override
    {
        if (!library().makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide))
            failOsMesa("OSMesaMakeCurrent failed");
    }

    void release() override
    {
        if (library().currentContext() == context_)
            library().makeCurrent(nullptr, nullptr, 0, 0, 0);
    }

private:
    // A buffer is required even where everything is drawn to framebuffer objects.
    static constexpr int kSide = 4;
    std::array<unsigned char, kSide * kSide * 4> buffer_{};
    OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<NativeContext> createOsMesaContext(const HeadlessOptions& options,
                                                   const NativeContext* sharedWith)
{
    return std::make_unique<OsMesaContext>(options, static_cast<const OsMesaContext*>(sharedWith));
}

void* HeadlessContext::loadOsMesa(void*, const char* name)
{
    return reinterpret_cast<void*>(library().procAddress(name));
}

}  // namespace fbrdf
