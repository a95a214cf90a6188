#include "PrefilteredCube.h"

#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/gl/Environment.h>
#include <fbrdf/gl/Renderer.h>

#include <osg/GLExtensions>
#include <osg/State>
#include <osg/Texture2D>

#include <algorithm>

namespace osgFbrdf {
namespace {

// One core takes 6 s for such faces, and a minute for 512.
constexpr int kComputedFaceSize = 128;
// As the runtime chooses (fbrdf/gl/Environment.h): 5 s of processor time in Mesa, for 512 13 s.
constexpr int kSoftwareFaceSize = 256;

// OSG takes the OpenGL of the libraries that are linked, whatever made the context; so do we.
void* load(void*, const char* name)
{
    return osg::getGLExtensionFuncPtr(name);
}

/// Its first row is the upper edge.
osg::ref_ptr<osg::Texture2D> textureOf(const fbrdf::Panorama& panorama)
{
    // OSG takes texels that it may change; these are only read.
    auto* texels = const_cast<fbrdf::Vec3f*>(panorama.texels.data());
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(panorama.width, panorama.height, 1, GL_RGB32F_ARB, GL_RGB, GL_FLOAT,
                    reinterpret_cast<unsigned char*>(texels), osg::Image::NO_DELETE);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

/// The texels of the cube map, which stays bound to the active unit.
fbrdf::CubeImage texelsOf(const fbrdf::gl::GpuEnvironment& environment)
{
    fbrdf::CubeImage cube{environment.size(), {}};
    glBindTexture(GL_TEXTURE_CUBE_MAP, environment.texture());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int level = 0; level < environment.levels(); ++level) {
        const auto side = static_cast<size_t>(environment.size() >> level);
        auto& texels = cube.levels.emplace_back(6 * side * side);
        for (GLenum face = 0; face < 6; ++face)
            glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGB, GL_FLOAT,
                          texels.data() + face * side * side);
    }
    return cube;
}

/// A level of `size` for a lobe. The first level of the cube stands for narrower lobes.
std::vector<fbrdf::Vec3f> resampled(const fbrdf::CubeImage& cube, double lobeLevel, int size)
{
    const double level = std::max(0.0, fbrdf::cubeLevelOf(lobeLevel, cube.size));
    std::vector<fbrdf::Vec3f> texels;
    texels.reserve(6 * static_cast<size_t>(size) * static_cast<size_t>(size));
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                texels.emplace_back(
                    fbrdf::sampleCube(cube, fbrdf::cubeTexelDirection(face, x, y, size), level));
    return texels;
}

/// The cube with faces of at least its own size.
fbrdf::CubeImage enlarged(fbrdf::CubeImage cube, int faceSize)
{
    if (cube.size == faceSize) return cube;
    fbrdf::CubeImage larger{faceSize, {}};
    const int levels = fbrdf::prefilteredLevels(faceSize);
    for (int level = 0; level < levels; ++level)
        larger.levels.push_back(
            resampled(cube, level + fbrdf::kLobeLevels - levels, faceSize >> level));
    return larger;
}

}  // namespace

fbrdf::CubeImage drawnCube(osg::State& state, const fbrdf::Panorama& panorama, int faceSize)
{
    fbrdf::gl::RendererOptions options;
    options.load = load;
    options.debugLabels = false;
    fbrdf::gl::Renderer renderer(options);
    const fbrdf::Capabilities& capabilities = renderer.capabilities();
    const int most = capabilities.maxTextureSize;
    const bool fits = panorama.width <= most && panorama.height <= most;
    const fbrdf::Panorama smaller = fits ? fbrdf::Panorama{} : fbrdf::reduced(panorama, most);
    const osg::ref_ptr<osg::Texture2D> source = textureOf(fits ? panorama : smaller);
    source->apply(state);
    // Of a texture of the host the renderer makes it by drawing, and never on the CPU meanwhile.
    const int size =
        capabilities.softwareSampling ? std::min(faceSize, kSoftwareFaceSize) : faceSize;
    const auto environment = renderer.createEnvironment(
        fbrdf::gl::HostEnvironment{source->getTextureObject(state.getContextID())->id(), false},
        {size, false});
    fbrdf::CubeImage cube = enlarged(texelsOf(*environment), faceSize);
    glBindTexture(GL_TEXTURE_2D, 0);
    return cube;
}

fbrdf::CubeImage computedCube(const fbrdf::Panorama& panorama, int faceSize)
{
    const int size = std::min(faceSize, kComputedFaceSize);
    return enlarged(fbrdf::prefiltered(fbrdf::cubeOfPanorama(panorama, size, 1), size, 1),
                    faceSize);
}

}  // namespace osgFbrdf
