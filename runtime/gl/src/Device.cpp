#include "Device.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cstdio>

namespace fbrdf::gl {
namespace {

// glGetError of a lost context never ends.
constexpr int kMostErrors = 16;

/// True where the context has no fixed function.
// 3.1 has no profiles, but an extension that brings the fixed function back.
bool isCoreProfile(const Functions& gl)
{
    if (gl.es) return true;
    if (gl.version >= 32)
        return (integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
    return gl.version == 31 && !gl.hasExtension("GL_ARB_compatibility");
}

int glslVersion(const Functions& gl)
{
    if (gl.es) return gl.es >= 30 ? 300 : 100;
    int major = 1, minor = 20;
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_SHADING_LANGUAGE_VERSION));
    if (text) std::sscanf(text, "%d.%d", &major, &minor);
    const int version = 100 * major + minor;
    // The newest version that our shaders are written in.
    for (const int supported : {450, 330, 150, 140})
        if (version >= supported) return supported;
    return 120;
}

// GL cannot be asked whether a CPU draws, so names decide; an unknown one only costs speed.
bool isSoftware(const Functions& gl)
{
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string renderer = text ? text : "";
    for (const char* known : {"llvmpipe", "softpipe", "SwiftShader"})
        if (renderer.find(known) != std::string::npos) return true;
    return false;
}

/// The number of vec4 uniforms that a fragment shader may have.
int uniformVectors(const Functions& gl)
{
    return gl.es ? integer(gl, GL_MAX_FRAGMENT_UNIFORM_VECTORS)
                 : integer(gl, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS) / 4;
}

/// True where half or float textures exist and are filtered linearly.
bool hasFloatTextures(const Functions& gl)
{
    if (!gl.es) return gl.version >= 30 || gl.ARB_texture_float;
    return gl.es >= 30 || (gl.hasExtension("GL_OES_texture_half_float") &&
                           gl.hasExtension("GL_OES_texture_half_float_linear"));
}

/// True where RGBA32F textures exist and are filtered linearly.
bool has32BitTextures(const Functions& gl)
{
    if (!gl.es) return hasFloatTextures(gl);
    return gl.hasExtension("GL_OES_texture_float_linear") &&
           (gl.es >= 30 || gl.hasExtension("GL_OES_texture_float"));
}

/// True where RGBA32F can be rendered to and blended.
bool hasFloatTargets(const Functions& gl)
{
    if (!gl.es) return gl.version >= 30 || (gl.ARB_texture_float && gl.ARB_color_buffer_float);
    return gl.es >= 30 && gl.hasExtension("GL_EXT_color_buffer_float") &&
           gl.hasExtension("GL_EXT_float_blend");
}

/// True where RGBA16F can be rendered to and blended.
bool hasHalfTargets(const Functions& gl)
{
    return hasFloatTargets(gl) ||
           (gl.es >= 30 && (gl.hasExtension("GL_EXT_color_buffer_float") ||
                            gl.hasExtension("GL_EXT_color_buffer_half_float")));
}

/// True where compute shaders can be used; their functions are optional (see Functions.cpp).
bool hasComputeShaders(const Functions& gl)
{
    return gl.version >= 43 && gl.DispatchCompute && gl.MemoryBarrier && gl.BindBufferBase &&
           gl.BindBufferRange && gl.GetInteger64i_v && gl.Uniform3i;
}

Capabilities detected(const Functions& gl)
{
    Capabilities c;
    const int version = gl.es ? gl.es : gl.version;
    c.glMajor = version / 10;
    c.glMinor = version % 10;
    c.glsl = glslVersion(gl);
    c.maxTextureUnits = integer(gl, GL_MAX_TEXTURE_IMAGE_UNITS);
    c.maxTextureSize = integer(gl, GL_MAX_TEXTURE_SIZE);
    c.max3dTextureSize = gl.hasVolumes() ? integer(gl, GL_MAX_3D_TEXTURE_SIZE) : 0;
    c.maxCubeSize = integer(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    c.seamlessCubes = gl.has(32, 30) || gl.hasExtension("GL_ARB_seamless_cube_map");
    c.maxUniformVectors = uniformVectors(gl);
    c.textureLod = gl.version >= 30 || gl.hasExtension("GL_ARB_shader_texture_lod");
    c.coreProfile = isCoreProfile(gl);
    c.framebufferObjects = gl.has(30, 20) || gl.ARB_framebuffer_object;
    c.floatTextures = hasFloatTextures(gl);
    c.unorm16Textures = gl.es == 0;
    c.softwareSampling = isSoftware(gl) && has32BitTextures(gl);
    c.floatTargets = hasFloatTargets(gl);
    c.halfTargets = hasHalfTargets(gl);
    c.unorm16Targets = gl.es == 0 && gl.version >= 30;
    c.vertexArrays = gl.has(30, 30) || gl.ARB_vertex_array_object;
    if (gl.hasArrays()) c.maxArrayLayers = integer(gl, GL_MAX_ARRAY_TEXTURE_LAYERS);
    c.bufferTextures = gl.version >= 31;
    // GL sets an error on names that it does not know, so each limit waits for its version.
    if (c.bufferTextures) c.maxBufferTexels = integer(gl, GL_MAX_TEXTURE_BUFFER_SIZE);
    if (hasComputeShaders(gl)) {
        c.computeBuffers = std::min(integer(gl, GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS),
                                    integer(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS));
        c.maxStorageBytes = integer(gl, GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    }
    c.clipControl = gl.hasClipControl;
    c.debug = (gl.es ? gl.es >= 32 : gl.KHR_debug || gl.version >= 43) && gl.PushDebugGroup &&
              gl.PopDebugGroup && gl.ObjectLabel;
    return c;
}

std::vector<GLenum> extensionSwitchesOf(const Functions& gl)
{
    constexpr std::pair<GLenum, const char*> kKnown[] = {
        {0x8890, "GL_EXT_depth_bounds_test"},             // GL_DEPTH_BOUNDS_TEST_EXT
        {0x9346, "GL_NV_conservative_raster"},            // GL_CONSERVATIVE_RASTERIZATION_NV
        {0x83FE, "GL_INTEL_conservative_rasterization"},  // GL_CONSERVATIVE_RASTERIZATION_INTEL
        {0x9563, "GL_NV_shading_rate_image"},             // GL_SHADING_RATE_IMAGE_NV
        {0x9555, "GL_NV_scissor_exclusive"},              // GL_SCISSOR_TEST_EXCLUSIVE_NV
        {0x9327, "GL_EXT_raster_multisample"},            // GL_RASTER_MULTISAMPLE_EXT
    };
    std::vector<GLenum> found;
    for (const auto& [name, extension] : kKnown)
        if (gl.hasExtension(extension)) found.push_back(name);
    return found;
}

/// The capabilities that a host asked for, less those that the context does not have.
Capabilities granted(Capabilities wanted, const Capabilities& found)
{
    // Numbers are left to the host: a lower limit is safe, a higher one is its own risk.
    wanted.framebufferObjects = wanted.framebufferObjects && found.framebufferObjects;
    wanted.vertexArrays = wanted.vertexArrays && found.vertexArrays;
    wanted.debug = wanted.debug && found.debug;
    wanted.clipControl = wanted.clipControl && found.clipControl;
    wanted.seamlessCubes = wanted.seamlessCubes && found.seamlessCubes;
    wanted.textureLod = wanted.textureLod && found.textureLod;
    wanted.bufferTextures = wanted.bufferTextures && found.bufferTextures && wanted.glsl >= 140;
    wanted.computeBuffers = std::min(wanted.computeBuffers, found.computeBuffers);
    wanted.maxArrayLayers = std::min(wanted.maxArrayLayers, found.maxArrayLayers);
    wanted.coreProfile = found.coreProfile;
    return wanted;
}

void check(const Capabilities& c, bool embedded)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::gl, "OpenGL", what); };
    if (embedded && c.glsl != 100 && c.glsl != 300)
        fail(Found("GLSL " + std::to_string(c.glsl)).expected("100 or 300 in OpenGL ES"));
    if (embedded) return;
    if (10 * c.glMajor + c.glMinor < 21 || c.glsl < 120)
        fail(Found("version " + std::to_string(c.glMajor) + "." + std::to_string(c.glMinor) +
                   " with GLSL " + std::to_string(c.glsl))
                 .expected("2.1 with GLSL 120 or newer"));
    if (c.coreProfile && !c.vertexArrays)
        fail(Found("a core profile without vertex arrays").expected("them"));
}

std::string text(const Functions& gl, GLenum name)
{
    const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
    return value ? value : "";
}

}  // namespace

DevicePtr createDevice(const RendererOptions& options)
{
    auto device = std::make_shared<Device>();
    device->gl = loadFunctions(options.load, options.loadUser);
    const Capabilities found = detected(device->gl);
    device->capabilities = granted(options.capabilities.value_or(found), found);
    check(device->capabilities, device->gl.es != 0);
    device->capabilities.debug = device->capabilities.debug && options.debugLabels;
    device->extensionSwitches = extensionSwitchesOf(device->gl);
    device->logTo = options.log;
    device->passes = options.passes;
    device->state = options.state;
    if (device->gl.version >= 30) device->drawBuffers = integer(device->gl, GL_MAX_DRAW_BUFFERS);
    device->wideIndices =
        device->gl.has(21, 30) || device->gl.hasExtension("GL_OES_element_index_uint");
    device->renderer = text(device->gl, GL_RENDERER);
    device->version = text(device->gl, GL_VERSION);
    device->firstTextureUnit = options.firstTextureUnit;
    if (options.firstTextureUnit < 0 ||
        options.firstTextureUnit >= device->capabilities.maxTextureUnits)
        throw Error(
            ErrorKind::usage, "OpenGL",
            Found("first texture unit " + std::to_string(options.firstTextureUnit))
                .expected("one of " + std::to_string(device->capabilities.maxTextureUnits)));
    return device;
}

void checkErrors(const Device& device, const std::string& where)
{
    GLenum first = GL_NO_ERROR;
    for (int i = 0; i < kMostErrors; ++i) {
        const GLenum error = device.gl.GetError();
        if (error == GL_NO_ERROR) break;
        if (first == GL_NO_ERROR) first = error;
    }
    if (first == GL_NO_ERROR) return;
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", first);
    throw Error(ErrorKind::gl, where,
                Found("GL error " + std::string(code) +
                      (first == GL_OUT_OF_MEMORY ? " (out of memory)" : ""))
                    .expected("none"));
}

void discardErrors(const Device& device)
{
    for (int i = 0; i < kMostErrors; ++i)
        if (device.gl.GetError() == GL_NO_ERROR) return;
}

void discardHostErrors(const Device& device)
{
    for (int i = 0; i < kMostErrors; ++i) {
        const GLenum error = device.gl.GetError();
        if (error == GL_NO_ERROR) return;
        device.log(Severity::warning,
                   "the host left GL error " + std::to_string(error) + " behind");
    }
}

}  // namespace fbrdf::gl
