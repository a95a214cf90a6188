// ThumbnailMaker.h - draws small pictures of materials with the runtime, beside what a window
// shows.
#pragma once
#include "ThumbnailCache.h"

#include <fbrdf/gl/Renderer.h>
#include <fbrdf/headless/Offscreen.h>

namespace fbrdf::viewer {

/// Belongs to the context that is current when it is made.
class ThumbnailMaker {
public:
    /// Throws Error(gl).
    explicit ThumbnailMaker(gl::LoadFunction load);

    /// A sphere under a few lights on dark ground, the same everywhere, sRGB. Throws Error for a
    /// material that cannot be drawn.
    PngImage draw(const Material& material);

private:
    gl::Renderer renderer_;
    Offscreen offscreen_;
    std::shared_ptr<gl::GpuMesh> sphere_;
};

}  // namespace fbrdf::viewer
