// CompareMapper.h - two pictures as the window shows them, laid over each other by GL, so that a
// line can be dragged without drawing them again.
#pragma once
#include "ComparePicture.h"
#include "ToneMapper.h"

#include <array>

namespace fbrdf::viewer {

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class CompareMapper {
public:
    explicit CompareMapper(gl::LoadFunction load);
    ~CompareMapper();
    CompareMapper(const CompareMapper&) = delete;
    CompareMapper& operator=(const CompareMapper&) = delete;

    /// A target of 8 bits for A (0) or B (1), to be filled by a ToneMapper. What it holds is lost
    /// where the size is another than before.
    gl::Target seat(int side, int width, int height);
    /// Fills a framebuffer of the size of the seats.
    void show(const gl::Target& target, const CompareLayout& layout);

private:
    struct Seat {
        GLuint framebuffer = 0, colour = 0;
        int width = 0, height = 0;
    };
    void resize(Seat& seat, int width, int height);
    GLint uniform(const char* name) const { return gl_.GetUniformLocation(program_, name); }

    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0;
    std::array<Seat, 2> seats_;
};

}  // namespace fbrdf::viewer
