#include "EnvironmentResources.h"

#include "UploadGuard.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Half.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::gl {
namespace {

constexpr float kLargestHalf = 65504.0f;

GLenum faceOf(size_t face)
{
    return GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
}

void uploadHalves(const Functions& gl, GLenum face, GLint level, GLsizei size, const Vec3f* texels,
                  size_t count)
{
    std::vector<uint16_t> words;
    words.reserve(4 * count);
    for (size_t i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c)
            words.push_back(halfFromFloat(std::clamp(texels[i][c], 0.0f, kLargestHalf)));
        words.push_back(halfFromFloat(1.0f));
    }
    gl.TexImage2D(face, level, GL_RGBA16F, size, size, 0, GL_RGBA, GL_HALF_FLOAT, words.data());
}

void uploadFloats(const Functions& gl, GLenum face, GLint level, GLsizei size, const Vec3f* texels,
                  size_t count)
{
    std::vector<glm::vec4> floats;
    floats.reserve(count);
    for (size_t i = 0; i < count; ++i) floats.emplace_back(texels[i], 1.0f);
    gl.TexImage2D(face, level, GL_RGBA32F, size, size, 0, GL_RGBA, GL_FLOAT, floats.data());
}

void checkCube(const CubeImage& cube, const EnvironmentFormat& format)
{
    const auto fail = [](const std::string& what) {
        throw Error(ErrorKind::input, "environment", what);
    };
    if (cube.size != format.size || cube.levels.size() < static_cast<size_t>(format.levels()))
        fail(Found(std::to_string(cube.levels.size()) + " levels of a cube of " +
                   std::to_string(cube.size))
                 .expected(std::to_string(format.levels()) + " of " + std::to_string(format.size)));
    for (size_t level = 0; level < static_cast<size_t>(format.levels()); ++level) {
        const auto side = static_cast<size_t>(cube.sizeOf(level));
        if (cube.levels[level].size() != 6 * side * side)
            fail(Found(std::to_string(cube.levels[level].size()) + " texels in level " +
                       std::to_string(level))
                     .expected(std::to_string(6 * side * side)));
    }
}

}  // namespace

void allocateCube(const Functions& gl, int size, int levels, bool floats)
{
    const auto set = [&gl](GLenum name, GLint value) {
        gl.TexParameteri(GL_TEXTURE_CUBE_MAP, name, value);
    };
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (int level = 0; level < levels; ++level)
        for (size_t face = 0; face < 6; ++face)
            gl.TexImage2D(faceOf(face), level, floats ? GL_RGBA32F : GL_RGBA16F, size >> level,
                          size >> level, 0, GL_RGBA, floats ? GL_FLOAT : GL_HALF_FLOAT, nullptr);
}

namespace {

Object uploadedCube(const DevicePtr& device, const CubeImage& cube, int levels, bool floats)
{
    Object texture = createObject(device, ObjectKind::texture);
    device->gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture.name());
    allocateCube(device->gl, cube.size, levels, floats);
    for (int level = 0; level < levels; ++level) {
        const GLsizei side = cube.size >> level;
        const size_t count = static_cast<size_t>(side) * static_cast<size_t>(side);
        const auto& texels = cube.levels[static_cast<size_t>(level)];
        for (size_t face = 0; face < 6; ++face)
            (floats ? uploadFloats : uploadHalves)(device->gl, faceOf(face), level, side,
                                                   texels.data() + face * count, count);
    }
    label(*device, ObjectKind::texture, texture, "environment");
    checkErrors(*device, "environment");
    return texture;
}

}  // namespace

EnvironmentResources::EnvironmentResources(DevicePtr device, const CubeImage& prefiltered,
                                           const EnvironmentFormat& format, std::string whyNotOnGpu)
    : device_(std::move(device)), format_(format), whyNotOnGpu_(std::move(whyNotOnGpu))
{
    checkCube(prefiltered, format);
    const UploadGuard guard(*device_);
    cube_ = uploadedCube(device_, prefiltered, format.levels(), format.floats);
}

EnvironmentResources::EnvironmentResources(DevicePtr device, Object cube,
                                           const EnvironmentFormat& format, LobeLevels levels)
    : device_(std::move(device)),
      format_(format),
      cube_(std::move(cube)),
      unfinished_(std::move(levels))
{
    if (unfinished_->isFinished()) finish();
}

/// The cube that was convolved is kept only where it is looked up too.
void EnvironmentResources::finish()
{
    if (format_.unfiltered) unfiltered_ = unfinished_->takeSource();
    unfinished_.reset();
}

GLuint EnvironmentResources::unfiltered() const
{
    return unfinished_ && format_.unfiltered ? unfinished_->source() : unfiltered_.name();
}

void EnvironmentResources::refine(long long texels)
{
    if (!unfinished_) return;
    const UploadGuard upload(*device_);
    StateGuard state(*device_);
    // A clip control of the host could turn the picture upside down.
    state.setDepth({});
    unfinished_->draw(state, cube_.name(), texels);
    checkErrors(*device_, "environment");
    if (unfinished_->isFinished()) finish();
}

void EnvironmentResources::keepUnfiltered(const CubeImage& cube)
{
    const UploadGuard guard(*device_);
    unfiltered_ = uploadedCube(device_, cube, static_cast<int>(cube.levels.size()), true);
}

int GpuEnvironment::size() const
{
    return resources_->size();
}

int GpuEnvironment::levels() const
{
    return resources_->levels();
}

uint32_t GpuEnvironment::texture() const
{
    return resources_->texture();
}

uint32_t GpuEnvironment::unfilteredTexture() const
{
    return resources_->unfiltered();
}

bool GpuEnvironment::isFinished() const
{
    return resources_->isFinished();
}

const std::string& GpuEnvironment::whyNotOnGpu() const
{
    return resources_->whyNotOnGpu();
}

glm::mat3 environmentRotation(float angle)
{
    const float c = std::cos(angle), s = std::sin(angle);
    // Columns: where x, y and z of the environment go.
    return {c, 0.0f, -s, 0.0f, 1.0f, 0.0f, s, 0.0f, c};
}

}  // namespace fbrdf::gl
