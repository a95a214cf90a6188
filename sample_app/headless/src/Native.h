// Native.h - the interface of a backend; Context.cpp picks one.
#pragma once
#include <fbrdf/headless/Context.h>

#include <memory>
#include <string>

namespace fbrdf {

/// A context of some window-less API. Destroying it releases it first where it is current.
class NativeContext {
public:
    virtual ~NativeContext() = default;
    virtual void makeCurrent() = 0;
    virtual void release() = 0;  ///< where it is current
};

/// "3.3": the version that was asked for.
inline std::string versionName(const HeadlessOptions& options)
{
    return std::to_string(options.major) + "." + std::to_string(options.minor);
}

/// sharedWith: of the same backend, or null.
std::unique_ptr<NativeContext> createEglContext(const HeadlessOptions& options,
                                                const NativeContext* sharedWith);
std::unique_ptr<NativeContext> createOsMesaContext(const HeadlessOptions& options,
                                                   const NativeContext* sharedWith);

}  // namespace fbrdf
