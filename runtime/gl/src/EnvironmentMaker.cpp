// Two steps, as on the CPU (Prefilter.h): the environment becomes a cube of floats with mipmaps,
// and each level of the result is that cube convolved with a lobe.
#include "EnvironmentMaker.h"

#include "CubePainter.h"
#include "TextureUpload.h"
#include "UploadGuard.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PrefilterSource.h>

#include <cmath>
#include <limits>

namespace fbrdf::gl {
namespace {

constexpr float kMostOfFloat = std::numeric_limits<float>::max();
// Texels on a side of the finest level that is drawn at once where the others may come gradually.
constexpr int kGradualSize = 32;

/// Why the GPU cannot draw cubes of floats; "" where it can.
std::string whyNotDrawn(const Device& device)
{
    const Capabilities& c = device.capabilities;
    if (!c.framebufferObjects) return Found("no framebuffer objects").expected("them");
    if (!c.floatTargets) return Found("no float surfaces that can be drawn to").expected("them");
    if (!c.choosesLevels())
        return Found("no choice of levels in fragment shaders").expected("textureLod");
    // Lobes that reach over an edge would be wrong by more than the seams of a draw.
    if (!c.seamlessCubes)
        return Found("cube maps that are filtered within their faces").expected("across edges");
    if (device.gl.es != 0 && !device.gl.hasExtension("GL_OES_texture_float_linear"))
        return Found("float textures that are not filtered").expected("filtered ones");
    return "";
}

/// Where radiance comes from; the texture is the renderer's or the host's.
struct RadianceSource {
    GLuint texture = 0;
    bool cube = false;
    int width = 0, height = 0;  ///< where they are known; GLSL 1.20 needs them
    GLenum target() const { return cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D; }
};

Object panoramaTexture(const DevicePtr& device, const Panorama& panorama)
{
    const Functions& gl = device->gl;
    Object texture = createObject(device, ObjectKind::texture);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    setSampling(gl, GL_TEXTURE_2D, false);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, panorama.width, panorama.height, 0, GL_RGB, GL_FLOAT,
                  panorama.texels.data());
    label(*device, ObjectKind::texture, texture, "panorama");
    return texture;
}

Object emptyCube(const DevicePtr& device, StateGuard& state, int size, int levels, bool floats)
{
    Object cube = createObject(device, ObjectKind::texture);
    state.bindTexture(0, GL_TEXTURE_CUBE_MAP, cube.name());
    allocateCube(device->gl, size, levels, floats);
    return cube;
}

/// Draws the cube that is convolved, and its mipmaps.
Object sourceCube(const DevicePtr& device, StateGuard& state, const RadianceSource& source,
                  int size)
{
    const Functions& gl = device->gl;
    const MeshResources triangle(device, coveringTriangle());
    const MeshBinding binding(triangle);
    CubePainter painter(device, state, triangle);
    const int levels = 1 + static_cast<int>(std::lround(std::log2(size)));
    Object cube = emptyCube(device, state, size, levels, true);
    const Object program = painter.programOf(
        prefilterSourceFragment(device->capabilities.glsl, source.cube), "environment source");
    state.bindTexture(0, source.target(), source.texture);
    state.filterAcrossEdges();
    painter.setSampler(program, "fbrdfRadiance", 0);
    const GLint sourceSize = gl.GetUniformLocation(program.name(), "fbrdfSourceSize");
    if (sourceSize >= 0)
        gl.Uniform2f(sourceSize, static_cast<GLfloat>(source.width),
                     static_cast<GLfloat>(source.height));
    painter.draw(program, cube.name(), {0, size, 0, size}, kMostOfFloat);
    state.bindTexture(0, GL_TEXTURE_CUBE_MAP, cube.name());
    gl.GenerateMipmap(GL_TEXTURE_CUBE_MAP);
    return cube;
}

/// Throws Error(gl).
EnvironmentPtr drawnEnvironment(const DevicePtr& device, const RadianceSource& source,
                                const EnvironmentFormat& format)
{
    const UploadGuard upload(*device);
    StateGuard state(*device);
    // A clip control of the host could turn the picture upside down.
    state.setDepth({});
    Object result = emptyCube(device, state, format.size, format.levels(), format.floats);
    LobeLevels levels(device, state, sourceCube(device, state, source, format.size), format);
    levels.drawUpTo(state, result.name(), format.gradual ? kGradualSize : format.size);
    label(*device, ObjectKind::texture, result, "environment");
    checkErrors(*device, "environment");
    return std::make_shared<EnvironmentResources>(device, std::move(result), format,
                                                  std::move(levels));
}

EnvironmentPtr drawnPanorama(const DevicePtr& device, const Panorama& panorama,
                             const EnvironmentFormat& format)
{
    const std::string why = whyNotDrawn(*device);
    if (!why.empty()) throw Error(ErrorKind::gl, "environment", why);
    const int most = device->capabilities.maxTextureSize;
    const bool fits = panorama.width <= most && panorama.height <= most;
    const Panorama smaller = fits ? Panorama{} : reduced(panorama, most);
    const Panorama& used = fits ? panorama : smaller;
    const UploadGuard upload(*device);
    const Object texture = panoramaTexture(device, used);
    checkErrors(*device, "environment");
    return drawnEnvironment(device, {texture.name(), false, used.width, used.height}, format);
}

/// Size and kind of a texture of the host. Throws Error(gl) for a name that is none.
RadianceSource sourceOf(const Device& device, const HostEnvironment& host)
{
    const Functions& gl = device.gl;
    const auto fail = [](const std::string& what) {
        throw Error(ErrorKind::gl, "environment", what);
    };
    if (host.texture == 0 || !gl.IsTexture(host.texture))
        fail(Found("texture " + std::to_string(host.texture) + ", which there is not")
                 .expected("one of the host"));
    RadianceSource source{host.texture, host.cube};
    if (gl.es != 0) return source;
    const UploadGuard bindings(device);
    gl.BindTexture(source.target(), host.texture);
    const GLenum image = host.cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D;
    gl.GetTexLevelParameteriv(image, 0, GL_TEXTURE_WIDTH, &source.width);
    gl.GetTexLevelParameteriv(image, 0, GL_TEXTURE_HEIGHT, &source.height);
    checkErrors(device, "environment");
    if (source.width < 1 || source.height < 1)
        fail(Found("texture " + std::to_string(host.texture) + " without texels")
                 .expected("radiance"));
    return source;
}

}  // namespace

EnvironmentPtr makeEnvironment(const DevicePtr& device, const Panorama& panorama,
                               const EnvironmentFormat& format)
{
    std::string why;
    try {
        return drawnPanorama(device, panorama, format);
    } catch (const Error& error) {
        // Drawing is the faster way, not the only one.
        why = error.what();
        discardErrors(*device);
    }
    device->log(Severity::note, "an environment is prefiltered by the CPU: " + why);
    const CubeImage cube = cubeOfPanorama(panorama, format.size);
    const auto made =
        std::make_shared<EnvironmentResources>(device, prefiltered(cube, format.size), format, why);
    if (format.unfiltered) made->keepUnfiltered(cube);
    return made;
}

EnvironmentPtr makeEnvironment(const DevicePtr& device, const HostEnvironment& source,
                               const EnvironmentFormat& format)
{
    const std::string why = whyNotDrawn(*device);
    if (!why.empty()) throw Error(ErrorKind::gl, "environment", why);
    return drawnEnvironment(device, sourceOf(*device, source), format);
}

}  // namespace fbrdf::gl
