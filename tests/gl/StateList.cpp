#include "StateList.h"

#include <sstream>

namespace fbrdf::test {
namespace {

constexpr GLuint kUnits = 6, kViewports = 4, kBuffers = 4, kAttributes = 4;

struct Named {
    const char* name;
    GLenum value;
    int since = 21;  ///< version that knows it
};
#define FBRDF_NAMED(...) FBRDF_NAMED_SINCE(__VA_ARGS__, 21)
#define FBRDF_NAMED_SINCE(x, since, ...) \
    Named                                \
    {                                    \
#x, x, since                     \
    }

int versionOf(const GladGLContext& gl)
{
    if (gl.VERSION_4_5) return 45;
    if (gl.VERSION_4_1) return 41;
    if (gl.VERSION_3_3) return 33;
    return gl.VERSION_3_0 ? 30 : 21;
}

constexpr Named kSwitches[] = {FBRDF_NAMED(GL_CULL_FACE),
                               FBRDF_NAMED(GL_DEPTH_TEST),
                               FBRDF_NAMED(GL_STENCIL_TEST),
                               FBRDF_NAMED(GL_SCISSOR_TEST),
                               FBRDF_NAMED(GL_COLOR_LOGIC_OP),
                               FBRDF_NAMED(GL_DITHER),
                               FBRDF_NAMED(GL_POLYGON_OFFSET_FILL),
                               FBRDF_NAMED(GL_POLYGON_OFFSET_LINE),
                               FBRDF_NAMED(GL_POLYGON_SMOOTH),
                               FBRDF_NAMED(GL_LINE_SMOOTH),
                               FBRDF_NAMED(GL_MULTISAMPLE),
                               FBRDF_NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                               FBRDF_NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                               FBRDF_NAMED(GL_SAMPLE_COVERAGE),
                               FBRDF_NAMED(GL_PROGRAM_POINT_SIZE),
                               FBRDF_NAMED(GL_CLIP_DISTANCE0),
                               FBRDF_NAMED(GL_CLIP_DISTANCE3),
                               FBRDF_NAMED(GL_CLIP_DISTANCE7, 33),
                               FBRDF_NAMED(GL_SAMPLE_MASK, 33),
                               FBRDF_NAMED(GL_RASTERIZER_DISCARD, 33),
                               FBRDF_NAMED(GL_FRAMEBUFFER_SRGB, 33),
                               FBRDF_NAMED(GL_PRIMITIVE_RESTART, 33),
                               FBRDF_NAMED(GL_DEPTH_CLAMP, 33),
                               FBRDF_NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX, 45)};
constexpr Named kCompatibilitySwitches[] = {
    FBRDF_NAMED(GL_ALPHA_TEST), FBRDF_NAMED(GL_POLYGON_STIPPLE), FBRDF_NAMED(GL_FOG),
    FBRDF_NAMED(GL_LIGHTING),   FBRDF_NAMED(GL_TEXTURE_2D),      FBRDF_NAMED(GL_NORMALIZE)};
// Whose initial value is GL_TRUE.
bool isOnAtFirst(GLenum name)
{
    return name == GL_DITHER || name == GL_MULTISAMPLE;
}

constexpr Named kNumbers[] = {FBRDF_NAMED(GL_BLEND_SRC_RGB),
                              FBRDF_NAMED(GL_BLEND_DST_RGB),
                              FBRDF_NAMED(GL_BLEND_SRC_ALPHA),
                              FBRDF_NAMED(GL_BLEND_DST_ALPHA),
                              FBRDF_NAMED(GL_BLEND_EQUATION_RGB),
                              FBRDF_NAMED(GL_BLEND_EQUATION_ALPHA),
                              FBRDF_NAMED(GL_BLEND_COLOR),
                              FBRDF_NAMED(GL_DEPTH_FUNC),
                              FBRDF_NAMED(GL_DEPTH_WRITEMASK),
                              FBRDF_NAMED(GL_DEPTH_CLEAR_VALUE),
                              FBRDF_NAMED(GL_COLOR_CLEAR_VALUE),
                              FBRDF_NAMED(GL_STENCIL_CLEAR_VALUE),
                              FBRDF_NAMED(GL_STENCIL_FUNC),
                              FBRDF_NAMED(GL_STENCIL_REF),
                              FBRDF_NAMED(GL_STENCIL_WRITEMASK),
                              FBRDF_NAMED(GL_CULL_FACE_MODE),
                              FBRDF_NAMED(GL_FRONT_FACE),
                              FBRDF_NAMED(GL_LOGIC_OP_MODE),
                              FBRDF_NAMED(GL_POLYGON_OFFSET_FACTOR),
                              FBRDF_NAMED(GL_POLYGON_OFFSET_UNITS),
                              FBRDF_NAMED(GL_SAMPLE_COVERAGE_VALUE),
                              FBRDF_NAMED(GL_PRIMITIVE_RESTART_INDEX, 33),
                              FBRDF_NAMED(GL_POLYGON_MODE),
                              FBRDF_NAMED(GL_CLIP_ORIGIN, 45),
                              FBRDF_NAMED(GL_CLIP_DEPTH_MODE, 45),
                              FBRDF_NAMED(GL_ACTIVE_TEXTURE),
                              FBRDF_NAMED(GL_CURRENT_PROGRAM),
                              FBRDF_NAMED(GL_VERTEX_ARRAY_BINDING),
                              FBRDF_NAMED(GL_ARRAY_BUFFER_BINDING),
                              FBRDF_NAMED(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                              FBRDF_NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                              FBRDF_NAMED(GL_READ_FRAMEBUFFER_BINDING),
                              FBRDF_NAMED(GL_RENDERBUFFER_BINDING),
                              FBRDF_NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                              FBRDF_NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                              FBRDF_NAMED(GL_UNIFORM_BUFFER_BINDING, 33),
                              FBRDF_NAMED(GL_VIEWPORT),
                              FBRDF_NAMED(GL_DEPTH_RANGE),
                              FBRDF_NAMED(GL_SCISSOR_BOX),
                              FBRDF_NAMED(GL_COLOR_WRITEMASK),
                              FBRDF_NAMED(GL_DRAW_BUFFER0),
                              FBRDF_NAMED(GL_READ_BUFFER),
                              FBRDF_NAMED(GL_UNPACK_ALIGNMENT),
                              FBRDF_NAMED(GL_UNPACK_ROW_LENGTH),
                              FBRDF_NAMED(GL_UNPACK_SKIP_ROWS),
                              FBRDF_NAMED(GL_UNPACK_SKIP_PIXELS),
                              FBRDF_NAMED(GL_UNPACK_SKIP_IMAGES),
                              FBRDF_NAMED(GL_UNPACK_IMAGE_HEIGHT),
                              FBRDF_NAMED(GL_UNPACK_SWAP_BYTES),
                              FBRDF_NAMED(GL_UNPACK_LSB_FIRST),
                              FBRDF_NAMED(GL_PACK_ALIGNMENT),
                              FBRDF_NAMED(GL_PACK_ROW_LENGTH),
                              FBRDF_NAMED(GL_LINE_WIDTH)};
constexpr Named kCompatibilityNumbers[] = {
    FBRDF_NAMED(GL_RED_SCALE),       FBRDF_NAMED(GL_GREEN_SCALE),
    FBRDF_NAMED(GL_BLUE_BIAS),       FBRDF_NAMED(GL_MAP_COLOR),
    FBRDF_NAMED(GL_ALPHA_TEST_FUNC), FBRDF_NAMED(GL_SHADE_MODEL),
    FBRDF_NAMED(GL_MATRIX_MODE),     FBRDF_NAMED(GL_CLAMP_FRAGMENT_COLOR, 30)};
#undef FBRDF_NAMED
#undef FBRDF_NAMED_SINCE

std::vector<double> numbers(const GladGLContext& gl, GLenum name)
{
    std::vector<double> values(16, 0.0);
    gl.GetDoublev(name, values.data());
    return values;
}

void addUnits(const GladGLContext& gl, StateSnapshot& state)
{
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint i = 0; i < kUnits; ++i) {
        gl.ActiveTexture(GL_TEXTURE0 + i);
        const std::string unit = "unit " + std::to_string(i) + " ";
        for (const GLenum name : {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D,
                                  GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP})
            state[unit + std::to_string(name)] = numbers(gl, name);
        if (gl.VERSION_3_3) state[unit + "sampler"] = numbers(gl, GL_SAMPLER_BINDING);
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
}

void addIndexed(const GladGLContext& gl, StateSnapshot& state)
{
    state["blend"] = {double(gl.IsEnabled(GL_BLEND))};
    if (!gl.VERSION_4_1) return;
    for (GLuint i = 0; i < kBuffers; ++i) {
        GLboolean mask[4] = {};
        gl.GetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
        const std::string buffer = "buffer " + std::to_string(i) + " ";
        state[buffer + "mask"] = {double(mask[0]), double(mask[1]), double(mask[2]),
                                  double(mask[3])};
        state[buffer + "blend"] = {double(gl.IsEnabledi(GL_BLEND, i))};
        for (const GLenum name : {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                  GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB}) {
            GLint value = 0;
            gl.GetIntegeri_v(name, i, &value);
            state[buffer + std::to_string(name)] = {double(value)};
        }
    }
    for (GLuint i = 0; i < kViewports; ++i) {
        const std::string view = "viewport " + std::to_string(i) + " ";
        std::vector<double> values(4, 0.0);
        gl.GetDoublei_v(GL_VIEWPORT, i, values.data());
        state[view + "box"] = values;
        gl.GetDoublei_v(GL_DEPTH_RANGE, i, values.data());
        state[view + "depth"] = values;
        GLint box[4] = {};
        gl.GetIntegeri_v(GL_SCISSOR_BOX, i, box);
        state[view + "scissor box"] = {double(box[0]), double(box[1]), double(box[2]),
                                       double(box[3])};
        state[view + "scissor"] = {double(gl.IsEnabledi(GL_SCISSOR_TEST, i))};
    }
}

void addAttributes(const GladGLContext& gl, StateSnapshot& state)
{
    for (GLuint i = 0; i < kAttributes; ++i) {
        const std::string attribute = "attribute " + std::to_string(i) + " ";
        for (const GLenum name :
             {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE,
              GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
              GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING}) {
            GLint value = 0;
            gl.GetVertexAttribiv(i, name, &value);
            state[attribute + std::to_string(name)] = {double(value)};
        }
        void* pointer = nullptr;
        gl.GetVertexAttribPointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        state[attribute + "pointer"] = {double(reinterpret_cast<uintptr_t>(pointer))};
    }
}

}  // namespace

StateSnapshot snapshot(const GladGLContext& gl, bool core)
{
    StateSnapshot state;
    const int version = versionOf(gl);
    const auto addSwitch = [&](const Named& s) {
        if (version >= s.since) state[s.name] = {double(gl.IsEnabled(s.value))};
    };
    const auto addNumber = [&](const Named& n) {
        if (version >= n.since) state[n.name] = numbers(gl, n.value);
    };
    for (const Named& s : kSwitches) addSwitch(s);
    for (const Named& n : kNumbers) addNumber(n);
    if (!core) {
        for (const Named& s : kCompatibilitySwitches) addSwitch(s);
        for (const Named& n : kCompatibilityNumbers) addNumber(n);
    }
    addUnits(gl, state);
    addIndexed(gl, state);
    addAttributes(gl, state);
    return state;
}

std::string difference(const StateSnapshot& before, const StateSnapshot& after)
{
    std::ostringstream text;
    for (const auto& [name, values] : before) {
        const auto& now = after.at(name);
        if (now == values) continue;
        text << name << ":";
        for (const double v : values) text << " " << v;
        text << " became";
        for (const double v : now) text << " " << v;
        text << "\n";
    }
    return text.str();
}

/// Random values, or the first of each choice: GL's initial one.
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

StateScrambler::StateScrambler(const GladGLContext& gl, bool core) : gl_(gl), core_(core)
{
    gl.GenTextures(4, textures2d_);
    gl.GenTextures(4, textures3d_);
    if (gl.VERSION_3_3) gl.GenSamplers(2, samplers_);
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
    program_ = linkProgram(gl, "#version 120\nvoid main() { gl_Position = vec4(0.0); }\n",
                           "#version 120\nvoid main() { gl_FragColor = vec4(0.0); }\n");
    setDefaults();
}

StateScrambler::~StateScrambler()
{
    setDefaults();
    gl_.DeleteTextures(4, textures2d_);
    gl_.DeleteTextures(4, textures3d_);
    if (gl_.VERSION_3_3) gl_.DeleteSamplers(2, samplers_);
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
    const auto setOne = [&](const Named& s) {
        if (versionOf(gl_) < s.since) return;
        source.flag(isOnAtFirst(s.value)) ? gl_.Enable(s.value) : gl_.Disable(s.value);
    };
    for (const Named& s : kSwitches) setOne(s);
    if (!core_)
        for (const Named& s : kCompatibilitySwitches) setOne(s);
}

void StateScrambler::setFixed(Source& source)
{
    gl_.DepthFunc(source.pick<GLenum>({GL_LESS, GL_ALWAYS, GL_NEVER, GL_GREATER}));
    gl_.DepthMask(source.boolean(true));
    gl_.ClearDepth(source.pick({1.0, 0.0, 0.25}));
    gl_.ClearColor(source.pick({0.0f, 0.5f}), 0.0f, 0.0f, source.pick({0.0f, 1.0f}));
    gl_.CullFace(source.pick<GLenum>({GL_BACK, GL_FRONT, GL_FRONT_AND_BACK}));
    gl_.FrontFace(source.pick<GLenum>({GL_CCW, GL_CW}));
    gl_.LogicOp(source.pick<GLenum>({GL_COPY, GL_XOR, GL_CLEAR}));
    gl_.PolygonOffset(source.pick({0.0f, 3.0f}), source.pick({0.0f, -2.0f}));
    gl_.StencilFunc(source.pick<GLenum>({GL_ALWAYS, GL_NEVER}), source.pick({0, 3}), 0xffu);
    gl_.SampleCoverage(source.pick({1.0f, 0.0f}), GL_FALSE);
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
    gl_.DepthRange(source.pick({0.0, 0.3}), source.pick({1.0, 0.5}));
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
    gl_.PixelStorei(GL_UNPACK_SWAP_BYTES, source.pick({0, 1}));
    gl_.PixelStorei(GL_UNPACK_LSB_FIRST, source.pick({0, 1}));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, source.pick({4, 1}));
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, source.pick({0, 100}));
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
        if (gl_.VERSION_3_3) gl_.BindSampler(i, source.pick({0u, samplers_[0], samplers_[1]}));
    }
    gl_.ActiveTexture(source.pick<GLenum>({GL_TEXTURE0, GL_TEXTURE2, GL_TEXTURE5}));
    gl_.UseProgram(source.pick({0u, program_}));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, source.pick({0u, framebuffers_[0]}));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, source.pick({0u, framebuffers_[1]}));
    gl_.BindRenderbuffer(GL_RENDERBUFFER, source.pick({0u, renderbuffers_[2]}));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, source.pick({0u, buffers_[2]}));
    if (gl_.VERSION_3_1) gl_.BindBuffer(GL_UNIFORM_BUFFER, source.pick({0u, buffers_[3]}));
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
}

}  // namespace fbrdf::test
