// Offscreen.h - a framebuffer object with colour and depth, and its read-back: what a program
// without a window draws to. Belongs to the context that was current when it was made; all calls,
// the destructor included, need that context current.
#pragma once
#include <fbrdf/headless/Context.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace fbrdf {

enum class OffscreenFormat { rgba8, rgba16f, rgba32f };

struct OffscreenOptions {
    int width = 64, height = 64;  ///< pixels, > 0
    OffscreenFormat format = OffscreenFormat::rgba32f;
    bool depth = true;
};

class Offscreen {
public:
    /// Throws Error(gl) where the framebuffer would not be complete.
    Offscreen(HeadlessContext::Load load, const OffscreenOptions& options);
    ~Offscreen();
    Offscreen(Offscreen&&) noexcept;
    Offscreen& operator=(Offscreen&&) noexcept;

    uint32_t framebuffer() const;
    int width() const;
    int height() const;

    /// Sets colour to the given value and depth to 1. Leaves the framebuffer bound as it was.
    void clear(float red = 0.0f, float green = 0.0f, float blue = 0.0f, float alpha = 0.0f);
    /// Returns width x height x RGBA, row by row from the bottom. Waits for the drawing to end.
    std::vector<float> readPixels() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf
