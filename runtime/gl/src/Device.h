// Device.h - what everything in one context shares: functions, capabilities, log. GL objects own it
// together, so that they can be deleted after the renderer.
#pragma once
#include "Functions.h"

#include <fbrdf/shaders/TextureImage.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fbrdf::gl {

struct Device {
    Functions gl{};
    Capabilities capabilities;
    std::function<void(Severity, const std::string&)> logTo;
    PassWatch passes;
    std::string renderer, version;
    int firstTextureUnit = 0;
    int drawBuffers = 1;
    bool wideIndices = true;  ///< indices may have 32 bits
    /// Switches of extensions that could change or discard a fragment; off in a new context.
    std::vector<GLenum> extensionSwitches;
    StateMode state = StateMode::restore;
    uint64_t nextMaterial = 1, nextHooks = 1;
    /// Identities of materials and hooks that are gone: the renderer then deletes what only they
    /// needed. Destructors cannot do so themselves, for they may run after the renderer's.
    std::vector<uint64_t> retiredMaterials, retiredHooks;
    /// What was measured (FilterProbe.h), by type of texel and target.
    std::map<std::pair<TexelType, GLenum>, FilterPrecision> filters;
    std::optional<StoreRoundings> roundings;  ///< what was measured (RoundingProbe.h)
    std::string whyFilterAssumed;  ///< the last reason for which nothing was measured; ""
    bool alive = true;             ///< false: the context is gone, no GL call may be made

    void log(Severity severity, const std::string& text) const
    {
        if (logTo) logTo(severity, text);
    }
    /// Logs once what every frame would report again. Texts name materials, of which there may be
    /// any number: after kMostLogged others a text may come again.
    void logOnce(Severity severity, const std::string& text)
    {
        if (logged.size() >= kMostLogged) logged.clear();
        if (logged.insert(text).second) log(severity, text);
    }
    static constexpr size_t kMostLogged = 256;
    std::set<std::string> logged;
};
using DevicePtr = std::shared_ptr<Device>;

/// Loads functions and finds capabilities. Throws Error(gl).
DevicePtr createDevice(const RendererOptions& options);

/// Throws Error(gl) where glGetError reports one. where: what was being done.
void checkErrors(const Device& device, const std::string& where);
/// Takes away the errors of what has failed and was reported already.
void discardErrors(const Device& device);
/// Takes away, with a warning, the errors that the host left behind, so that they are not taken for
/// ours.
void discardHostErrors(const Device& device);

/// Value of a GL state that is one integer.
inline GLint integer(const Functions& gl, GLenum name)
{
    GLint value[16] = {};  // some states have up to 16 components
    gl.GetIntegerv(name, value);
    return value[0];
}

/// A KHR_debug group around a scope; nothing where the context has no such groups.
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
