#include "StateGuard.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

struct Switch {
    GLenum name;
    int since;               ///< version that knows it
    bool fixedFunctionOnly;  ///< does not exist in a core profile
    int sinceEs = 99;        ///< version of OpenGL ES that knows it; 99: none
};

// All that could change or discard a fragment. Blending, depth and scissor are kept apart, because
// newer versions index them.
constexpr Switch kSwitches[] = {
    {GL_CULL_FACE, 21, false, 20},
    {GL_STENCIL_TEST, 21, false, 20},
    {GL_COLOR_LOGIC_OP, 21, false},
    {GL_DITHER, 21, false, 20},
    {GL_POLYGON_OFFSET_FILL, 21, false, 20},
    // Lines are not drawn, but with it Mesa 22.3 loses pixels of filled triangles.
    {GL_POLYGON_OFFSET_LINE, 21, false},
    {GL_POLYGON_OFFSET_POINT, 21, false},
    {GL_POLYGON_SMOOTH, 21, false},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 21, false, 20},
    {GL_SAMPLE_ALPHA_TO_ONE, 21, false},
    {GL_SAMPLE_COVERAGE, 21, false, 20},
    {GL_CLIP_DISTANCE0, 21, false},
    {GL_CLIP_DISTANCE1, 21, false},
    {GL_CLIP_DISTANCE2, 21, false},
    {GL_CLIP_DISTANCE3, 21, false},
    {GL_CLIP_DISTANCE4, 21, false},
    {GL_CLIP_DISTANCE5, 21, false},
    {GL_CLIP_DISTANCE6, 30, false},
    {GL_CLIP_DISTANCE7, 30, false},
    {GL_RASTERIZER_DISCARD, 30, false, 30},
    {GL_FRAMEBUFFER_SRGB, 30, false},
    {GL_PRIMITIVE_RESTART, 31, false},
    {GL_DEPTH_CLAMP, 32, false},
    {GL_SAMPLE_MASK, 32, false, 31},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 43, false, 30},
    {GL_ALPHA_TEST, 21, true},
    {GL_POLYGON_STIPPLE, 21, true},
};

GLenum enumOf(GLint value)
{
    return static_cast<GLenum>(value);
}

bool isOn(const Functions& gl, GLenum name)
{
    return gl.IsEnabled(name) == GL_TRUE;
}

void set(const Functions& gl, GLenum name, bool on)
{
    on ? gl.Enable(name) : gl.Disable(name);
}

// Only draw buffer 0 is drawn to, and a call without an index would change all of them.
void setFirst(const Functions& gl, GLenum name, bool on, int indexedSince)
{
    if (gl.version < indexedSince) return set(gl, name, on);
    on ? gl.Enablei(name, 0) : gl.Disablei(name, 0);
}

// What setFirst changes is asked for with the same index: without one a driver may answer for all
// buffers together (NVIDIA 580, compatibility profile).
bool isFirstOn(const Functions& gl, GLenum name, int indexedSince)
{
    return gl.version < indexedSince ? isOn(gl, name) : gl.IsEnabledi(name, 0) == GL_TRUE;
}

GLint firstInteger(const Functions& gl, GLenum name, int indexedSince)
{
    if (gl.version < indexedSince) return integer(gl, name);
    GLint value = 0;
    gl.GetIntegeri_v(name, 0, &value);
    return value;
}

}  // namespace

StateGuard::StateGuard(const Device& device)
    : device_(device),
      gl_(device.gl),
      mode_(device.state),
      colourMasks_(4 * static_cast<size_t>(device.drawBuffers), GL_TRUE)
{
    // Queries may stall a driver that works in a thread of its own; two modes do without.
    if (mode_ == StateMode::restore) {
        saveBindings();
        saveFixed();
    }
    // In all modes: what the host has set must not change what is drawn.
    disableAll();
    setFixed();
}

StateGuard::~StateGuard()
{
    if (mode_ == StateMode::leave) {
        if (device_.capabilities.vertexArrays) gl_.BindVertexArray(0);
        return;
    }
    // Textures first: this moves the active unit, which restoreTextures puts back as well.
    restoreTextures();
    for (const GLenum name : switches_) gl_.Enable(name);
    restoreFixed();
    restoreBindings();
}

void StateGuard::restoreBindings() const
{
    // A program that was deleted while in use has no name to return to.
    const GLuint program = unsignedOf(program_);
    gl_.UseProgram(program != 0 && gl_.IsProgram(program) ? program : 0);
    if (device_.capabilities.vertexArrays) gl_.BindVertexArray(unsignedOf(vertexArray_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, unsignedOf(arrayBuffer_));
    if (device_.capabilities.framebufferObjects)
        gl_.BindFramebuffer(gl_.drawFramebuffer(), unsignedOf(framebuffer_));
}

void StateGuard::saveBindings()
{
    // The index buffer is not saved: it belongs to the vertex array (or to MeshBinding, without
    // them).
    program_ = integer(gl_, GL_CURRENT_PROGRAM);
    activeTexture_ = integer(gl_, GL_ACTIVE_TEXTURE);
    arrayBuffer_ = integer(gl_, GL_ARRAY_BUFFER_BINDING);
    if (device_.capabilities.vertexArrays) vertexArray_ = integer(gl_, GL_VERTEX_ARRAY_BINDING);
    if (device_.capabilities.framebufferObjects)
        framebuffer_ = integer(gl_, GL_DRAW_FRAMEBUFFER_BINDING);
}

void StateGuard::saveFixed()
{
    // From 3.0 on each draw buffer has a mask of its own, which a call without an index overwrites.
    if (gl_.version < 30)
        gl_.GetBooleanv(GL_COLOR_WRITEMASK, colourMasks_.data());
    else
        for (int i = 0; i < device_.drawBuffers; ++i)
            gl_.GetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i),
                              &colourMasks_[4 * static_cast<size_t>(i)]);
    const GLenum functions[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                GL_BLEND_DST_ALPHA};
    for (int i = 0; i < 4; ++i) blendFunctions_[i] = firstInteger(gl_, functions[i], 40);
    blendEquations_[0] = firstInteger(gl_, GL_BLEND_EQUATION_RGB, 40);
    blendEquations_[1] = firstInteger(gl_, GL_BLEND_EQUATION_ALPHA, 40);
    blend_ = isFirstOn(gl_, GL_BLEND, 30);
    depthTest_ = isOn(gl_, GL_DEPTH_TEST);
    scissor_ = isFirstOn(gl_, GL_SCISSOR_TEST, 41);
    depthFunction_ = integer(gl_, GL_DEPTH_FUNC);
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    gl_.version < 41 ? gl_.GetFloatv(GL_VIEWPORT, viewport_)
                     : gl_.GetFloati_v(GL_VIEWPORT, 0, viewport_);
    saveDepths();
    // Two values come back where front and back may differ, which a core profile does not allow.
    if (!gl_.es) gl_.GetIntegerv(GL_POLYGON_MODE, polygonMode_);
    if (gl_.version >= 30 && !device_.capabilities.coreProfile)
        clampColour_ = integer(gl_, GL_CLAMP_FRAGMENT_COLOR);
    if (gl_.hasClipControl) {
        clipOrigin_ = integer(gl_, GL_CLIP_ORIGIN);
        clipDepth_ = integer(gl_, GL_CLIP_DEPTH_MODE);
    }
}

void StateGuard::saveDepths()
{
    if (!gl_.es) {
        // The range of a viewport is double from 4.1 on, where the one without index may be float.
        gl_.version < 41 ? gl_.GetDoublev(GL_DEPTH_RANGE, depthRange_)
                         : gl_.GetDoublei_v(GL_DEPTH_RANGE, 0, depthRange_);
        return gl_.GetDoublev(GL_DEPTH_CLEAR_VALUE, &clearDepth_);
    }
    GLfloat range[2] = {0.0f, 1.0f}, clear = 1.0f;
    gl_.GetFloatv(GL_DEPTH_RANGE, range);
    gl_.GetFloatv(GL_DEPTH_CLEAR_VALUE, &clear);
    std::copy(range, range + 2, depthRange_);
    clearDepth_ = static_cast<double>(clear);
}

void StateGuard::disableAll()
{
    for (const Switch& s : kSwitches) {
        if (!gl_.has(s.since, s.sinceEs) ||
            (s.fixedFunctionOnly && device_.capabilities.coreProfile))
            continue;
        // Without restoring, what is off by default stays off; GL_DITHER alone is on by default.
        const bool onInTheEnd =
            mode_ == StateMode::restore ? isOn(gl_, s.name) : s.name == GL_DITHER;
        if (onInTheEnd) switches_.push_back(s.name);
        if (onInTheEnd || mode_ != StateMode::restore) gl_.Disable(s.name);
    }
    for (const GLenum name : device_.extensionSwitches) {
        const bool onInTheEnd = mode_ == StateMode::restore && isOn(gl_, name);
        if (onInTheEnd) switches_.push_back(name);
        if (onInTheEnd || mode_ != StateMode::restore) gl_.Disable(name);
    }
    setFirst(gl_, GL_SCISSOR_TEST, false, 41);
    gl_.Enable(GL_DEPTH_TEST);
}

void StateGuard::setFixed()
{
    // Other draw buffers of the host's framebuffer are not ours to write.
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (int i = 1; i < device_.drawBuffers; ++i)
        gl_.ColorMaski(static_cast<GLuint>(i), GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    if (!gl_.es) gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    // Compatibility contexts may clamp what a shader writes to [0, 1], also in float targets.
    if (gl_.version >= 30 && !device_.capabilities.coreProfile)
        gl_.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FIXED_ONLY);
}

void StateGuard::restoreFixed() const
{
    if (gl_.version < 30)
        gl_.ColorMask(colourMasks_[0], colourMasks_[1], colourMasks_[2], colourMasks_[3]);
    else
        for (size_t i = 0; i < colourMasks_.size() / 4; ++i) {
            const GLboolean* mask = &colourMasks_[4 * i];
            gl_.ColorMaski(static_cast<GLuint>(i), mask[0], mask[1], mask[2], mask[3]);
        }
    const GLenum f[] = {enumOf(blendFunctions_[0]), enumOf(blendFunctions_[1]),
                        enumOf(blendFunctions_[2]), enumOf(blendFunctions_[3])};
    const GLenum rgb = enumOf(blendEquations_[0]), alpha = enumOf(blendEquations_[1]);
    if (gl_.version >= 40) {
        gl_.BlendFuncSeparatei(0, f[0], f[1], f[2], f[3]);
        gl_.BlendEquationSeparatei(0, rgb, alpha);
    } else {
        gl_.BlendFuncSeparate(f[0], f[1], f[2], f[3]);
        gl_.BlendEquationSeparate(rgb, alpha);
    }
    setFirst(gl_, GL_BLEND, blend_, 30);
    set(gl_, GL_DEPTH_TEST, depthTest_);
    setFirst(gl_, GL_SCISSOR_TEST, scissor_, 41);
    if (scissorSet_ && mode_ == StateMode::restore)
        setScissorBox({scissorBox_[0], scissorBox_[1], scissorBox_[2], scissorBox_[3]});
    gl_.DepthFunc(enumOf(depthFunction_));
    gl_.DepthMask(depthMask_);
    gl_.clearDepth(clearDepth_);
    restoreDepthRangeAndViewport();
    if (gl_.hasClipControl) gl_.ClipControl(enumOf(clipOrigin_), enumOf(clipDepth_));
    if (gl_.es) return;
    // GL_FRONT alone is an error in a core profile.
    if (device_.capabilities.coreProfile) {
        gl_.PolygonMode(GL_FRONT_AND_BACK, enumOf(polygonMode_[0]));
    } else {
        gl_.PolygonMode(GL_FRONT, enumOf(polygonMode_[0]));
        gl_.PolygonMode(GL_BACK, enumOf(polygonMode_[1]));
        if (gl_.version >= 30) gl_.ClampColor(GL_CLAMP_FRAGMENT_COLOR, enumOf(clampColour_));
    }
}

void StateGuard::setDepthRange(double low, double high) const
{
    if (gl_.version >= 41)
        gl_.DepthRangeIndexed(0, low, high);
    else
        gl_.depthRange(low, high);
}

void StateGuard::setDepth(const DepthOptions& depth)
{
    setDepthRange(static_cast<double>(depth.rangeLow), static_cast<double>(depth.rangeHigh));
    gl_.clearDepth(static_cast<double>(depth.clear));
    // Upper left would turn triangles around and the picture upside down, so it is reset as well.
    const GLenum clip =
        depth.clip == ClipDepth::zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE;
    if (gl_.hasClipControl) gl_.ClipControl(GL_LOWER_LEFT, clip);
}

void StateGuard::restoreDepthRangeAndViewport() const
{
    setDepthRange(depthRange_[0], depthRange_[1]);
    // Defaults of the viewport are those of the window, which are not known here: ours stays.
    if (mode_ != StateMode::restore) return;
    if (gl_.version >= 41)
        gl_.ViewportIndexedf(0, viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    else
        gl_.Viewport(static_cast<GLint>(viewport_[0]), static_cast<GLint>(viewport_[1]),
                     static_cast<GLsizei>(viewport_[2]), static_cast<GLsizei>(viewport_[3]));
}

void StateGuard::setTarget(const Target& target)
{
    if (device_.capabilities.framebufferObjects)
        gl_.BindFramebuffer(gl_.drawFramebuffer(), target.framebuffer);
    if (gl_.version >= 41)
        gl_.ViewportIndexedf(0, 0.0f, 0.0f, static_cast<GLfloat>(target.width),
                             static_cast<GLfloat>(target.height));
    else
        gl_.Viewport(0, 0, target.width, target.height);
}

StateGuard::SavedUnit StateGuard::savedUnit(GLenum name) const
{
    // All targets of the unit: which one the next material of this draw binds is not known yet.
    return {name,
            integer(gl_, GL_TEXTURE_BINDING_2D),
            gl_.hasVolumes() ? integer(gl_, GL_TEXTURE_BINDING_3D) : 0,
            gl_.version >= 31 ? integer(gl_, GL_TEXTURE_BINDING_BUFFER) : 0,
            gl_.hasSamplers() ? integer(gl_, GL_SAMPLER_BINDING) : 0,
            gl_.hasArrays() ? integer(gl_, GL_TEXTURE_BINDING_2D_ARRAY) : 0,
            integer(gl_, GL_TEXTURE_BINDING_CUBE_MAP)};
}

void StateGuard::setScissor(const PixelRect* rect)
{
    setFirst(gl_, GL_SCISSOR_TEST, rect != nullptr, 41);
    if (!rect) return;
    if (!scissorSet_ && mode_ == StateMode::restore)
        gl_.version >= 41 ? gl_.GetIntegeri_v(GL_SCISSOR_BOX, 0, scissorBox_)
                          : gl_.GetIntegerv(GL_SCISSOR_BOX, scissorBox_);
    // The box is saved when it is first changed: most draws never do.
    scissorSet_ = true;
    setScissorBox({rect->x, rect->y, rect->width, rect->height});
}

void StateGuard::setScissorBox(const PixelRect& box) const
{
    if (gl_.version >= 41)
        gl_.ScissorIndexed(0, box.x, box.y, box.width, box.height);
    else
        gl_.Scissor(box.x, box.y, box.width, box.height);
}

void StateGuard::bindTexture(int unit, GLenum target, GLuint texture)
{
    FBRDF_ASSERT(unit, >=, 0);
    FBRDF_ASSERT(device_.firstTextureUnit + unit, <, device_.capabilities.maxTextureUnits);
    const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(device_.firstTextureUnit + unit);
    gl_.ActiveTexture(name);
    const auto isSaved = [name](const SavedUnit& u) { return u.unit == name; };
    // A pass may bind a unit that an earlier one has saved already.
    if (std::none_of(units_.begin(), units_.end(), isSaved)) {
        units_.push_back(mode_ == StateMode::restore ? savedUnit(name) : SavedUnit{name});
        // A sampler object of the host would override the filters of our textures.
        if (gl_.hasSamplers()) gl_.BindSampler(name - GL_TEXTURE0, 0);
    }
    gl_.BindTexture(target, texture);
}

// OpenGL ES 3.0 always filters so. It is enabled only where our maps need it, because hooks of the
// host may read cube maps of its own.
void StateGuard::filterAcrossEdges()
{
    if (seamlessSet_ || gl_.es || !device_.capabilities.seamlessCubes) return;
    seamless_ = mode_ == StateMode::restore && isOn(gl_, GL_TEXTURE_CUBE_MAP_SEAMLESS);
    seamlessSet_ = true;
    gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void StateGuard::restoreTextures() const
{
    if (seamlessSet_ && !seamless_) gl_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    for (const SavedUnit& saved : units_) {
        gl_.ActiveTexture(saved.unit);
        gl_.BindTexture(GL_TEXTURE_2D, unsignedOf(saved.texture2d));
        if (gl_.hasVolumes()) gl_.BindTexture(GL_TEXTURE_3D, unsignedOf(saved.texture3d));
        if (gl_.hasArrays()) gl_.BindTexture(GL_TEXTURE_2D_ARRAY, unsignedOf(saved.textureArray));
        gl_.BindTexture(GL_TEXTURE_CUBE_MAP, unsignedOf(saved.textureCube));
        if (gl_.version >= 31) gl_.BindTexture(GL_TEXTURE_BUFFER, unsignedOf(saved.textureBuffer));
        if (gl_.hasSamplers()) gl_.BindSampler(saved.unit - GL_TEXTURE0, unsignedOf(saved.sampler));
    }
    gl_.ActiveTexture(enumOf(activeTexture_));
}

}  // namespace fbrdf::gl
