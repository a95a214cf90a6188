// HeadlessDrawing.h - pictures of a world, one after the other, without a display.
#pragma once
#include "FrameTimer.h"
#include "GlScene.h"

#include <fbrdf/headless/Offscreen.h>

namespace fbrdf::viewer {

/// Pictures of one size that the runtime draws on a context of its own.
class HeadlessDrawing {
public:
    /// Throws Error(gl) where there is no usable GL.
    HeadlessDrawing(const Options& options, World& world);

    GlScene& scene() { return scene_; }
    /// The mean of so many samples a pixel, without background. Throws Error(gl) where objects
    /// could not be drawn.
    scene::Image draw(GlRequest request, int samples);
    /// What the last sample of the last picture was, and how long all of them took.
    const gl::DrawStats& drawn() const { return drawn_; }
    double milliseconds() const { return milliseconds_; }

private:
    HeadlessContext context_;
    GlScene scene_;
    Offscreen offscreen_;
    FrameTimer timer_;
    gl::DrawStats drawn_;
    double milliseconds_ = 0.0;
};

/// What the options ask to see of a world.
GlRequest requestOf(const Options& options, const World& world);

}  // namespace fbrdf::viewer
