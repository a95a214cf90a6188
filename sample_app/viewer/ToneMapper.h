// ToneMapper.h - from linear radiance to the window: the framebuffer that the runtime draws to, the
// pictures that the CPU draws, and the exposed sRGB that is shown.
#pragma once
#include "GlFunctions.h"

#include <fbrdf/scene/Image.h>

namespace fbrdf::viewer {

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class ToneMapper {
public:
    explicit ToneMapper(gl::LoadFunction load);
    ~ToneMapper();
    ToneMapper(const ToneMapper&) = delete;
    ToneMapper& operator=(const ToneMapper&) = delete;

    /// Returns an RGBA32F framebuffer of that size, cleared to 0.
    gl::Target clearedTarget(int width, int height);
    /// Reads the target back as a picture.
    scene::Image readTarget();
    /// Takes a picture of any size instead of the target.
    void upload(const scene::Image& image);

    /// Shows what was drawn or uploaded last in the window's framebuffer of that size.
    void show(int width, int height, float exposure);

private:
    void resize(int width, int height);

    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0;
    GLuint framebuffer_ = 0, depth_ = 0, drawn_ = 0;  ///< of the runtime
    GLuint uploaded_ = 0;                             ///< texture of the CPU's pictures
    int width_ = 0, height_ = 0;
    bool showUploaded_ = false;
};

}  // namespace fbrdf::viewer
