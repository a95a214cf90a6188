#include "StateList.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace fbrdf::test {
namespace {

constexpr int kEs = 30, kEs31 = 31, kNotInEs = 99;

constexpr NamedState named(const char* name, GLenum value, int since, int sinceEs)
{
    return {name, value, since, sinceEs};
}
#define FBRDF_NAMED(x) named(#x, x, 21, kNotInEs)
#define FBRDF_SINCE(since, x) named(#x, x, since, kNotInEs)
#define FBRDF_BOTH(x) named(#x, x, 21, kEs)
#define FBRDF_BOTH_SINCE(since, sinceEs, x) named(#x, x, since, sinceEs)

int versionOf(const GladGLContext& gl)
{
    if (gl.VERSION_4_5) return 45;
    if (gl.VERSION_4_1) return 41;
    if (gl.VERSION_3_3) return 33;
    return gl.VERSION_3_0 ? 30 : 21;
}

constexpr NamedState kSwitches[] = {FBRDF_BOTH(GL_CULL_FACE),
                                    FBRDF_BOTH(GL_DEPTH_TEST),
                                    FBRDF_BOTH(GL_STENCIL_TEST),
                                    FBRDF_BOTH(GL_SCISSOR_TEST),
                                    FBRDF_NAMED(GL_COLOR_LOGIC_OP),
                                    FBRDF_BOTH(GL_DITHER),
                                    FBRDF_BOTH(GL_POLYGON_OFFSET_FILL),
                                    FBRDF_NAMED(GL_POLYGON_OFFSET_LINE),
                                    FBRDF_NAMED(GL_POLYGON_SMOOTH),
                                    FBRDF_NAMED(GL_LINE_SMOOTH),
                                    FBRDF_NAMED(GL_MULTISAMPLE),
                                    FBRDF_BOTH(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                    FBRDF_NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                                    FBRDF_BOTH(GL_SAMPLE_COVERAGE),
                                    FBRDF_NAMED(GL_PROGRAM_POINT_SIZE),
                                    FBRDF_NAMED(GL_CLIP_DISTANCE0),
                                    FBRDF_NAMED(GL_CLIP_DISTANCE3),
                                    FBRDF_SINCE(33, GL_CLIP_DISTANCE7),
                                    FBRDF_BOTH_SINCE(33, kEs31, GL_SAMPLE_MASK),
                                    FBRDF_BOTH_SINCE(33, kEs, GL_RASTERIZER_DISCARD),
                                    FBRDF_SINCE(33, GL_FRAMEBUFFER_SRGB),
                                    FBRDF_SINCE(33, GL_PRIMITIVE_RESTART),
                                    FBRDF_SINCE(33, GL_TEXTURE_CUBE_MAP_SEAMLESS),
                                    FBRDF_SINCE(33, GL_DEPTH_CLAMP),
                                    FBRDF_BOTH_SINCE(45, kEs, GL_PRIMITIVE_RESTART_FIXED_INDEX)};
constexpr NamedState kCompatibilitySwitches[] = {
    FBRDF_NAMED(GL_ALPHA_TEST), FBRDF_NAMED(GL_POLYGON_STIPPLE), FBRDF_NAMED(GL_FOG),
    FBRDF_NAMED(GL_LIGHTING),   FBRDF_NAMED(GL_TEXTURE_2D),      FBRDF_NAMED(GL_NORMALIZE)};
constexpr NamedState kNumbers[] = {FBRDF_BOTH(GL_BLEND_SRC_RGB),
                                   FBRDF_BOTH(GL_BLEND_DST_RGB),
                                   FBRDF_BOTH(GL_BLEND_SRC_ALPHA),
                                   FBRDF_BOTH(GL_BLEND_DST_ALPHA),
                                   FBRDF_BOTH(GL_BLEND_EQUATION_RGB),
                                   FBRDF_BOTH(GL_BLEND_EQUATION_ALPHA),
                                   FBRDF_BOTH(GL_BLEND_COLOR),
                                   FBRDF_BOTH(GL_DEPTH_FUNC),
                                   FBRDF_BOTH(GL_DEPTH_WRITEMASK),
                                   FBRDF_BOTH(GL_DEPTH_CLEAR_VALUE),
                                   FBRDF_BOTH(GL_COLOR_CLEAR_VALUE),
                                   FBRDF_BOTH(GL_STENCIL_CLEAR_VALUE),
                                   FBRDF_BOTH(GL_STENCIL_FUNC),
                                   FBRDF_BOTH(GL_STENCIL_REF),
                                   FBRDF_BOTH(GL_STENCIL_WRITEMASK),
                                   FBRDF_BOTH(GL_CULL_FACE_MODE),
                                   FBRDF_BOTH(GL_FRONT_FACE),
                                   FBRDF_NAMED(GL_LOGIC_OP_MODE),
                                   FBRDF_BOTH(GL_POLYGON_OFFSET_FACTOR),
                                   FBRDF_BOTH(GL_POLYGON_OFFSET_UNITS),
                                   FBRDF_BOTH(GL_SAMPLE_COVERAGE_VALUE),
                                   FBRDF_SINCE(33, GL_PRIMITIVE_RESTART_INDEX),
                                   FBRDF_NAMED(GL_POLYGON_MODE),
                                   FBRDF_SINCE(45, GL_CLIP_ORIGIN),
                                   FBRDF_SINCE(45, GL_CLIP_DEPTH_MODE),
                                   FBRDF_BOTH(GL_ACTIVE_TEXTURE),
                                   FBRDF_BOTH(GL_CURRENT_PROGRAM),
                                   FBRDF_BOTH(GL_VERTEX_ARRAY_BINDING),
                                   FBRDF_BOTH(GL_ARRAY_BUFFER_BINDING),
                                   FBRDF_BOTH(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                                   FBRDF_BOTH(GL_DRAW_FRAMEBUFFER_BINDING),
                                   FBRDF_BOTH(GL_READ_FRAMEBUFFER_BINDING),
                                   FBRDF_BOTH(GL_RENDERBUFFER_BINDING),
                                   FBRDF_BOTH(GL_PIXEL_PACK_BUFFER_BINDING),
                                   FBRDF_BOTH(GL_PIXEL_UNPACK_BUFFER_BINDING),
                                   FBRDF_BOTH_SINCE(33, kEs, GL_UNIFORM_BUFFER_BINDING),
                                   FBRDF_BOTH(GL_VIEWPORT),
                                   FBRDF_BOTH(GL_DEPTH_RANGE),
                                   FBRDF_BOTH(GL_SCISSOR_BOX),
                                   FBRDF_BOTH(GL_COLOR_WRITEMASK),
                                   FBRDF_BOTH(GL_DRAW_BUFFER0),
                                   FBRDF_BOTH(GL_READ_BUFFER),
                                   FBRDF_BOTH(GL_UNPACK_ALIGNMENT),
                                   FBRDF_BOTH(GL_UNPACK_ROW_LENGTH),
                                   FBRDF_BOTH(GL_UNPACK_SKIP_ROWS),
                                   FBRDF_BOTH(GL_UNPACK_SKIP_PIXELS),
                                   FBRDF_BOTH(GL_UNPACK_SKIP_IMAGES),
                                   FBRDF_BOTH(GL_UNPACK_IMAGE_HEIGHT),
                                   FBRDF_NAMED(GL_UNPACK_SWAP_BYTES),
                                   FBRDF_NAMED(GL_UNPACK_LSB_FIRST),
                                   FBRDF_BOTH(GL_PACK_ALIGNMENT),
                                   FBRDF_BOTH(GL_PACK_ROW_LENGTH),
                                   FBRDF_BOTH(GL_PACK_SKIP_ROWS),
                                   FBRDF_BOTH(GL_PACK_SKIP_PIXELS),
                                   FBRDF_NAMED(GL_PACK_SWAP_BYTES),
                                   FBRDF_NAMED(GL_PACK_LSB_FIRST),
                                   FBRDF_BOTH(GL_LINE_WIDTH)};
constexpr NamedState kCompatibilityNumbers[] = {
    FBRDF_NAMED(GL_RED_SCALE),       FBRDF_NAMED(GL_GREEN_SCALE),
    FBRDF_NAMED(GL_BLUE_BIAS),       FBRDF_NAMED(GL_MAP_COLOR),
    FBRDF_NAMED(GL_ALPHA_TEST_FUNC), FBRDF_NAMED(GL_SHADE_MODEL),
    FBRDF_NAMED(GL_MATRIX_MODE),     FBRDF_SINCE(30, GL_CLAMP_FRAGMENT_COLOR)};
#undef FBRDF_NAMED
#undef FBRDF_SINCE
#undef FBRDF_BOTH
#undef FBRDF_BOTH_SINCE

// Those that a driver here may have; GL's header for tests does not name them.
constexpr std::pair<const char*, NamedState> kExtensionSwitches[] = {
    {"GL_EXT_depth_bounds_test", {"GL_DEPTH_BOUNDS_TEST_EXT", 0x8890, 21, kNotInEs}},
    {"GL_NV_conservative_raster", {"GL_CONSERVATIVE_RASTERIZATION_NV", 0x9346, 21, kNotInEs}}};

bool hasExtension(const GladGLContext& gl, const std::string& name)
{
    if (!gl.VERSION_3_0) {
        const auto* all = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
        return all && (" " + std::string(all) + " ").find(" " + name + " ") != std::string::npos;
    }
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (name ==
            reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
            return true;
    return false;
}

bool knows(const GladGLContext& gl, const NamedState& state)
{
    if (!isEs(gl)) return versionOf(gl) >= state.since;
    return state.sinceEs <= (gl.VERSION_3_1 ? kEs31 : kEs);
}

std::vector<double> numbers(const GladGLContext& gl, GLenum name)
{
    std::vector<double> values(16, 0.0);
    if (!isEs(gl)) {
        gl.GetDoublev(name, values.data());
        return values;
    }
    GLfloat floats[16] = {};
    gl.GetFloatv(name, floats);
    std::copy(floats, floats + 16, values.begin());
    return values;
}

void addUnits(const GladGLContext& gl, StateSnapshot& state)
{
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint i = 0; i < kUnits; ++i) {
        gl.ActiveTexture(GL_TEXTURE0 + i);
        const std::string unit = "unit " + std::to_string(i) + " ";
        for (const GLenum name : std::initializer_list<GLenum>{
                 GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP})
            state[unit + std::to_string(name)] = numbers(gl, name);
        if (!isEs(gl)) state[unit + "1D"] = numbers(gl, GL_TEXTURE_BINDING_1D);
        if (gl.VERSION_3_0) state[unit + "array"] = numbers(gl, GL_TEXTURE_BINDING_2D_ARRAY);
        if (gl.VERSION_3_1 && !isEs(gl))
            state[unit + "buffer"] = numbers(gl, GL_TEXTURE_BINDING_BUFFER);
        if (gl.VERSION_3_3 || isEs(gl)) state[unit + "sampler"] = numbers(gl, GL_SAMPLER_BINDING);
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
        for (const GLenum name :
             std::initializer_list<GLenum>{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
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
        values.assign(2, 0.0);
        gl.GetDoublei_v(GL_DEPTH_RANGE, i, values.data());
        state[view + "depth"] = values;
        GLint box[4] = {};
        gl.GetIntegeri_v(GL_SCISSOR_BOX, i, box);
        state[view + "scissor box"] = {double(box[0]), double(box[1]), double(box[2]),
                                       double(box[3])};
        state[view + "scissor"] = {double(gl.IsEnabledi(GL_SCISSOR_TEST, i))};
    }
}

void addStorage(const GladGLContext& gl, StateSnapshot& state)
{
    if (!gl.VERSION_4_3 || isEs(gl)) return;
    state["storage"] = numbers(gl, GL_SHADER_STORAGE_BUFFER_BINDING);
    for (GLuint i = 0; i < kStorageBindings; ++i) {
        GLint buffer = 0;
        GLint64 start = 0, size = 0;
        gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &buffer);
        gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &start);
        gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &size);
        state["storage " + std::to_string(i)] = {double(buffer), double(start), double(size)};
    }
}

void addAttributes(const GladGLContext& gl, StateSnapshot& state)
{
    for (GLuint i = 0; i < kAttributes; ++i) {
        const std::string attribute = "attribute " + std::to_string(i) + " ";
        for (const GLenum name : std::initializer_list<GLenum>{
                 GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE,
                 GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
                 GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING}) {
            GLint value = 0;
            gl.GetVertexAttribiv(i, name, &value);
            state[attribute + std::to_string(name)] = {double(value)};
        }
        void* pointer = nullptr;
        gl.GetVertexAttribPointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        GLfloat current[4] = {};
        if (i > 0) gl.GetVertexAttribfv(i, GL_CURRENT_VERTEX_ATTRIB, current);
        state[attribute + "current"] = {current, current + 4};
        state[attribute + "pointer"] = {double(reinterpret_cast<uintptr_t>(pointer))};
    }
}

}  // namespace

bool isEs(const GladGLContext& gl)
{
    const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    return version && std::string(version).rfind("OpenGL ES", 0) == 0;
}

std::vector<NamedState> switches(const GladGLContext& gl, bool core)
{
    std::vector<NamedState> result;
    for (const NamedState& s : kSwitches)
        if (knows(gl, s)) result.push_back(s);
    if (!core)
        result.insert(result.end(), std::begin(kCompatibilitySwitches),
                      std::end(kCompatibilitySwitches));
    for (const auto& [extension, state] : kExtensionSwitches)
        if (hasExtension(gl, extension)) result.push_back(state);
    return result;
}

StateSnapshot snapshot(const GladGLContext& gl, bool core)
{
    StateSnapshot state;
    const auto addNumber = [&](const NamedState& n) {
        if (knows(gl, n)) state[n.name] = numbers(gl, n.value);
    };
    for (const NamedState& s : switches(gl, core)) state[s.name] = {double(gl.IsEnabled(s.value))};
    for (const NamedState& n : kNumbers) addNumber(n);
    if (!core) {
        for (const NamedState& n : kCompatibilityNumbers) addNumber(n);
    }
    addUnits(gl, state);
    addIndexed(gl, state);
    addStorage(gl, state);
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

}  // namespace fbrdf::test
