// Native.h - what one backend must be able to do; Context.cpp picks one.
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
};

/// "3.3": the version that was asked for.
inline std::string versionName(const HeadlessOptions& options)
{
    return std::to_string(options.major) + "." + std::to_string(options.minor);
}

std::unique_ptr<NativeContext> createEglContext(const HeadlessOptions& options);
std::unique_ptr<NativeContext> createOsMesaContext(const HeadlessOptions& options);

}  // namespace fbrdf
