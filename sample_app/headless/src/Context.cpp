#include "Native.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf {

const char* backendName(Backend backend)
{
    return backend == Backend::egl ? "egl" : "osmesa";
}

Backend backendFromName(const std::string& name)
{
    for (const Backend backend : {Backend::egl, Backend::osmesa})
        if (name == backendName(backend)) return backend;
    throw Error(ErrorKind::usage, "backend", Found("'" + name + "'").expected("egl or osmesa"));
}

struct HeadlessContext::State {
    HeadlessOptions options;
    std::unique_ptr<NativeContext> native;
};

HeadlessContext::HeadlessContext(const HeadlessOptions& options)
    : state_(std::make_unique<State>(State{options, nullptr}))
{
    const HeadlessContext* other = options.sharedWith;
    if (other && other->options().backend != options.backend)
        throw Error(ErrorKind::gl, "context",
                    Found("a context to share with of another backend")
                        .expected(std::string(backendName(options.backend))));
    const NativeContext* sharedWith = other ? other->state_->native.get() : nullptr;
    state_->options.sharedWith = nullptr;  // the other context may be destroyed first
    state_->native = options.backend == Backend::egl ? createEglContext(options, sharedWith)
                                                     : createOsMesaContext(options, sharedWith);
    makeCurrent();
}

HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

void HeadlessContext::makeCurrent()
{
    state_->native->makeCurrent();
}

void HeadlessContext::release()
{
    state_->native->release();
}

HeadlessContext::Load HeadlessContext::loader() const
{
    return state_->options.backend == Backend::egl ? &loadEgl : &loadOsMesa;
}

const HeadlessOptions& HeadlessContext::options() const
{
    return state_->options;
}

}  // namespace fbrdf
