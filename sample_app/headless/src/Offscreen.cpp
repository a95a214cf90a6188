#define GLAD_GL_IMPLEMENTATION
#include <glad/gl.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>

#include <algorithm>
#include <string>
#include <type_traits>

namespace fbrdf {
namespace {

GLenum internalFormatOf(OffscreenFormat format)
{
    switch (format) {
        case OffscreenFormat::rgba8: return GL_RGBA8;
        case OffscreenFormat::rgba16f: return GL_RGBA16F;
        case OffscreenFormat::rgba32f: return GL_RGBA32F;
    }
    return GL_NONE;
}

[[noreturn]] void failOffscreen(const std::string& what)
{
    throw Error(ErrorKind::gl, "offscreen", what);
}

/// Fills in functions of OpenGL ES that glad only looks for in later desktop versions. `es` is the
/// major version, or 0.
void loadEmbedded(GladGLContext& gl, HeadlessContext::Load load, int& es)
{
    const std::string version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    if (version.compare(0, 10, "OpenGL ES ") != 0) return;
    es = version[10] - '0';
    const auto find = [load](auto& function, const char* name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(load(nullptr, name));
    };
    find(gl.BindFramebuffer, "glBindFramebuffer");
    find(gl.BindRenderbuffer, "glBindRenderbuffer");
    find(gl.CheckFramebufferStatus, "glCheckFramebufferStatus");
    find(gl.ClearDepthf, "glClearDepthf");
    find(gl.DeleteFramebuffers, "glDeleteFramebuffers");
    find(gl.DeleteRenderbuffers, "glDeleteRenderbuffers");
    find(gl.FramebufferRenderbuffer, "glFramebufferRenderbuffer");
    find(gl.GenFramebuffers, "glGenFramebuffers");
    find(gl.GenRenderbuffers, "glGenRenderbuffers");
    find(gl.RenderbufferStorage, "glRenderbufferStorage");
}

}  // namespace

struct Offscreen::State {
    GladGLContext gl{};
    OffscreenOptions options;
    GLuint framebuffer = 0, colour = 0, depth = 0;
    int es = 0;  ///< major version of OpenGL ES

    /// OpenGL ES 2.0 has a single binding of framebuffers.
    GLenum drawTarget() const { return es == 2 ? GL_FRAMEBUFFER : GL_DRAW_FRAMEBUFFER; }
    GLenum readTarget() const { return es == 2 ? GL_FRAMEBUFFER : GL_READ_FRAMEBUFFER; }

    ~State()
    {
        if (framebuffer) gl.DeleteFramebuffers(1, &framebuffer);
        if (colour) gl.DeleteRenderbuffers(1, &colour);
        if (depth) gl.DeleteRenderbuffers(1, &depth);
    }

    GLuint attached(GLenum attachment, GLenum format)
    {
        GLuint buffer = 0;
        gl.GenRenderbuffers(1, &buffer);
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        gl.RenderbufferStorage(GL_RENDERBUFFER, format, options.width, options.height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
        return buffer;
    }

    GLuint bound(GLenum binding) const
    {
        GLint name = 0;
        gl.GetIntegerv(binding, &name);
        return static_cast<GLuint>(name);
    }
};

Offscreen::Offscreen(HeadlessContext::Load load, const OffscreenOptions& options)
    : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.options = options;
    const auto glLoad = [](void* user, const char* name) {
        return reinterpret_cast<GLADapiproc>(
            (*static_cast<HeadlessContext::Load*>(user))(nullptr, name));
    };
    if (!gladLoadGLContextUserPtr(&s.gl, glLoad, &load)) failOffscreen("no current context");
    loadEmbedded(s.gl, load, s.es);
    if (!s.es && !s.gl.VERSION_3_0 && !s.gl.ARB_framebuffer_object)
        failOffscreen("no framebuffer objects");
    const GLuint before = s.bound(GL_FRAMEBUFFER_BINDING);
    s.gl.GenFramebuffers(1, &s.framebuffer);
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, s.framebuffer);
    s.colour = s.attached(GL_COLOR_ATTACHMENT0, internalFormatOf(options.format));
    if (options.depth)
        s.depth = s.attached(GL_DEPTH_ATTACHMENT,
                             s.es == 2 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24);
    const GLenum status = s.gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, before);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        failOffscreen("a framebuffer of " + std::to_string(options.width) + "x" +
                      std::to_string(options.height) + " is not complete (status " +
                      std::to_string(status) + ")");
}

Offscreen::~Offscreen() = default;
Offscreen::Offscreen(Offscreen&&) noexcept = default;
Offscreen& Offscreen::operator=(Offscreen&&) noexcept = default;

uint32_t Offscreen::framebuffer() const
{
    return state_->framebuffer;
}

int Offscreen::width() const
{
    return state_->options.width;
}

int Offscreen::height() const
{
    return state_->options.height;
}

void Offscreen::clear(float red, float green, float blue, float alpha)
{
    State& s = *state_;
    const GLuint before = s.bound(GL_DRAW_FRAMEBUFFER_BINDING);
    s.gl.BindFramebuffer(s.drawTarget(), s.framebuffer);
    s.gl.ClearColor(red, green, blue, alpha);
    s.es ? s.gl.ClearDepthf(1.0f) : s.gl.ClearDepth(1.0);
    s.gl.Clear(GL_COLOR_BUFFER_BIT | (s.options.depth ? GL_DEPTH_BUFFER_BIT : 0u));
    s.gl.BindFramebuffer(s.drawTarget(), before);
}

std::vector<float> Offscreen::readPixels() const
{
    const State& s = *state_;
    std::vector<float> pixels(4 * static_cast<size_t>(s.options.width) *
                              static_cast<size_t>(s.options.height));
    const GLuint before = s.bound(s.es == 2 ? GL_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING);
    s.gl.BindFramebuffer(s.readTarget(), s.framebuffer);
    const auto read = [&s](GLenum type, void* into) {
        s.gl.ReadPixels(0, 0, s.options.width, s.options.height, GL_RGBA, type, into);
    };
    if (s.es && s.options.format ==
                    OffscreenFormat::rgba8) {  // OpenGL ES reads 8-bit colours as bytes only
        std::vector<uint8_t> bytes(pixels.size());
        read(GL_UNSIGNED_BYTE, bytes.data());
        std::transform(bytes.begin(), bytes.end(), pixels.begin(),
                       [](uint8_t byte) { return static_cast<float>(byte) / 255.0f; });
    } else {
        read(GL_FLOAT, pixels.data());
    }
    s.gl.BindFramebuffer(s.readTarget(), before);
    return pixels;
}

}  // namespace fbrdf
