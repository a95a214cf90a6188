// ToneMapper.h - from linear radiance to the window: what is behind the objects, exposure, tone
// mapping, sRGB.
#pragma once
#include "SampleSum.h"

#include <fbrdf/scene/Environment.h>

namespace fbrdf::viewer {

/// How a picture is shown.
struct Look {
    float exposure = 1.0f;
    bool toneMap = false;
    scene::Background background;                          ///< none: a dark backdrop
    const scene::EnvironmentLight* environment = nullptr;  ///< of the background
    gl::View view;                                         ///< where it is seen from
};

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class ToneMapper {
public:
    explicit ToneMapper(gl::LoadFunction load);
    ~ToneMapper();
    ToneMapper(const ToneMapper&) = delete;
    ToneMapper& operator=(const ToneMapper&) = delete;

    /// Takes the panorama of Look::environment.
    void setPanorama(const Panorama& panorama);
    /// Takes a picture of the CPU, of any size.
    void upload(const scene::Image& image);

    /// Fills a framebuffer of the target's size: with the mean of samples, or with what was
    /// uploaded last.
    void show(const gl::Target& target, const SampleSum& samples, const Look& look);
    void showUploaded(const gl::Target& target, const Look& look);

private:
    void setBackground(const Look& look);
    void fill(const gl::Target& target, GLuint radiance, const Look& look);
    GLint uniform(const char* name) const { return gl_.GetUniformLocation(program_, name); }

    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0, uploaded_ = 0, panorama_ = 0;
};

}  // namespace fbrdf::viewer
