// Device.h - what everything that lives in one context shares: functions, capabilities, log. GL
// objects keep it alive, so that they can be deleted after the renderer.
#pragma once
#include "Functions.h"

#include <memory>
#include <set>
#include <string>
#include <utility>

namespace fbrdf::gl {

struct Device {
    Functions gl{};
    Capabilities capabilities;
    std::function<void(Severity, const std::string&)> logTo;
    std::string renderer, version;
    int firstTextureUnit = 0;
    int drawBuffers = 1;
    bool wideIndices = true;  ///< 32-bit
    int maxBufferTexels = 0;  ///< of a buffer texture
    StateMode state = StateMode::restore;
    uint64_t nextMaterial = 0, nextHooks = 0;
    bool alive = true;  ///< false: the context is gone, no GL call may be made

    void log(Severity severity, const std::string& text) const
    {
        if (logTo) logTo(severity, text);
    }
    /// What every frame would say again is said once.
    void logOnce(Severity severity, const std::string& text)
    {
        if (logged.insert(text).second) log(severity, text);
    }
    std::set<std::string> logged;
};
using DevicePtr = std::shared_ptr<Device>;

/// Loads functions and finds capabilities. Throws Error(gl).
DevicePtr createDevice(const RendererOptions& options);

/// Throws Error(gl) when GL has an error to tell; `where` says during what.
void checkErrors(const Device& device, const std::string& where);
/// Errors that the host left behind are not ours: takes them away with a warning.
void discardHostErrors(const Device& device);

/// Value of a GL state that is one integer.
inline GLint integer(const Functions& gl, GLenum name)
{
    GLint value[16] = {};  // some states have up to 16 components
    gl.GetIntegerv(name, value);
    return value[0];
}

/// KHR_debug group around a scope; nothing where the context has none.
class DebugGroup {
public:
    DebugGroup(const Device& device, const std::string& text) : device_(device)
    {
        if (device_.capabilities.debug)
            device_.gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, text.c_str());
    }
    ~DebugGroup()
    {
        if (device_.capabilities.debug) device_.gl.PopDebugGroup();
    }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    const Device& device_;
};

}  // namespace fbrdf::gl
