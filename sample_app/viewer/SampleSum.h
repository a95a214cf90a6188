// SampleSum.h - the framebuffer that the runtime draws to, and the sum of what it drew there: one
// sample of every pixel after the other.
#pragma once
#include "GlFunctions.h"

#include <fbrdf/plan/Plan.h>
#include <fbrdf/scene/Image.h>

namespace fbrdf::viewer {

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class SampleSum {
public:
    explicit SampleSum(gl::LoadFunction load);
    ~SampleSum();
    SampleSum(const SampleSum&) = delete;
    SampleSum& operator=(const SampleSum&) = delete;

    /// Begins a sum of pictures of that size, each drawn in a format (Document::target).
    void restart(int width, int height, ColourFormat format = ColourFormat::rgba32f);
    /// Returns a framebuffer of that format and size, cleared to 0, for the next sample.
    gl::Target clearedTarget();
    /// Adds what was drawn there.
    void add();

    int count() const { return count_; }
    GLuint texture() const { return sum_.colour; }  ///< RGBA32F, row 0 the bottom one
    /// Reads the mean back. Expects at least one sample.
    scene::Image mean() const;

private:
    struct Surface {
        GLuint framebuffer = 0, colour = 0;
    };
    void resize(int width, int height, ColourFormat format);
    void clear(const Surface& surface) const;

    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0, depth_ = 0;
    Surface drawn_, sum_;
    ColourFormat format_ = ColourFormat::rgba32f;
    int width_ = 0, height_ = 0, count_ = 0;
};

}  // namespace fbrdf::viewer
