#include "StateScrambler.h"

#include "StateList.h"

namespace fbrdf::test {
namespace {

// True for the switches whose initial value is GL_TRUE.
bool isOnAtFirst(GLenum name)
{
    return name == GL_DITHER || name == GL_MULTISAMPLE;
}

}  // namespace

/// Picks random values, or the first of each choice, which is GL's initial one.
struct StateScrambler::Source {
    bool random = false;
    std::mt19937 engine;

    template <class T>
    T pick(std::initializer_list<T> choices)
    {
        return random ? *(choices.begin() + engine() % choices.size()) : *choices.begin();
    }
    bool flag(bool initial) { return random ? engine() % 2 == 0 : initial; }
    GLboolean boolean(bool initial) { return flag(initial) ? GL_TRUE : GL_FALSE; }
};

StateScrambler::StateScrambler(const GladGLContext& gl, bool core)
    : gl_(gl), core_(core), es_(isEs(gl))
{
    gl.GenTextures(4, textures2d_);
    gl.GenTextures(4, textures3d_);
    gl.GenTextures(1, texturesBuffer_);
    gl.GenTextures(2, texturesArray_);
    gl.GenTextures(2, texturesCube_);
    if (hasSamplers()) gl.GenSamplers(2, samplers_);
    gl.GenBuffers(4, buffers_);
    gl.GenVertexArrays(2, arrays_);
    gl.GenFramebuffers(2, framebuffers_);
    gl.GenRenderbuffers(3, renderbuffers_);
    // Large enough for whatever the unpacking state lets an upload read.
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers_[2]);
    gl.BufferData(GL_PIXEL_UNPACK_BUFFER, 1 << 16, nullptr, GL_STATIC_DRAW);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (int i = 0; i < 2; ++i) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i]);
        gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   renderbuffers_[i]);
    }
    const std::string version = es_ ? "#version 100\n" : "#version 120\n";
    program_ = linkProgram(gl, version + "void main() { gl_Position = vec4(0.0); }\n",
                           version + "void main() { gl_FragColor = vec4(0.0); }\n");
    setDefaults();
}

StateScrambler::~StateScrambler()
{
    setDefaults();
    gl_.DeleteTextures(4, textures2d_);
    gl_.DeleteTextures(4, textures3d_);
    gl_.DeleteTextures(1, texturesBuffer_);
    gl_.DeleteTextures(2, texturesArray_);
    gl_.DeleteTextures(2, texturesCube_);
    if (hasSamplers()) gl_.DeleteSamplers(2, samplers_);
    gl_.DeleteVertexArrays(2, arrays_);
    gl_.DeleteBuffers(4, buffers_);
    gl_.DeleteFramebuffers(2, framebuffers_);
    gl_.DeleteRenderbuffers(3, renderbuffers_);
    gl_.DeleteProgram(program_);
}

void StateScrambler::scramble(unsigned seed)
{
    Source source{true, std::mt19937(seed)};
    set(source);
}

void StateScrambler::setDefaults()
{
    Source source;
    set(source);
}

void StateScrambler::set(Source& source)
{
    setSwitches(source);
    setFixed(source);
    setIndexed(source);
    setPixels(source);
    setBindings(source);
    setAttributes(source);
}

void StateScrambler::setSwitches(Source& source)
{
    for (const NamedState& s : switches(gl_, core_))
        source.flag(isOnAtFirst(s.value)) ? gl_.Enable(s.value) : gl_.Disable(s.value);
}

void StateScrambler::setFixed(Source& source)
{
    gl_.DepthFunc(source.pick<GLenum>({GL_LESS, GL_ALWAYS, GL_NEVER, GL_GREATER}));
    gl_.DepthMask(source.boolean(true));
    const double depth = source.pick({1.0, 0.0, 0.25});
    es_ ? gl_.ClearDepthf(static_cast<GLfloat>(depth)) : gl_.ClearDepth(depth);
    gl_.ClearColor(source.pick({0.0f, 0.5f}), 0.0f, 0.0f, source.pick({0.0f, 1.0f}));
    gl_.CullFace(source.pick<GLenum>({GL_BACK, GL_FRONT, GL_FRONT_AND_BACK}));
    gl_.FrontFace(source.pick<GLenum>({GL_CCW, GL_CW}));
    gl_.PolygonOffset(source.pick({0.0f, 3.0f}), source.pick({0.0f, -2.0f}));
    gl_.StencilFunc(source.pick<GLenum>({GL_ALWAYS, GL_NEVER}), source.pick({0, 3}), 0xffu);
    gl_.SampleCoverage(source.pick({1.0f, 0.0f}), GL_FALSE);
    if (es_) return;
    gl_.LogicOp(source.pick<GLenum>({GL_COPY, GL_XOR, GL_CLEAR}));
    if (gl_.VERSION_3_1) gl_.PrimitiveRestartIndex(source.pick({0u, 5u}));
    gl_.PolygonMode(GL_FRONT_AND_BACK, source.pick<GLenum>({GL_FILL, GL_LINE, GL_POINT}));
    if (gl_.VERSION_4_5)
        gl_.ClipControl(source.pick<GLenum>({GL_LOWER_LEFT, GL_UPPER_LEFT}),
                        source.pick<GLenum>({GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE}));
    if (core_) return;
    gl_.AlphaFunc(source.pick<GLenum>({GL_ALWAYS, GL_NEVER}), 0.0f);
    if (gl_.VERSION_3_0)
        gl_.ClampColor(GL_CLAMP_FRAGMENT_COLOR,
                       source.pick<GLenum>({GL_FIXED_ONLY, GL_TRUE, GL_FALSE}));
}

void StateScrambler::setIndexed(Source& source)
{
    if (!gl_.VERSION_4_1) return setUnindexed(source);
    for (GLuint i = 0; i < kBuffers; ++i) {
        gl_.ColorMaski(i, source.boolean(true), source.boolean(true), source.boolean(true),
                       source.boolean(true));
        source.flag(false) ? gl_.Enablei(GL_BLEND, i) : gl_.Disablei(GL_BLEND, i);
        gl_.BlendFuncSeparatei(i, source.pick<GLenum>({GL_ONE, GL_ZERO, GL_DST_COLOR}),
                               source.pick<GLenum>({GL_ZERO, GL_ONE, GL_SRC_COLOR}),
                               source.pick<GLenum>({GL_ONE, GL_DST_ALPHA}),
                               source.pick<GLenum>({GL_ZERO, GL_ONE}));
        gl_.BlendEquationSeparatei(i, source.pick<GLenum>({GL_FUNC_ADD, GL_MIN, GL_MAX}),
                                   source.pick<GLenum>({GL_FUNC_ADD, GL_FUNC_SUBTRACT}));
    }
    for (GLuint i = 0; i < kViewports; ++i) {
        gl_.ViewportIndexedf(i, source.pick({0.0f, 3.5f}), 1.0f, 8.0f, source.pick({8.0f, 5.5f}));
        gl_.DepthRangeIndexed(i, source.pick({0.0, 0.3, 1.0}), source.pick({1.0, 0.5, 0.0}));
        gl_.ScissorIndexed(i, source.pick({0, 2}), 0, source.pick({8, 1}), 8);
        source.flag(false) ? gl_.Enablei(GL_SCISSOR_TEST, i) : gl_.Disablei(GL_SCISSOR_TEST, i);
    }
}

void StateScrambler::setUnindexed(Source& source)
{
    gl_.ColorMask(source.boolean(true), source.boolean(true), source.boolean(true),
                  source.boolean(true));
    source.flag(false) ? gl_.Enable(GL_BLEND) : gl_.Disable(GL_BLEND);
    gl_.BlendFuncSeparate(source.pick<GLenum>({GL_ONE, GL_ZERO}),
                          source.pick<GLenum>({GL_ZERO, GL_ONE}),
                          source.pick<GLenum>({GL_ONE, GL_DST_ALPHA}), GL_ZERO);
    gl_.BlendEquationSeparate(source.pick<GLenum>({GL_FUNC_ADD, GL_MIN}), GL_FUNC_ADD);
    gl_.Viewport(source.pick({0, 3}), 1, 8, source.pick({8, 5}));
    const double nearest = source.pick({0.0, 0.3}), farthest = source.pick({1.0, 0.5});
    es_ ? gl_.DepthRangef(static_cast<GLfloat>(nearest), static_cast<GLfloat>(farthest))
        : gl_.DepthRange(nearest, farthest);
    gl_.Scissor(source.pick({0, 2}), 0, source.pick({8, 1}), 8);
}

void StateScrambler::setPixels(Source& source)
{
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, source.pick({4, 1, 8}));
    gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, source.pick({0, 7, 100}));
    gl_.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, source.pick({0, 9}));
    gl_.PixelStorei(GL_UNPACK_SKIP_ROWS, source.pick({0, 2}));
    gl_.PixelStorei(GL_UNPACK_SKIP_PIXELS, source.pick({0, 3}));
    gl_.PixelStorei(GL_UNPACK_SKIP_IMAGES, source.pick({0, 1}));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, source.pick({4, 1}));
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, source.pick({0, 100}));
    gl_.PixelStorei(GL_PACK_SKIP_ROWS, source.pick({0, 2}));
    gl_.PixelStorei(GL_PACK_SKIP_PIXELS, source.pick({0, 3}));
    if (es_) return;
    gl_.PixelStorei(GL_UNPACK_SWAP_BYTES, source.pick({0, 1}));
    gl_.PixelStorei(GL_UNPACK_LSB_FIRST, source.pick({0, 1}));
    gl_.PixelStorei(GL_PACK_SWAP_BYTES, source.pick({0, 1}));
    gl_.PixelStorei(GL_PACK_LSB_FIRST, source.pick({0, 1}));
    if (core_) return;
    gl_.PixelTransferf(GL_RED_SCALE, source.pick({1.0f, 0.5f}));
    gl_.PixelTransferf(GL_GREEN_SCALE, source.pick({1.0f, 0.0f}));
    gl_.PixelTransferf(GL_BLUE_BIAS, source.pick({0.0f, 0.5f}));
    gl_.PixelTransferi(GL_MAP_COLOR, source.pick({0, 1}));
}

void StateScrambler::setBindings(Source& source)
{
    for (GLuint i = 0; i < kUnits; ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + i);
        gl_.BindTexture(GL_TEXTURE_2D, source.pick({0u, textures2d_[0], textures2d_[3]}));
        gl_.BindTexture(GL_TEXTURE_3D, source.pick({0u, textures3d_[1], textures3d_[2]}));
        if (gl_.VERSION_3_0)
            gl_.BindTexture(GL_TEXTURE_2D_ARRAY,
                            source.pick({0u, texturesArray_[0], texturesArray_[1]}));
        gl_.BindTexture(GL_TEXTURE_CUBE_MAP, source.pick({0u, texturesCube_[0], texturesCube_[1]}));
        if (gl_.VERSION_3_1 && !es_)
            gl_.BindTexture(GL_TEXTURE_BUFFER, source.pick({0u, texturesBuffer_[0]}));
        if (hasSamplers()) gl_.BindSampler(i, source.pick({0u, samplers_[0], samplers_[1]}));
    }
    gl_.ActiveTexture(source.pick<GLenum>({GL_TEXTURE0, GL_TEXTURE2, GL_TEXTURE5}));
    gl_.UseProgram(source.pick({0u, program_}));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, source.pick({0u, framebuffers_[0]}));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, source.pick({0u, framebuffers_[1]}));
    gl_.BindRenderbuffer(GL_RENDERBUFFER, source.pick({0u, renderbuffers_[2]}));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, source.pick({0u, buffers_[2]}));
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, source.pick({0u, buffers_[2]}));
    if (gl_.VERSION_3_1) gl_.BindBuffer(GL_UNIFORM_BUFFER, source.pick({0u, buffers_[3]}));
    if (gl_.VERSION_4_3 && !es_) setStorage(source);
}

void StateScrambler::setStorage(Source& source)
{
    for (GLuint i = 0; i < kStorageBindings; ++i) {
        const GLuint buffer = source.pick({0u, buffers_[2]});
        // A multiple of any alignment that GL may ask for.
        if (source.flag(false) && buffer != 0)
            gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer, 256, source.pick({64, 1024}));
        else
            gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffer);
    }
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, source.pick({0u, buffers_[3]}));
}

void StateScrambler::setAttributes(Source& source)
{
    gl_.BindVertexArray(source.random && (core_ || source.flag(true)) ? arrays_[0] : 0);
    if (!core_ || source.random) {
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        for (GLuint i = 0; i < kAttributes; ++i) {
            gl_.VertexAttribPointer(i, source.pick({4, 3, 2}),
                                    source.pick<GLenum>({GL_FLOAT, GL_SHORT}),
                                    source.boolean(false), source.pick({0, 24}), nullptr);
            source.flag(false) ? gl_.EnableVertexAttribArray(i) : gl_.DisableVertexAttribArray(i);
        }
        gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, source.pick({0u, buffers_[1]}));
    }
    gl_.BindBuffer(GL_ARRAY_BUFFER, source.pick({0u, buffers_[3]}));
    for (GLuint i = 1; i < kAttributes; ++i)
        gl_.VertexAttrib4f(i, source.pick({0.0f, 0.5f}), source.pick({0.0f, -2.0f}),
                           source.pick({0.0f, 3.0f}), source.pick({1.0f, -1.0f}));
}

}  // namespace fbrdf::test
