#include "EnvironmentCube.h"

#include "PrefilteredCube.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/Prefilter.h>

#include <osg/GLExtensions>
#include <osg/Notify>
#include <osg/State>

#include <OpenThreads/ScopedLock>

#include <chrono>
#include <exception>
#include <functional>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

constexpr float kLargestHalf = 65504.0f;

bool hasFloatCubes(osg::State& state)
{
    const auto& gl = *state.get<osg::GLExtensions>();
    return gl.isCubeMapSupported &&
           (gl.glVersion >= 3.0f ||
            osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_texture_float"));
}

fbrdf::Vec3f meanOf(const fbrdf::Panorama& panorama)
{
    fbrdf::Vec3d sum(0.0);
    for (int y = 0; y < panorama.height; ++y) {
        fbrdf::Vec3d row(0.0);
        for (int x = 0; x < panorama.width; ++x) row += fbrdf::Vec3d(panorama.texel(x, y));
        sum += fbrdf::texelSolidAngle(panorama, y) / panorama.width * row;
    }
    return fbrdf::Vec3f(sum * (panorama.width / (4.0 * fbrdf::kPi)));
}

/// Halves end at 65504: infinity would spread over whole levels.
void clampToHalves(fbrdf::CubeImage& cube)
{
    for (auto& level : cube.levels)
        for (fbrdf::Vec3f& texel : level) texel = glm::min(texel, fbrdf::Vec3f(kLargestHalf));
}

/// Fills the levels of the cube map that is bound; black where cube is null.
void upload(osg::State& state, int faceSize, const fbrdf::CubeImage* cube)
{
    state.unbindPixelBufferObject();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    for (int level = 0; level < fbrdf::prefilteredLevels(faceSize); ++level) {
        const int size = faceSize >> level;
        const size_t count = static_cast<size_t>(size) * static_cast<size_t>(size);
        const std::vector<fbrdf::Vec3f> black(cube ? 0 : 6 * count, fbrdf::Vec3f(0.0f));
        const auto& texels = cube ? cube->levels[static_cast<size_t>(level)] : black;
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGBA16F_ARB, size, size,
                         0, GL_RGB, GL_FLOAT, texels.data() + face * count);
    }
}

}  // namespace

EnvironmentCube::EnvironmentCube(std::shared_ptr<const fbrdf::Panorama> panorama, int faceSize,
                                 const std::string& name)
    : panorama_(std::move(panorama)), faceSize_(faceSize), mean_(meanOf(*panorama_))
{
    setName(name);
    setFilter(MIN_FILTER, LINEAR_MIPMAP_LINEAR);
    setFilter(MAG_FILTER, LINEAR);
    for (const auto axis : {WRAP_S, WRAP_T, WRAP_R}) setWrap(axis, CLAMP_TO_EDGE);
    setResizeNonPowerOfTwoHint(false);
}

EnvironmentCube::EnvironmentCube(const EnvironmentCube& other, const osg::CopyOp& op)
    : osg::TextureCubeMap(other, op),
      panorama_(other.panorama_),
      faceSize_(other.faceSize_),
      mean_(other.mean_)
{
}

float EnvironmentCube::levelOffset() const
{
    return static_cast<float>(fbrdf::cubeLevelOf(0.0, faceSize_));
}

// Two that are made of one panorama still have textures of their own.
int EnvironmentCube::compare(const osg::StateAttribute& other) const
{
    return this == &other ? 0 : std::less<>()(this, &other) ? -1 : 1;
}

void EnvironmentCube::apply(osg::State& state) const
{
    if (!panorama_) return osg::TextureCubeMap::apply(state);
    const unsigned int contextId = state.getContextID();
    if (!hasFloatCubes(state)) return refuse(contextId);
    TextureObject* const object = getTextureObject(contextId);
    if (object && !waits(contextId)) return object->bind();
    const Made cube = madeBy(state);
    if (object)
        object->bind();
    else
        bindNewTexture(state);
    if (cube || !object) upload(state, faceSize_, cube.get());
    setWaiting(contextId, !cube);
}

void EnvironmentCube::compileGLObjects(osg::State& state) const
{
    apply(state);
    // The texture is bound to the active unit without the state's knowledge.
    state.haveAppliedTextureAttribute(state.getActiveTextureUnit(), osg::StateAttribute::TEXTURE);
}

void EnvironmentCube::bindNewTexture(osg::State& state) const
{
    const int levels = fbrdf::prefilteredLevels(faceSize_);
    TextureObject* object =
        generateAndAssignTextureObject(state.getContextID(), GL_TEXTURE_CUBE_MAP, levels,
                                       GL_RGBA16F_ARB, faceSize_, faceSize_, 1, 0);
    object->bind();
    object->setAllocated(true);
    applyTexParameters(GL_TEXTURE_CUBE_MAP, state);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

/// What has been made by now; null: nothing.
EnvironmentCube::Made EnvironmentCube::made() const
{
    const Lock lock(mutex_);
    if (!made_ && onCpu_.valid() &&
        onCpu_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        made_ = onCpu_.get();
    return made_;
}

/// The same, drawn by the context where that is needed and possible. May leave other textures
/// bound.
EnvironmentCube::Made EnvironmentCube::madeBy(osg::State& state) const
{
    const Lock lock(drawing_);
    if (const Made known = made()) return known;
    if (onCpu_.valid()) return nullptr;  // which is set with this lock held
    try {
        const auto cube =
            std::make_shared<fbrdf::CubeImage>(drawnCube(state, *panorama_, faceSize_));
        clampToHalves(*cube);
        const Lock data(mutex_);
        made_ = cube;
        return cube;
    } catch (const fbrdf::Error& error) {
        // Drawing is the faster way, not the only one.
        beginOnCpu(error.what());
        return nullptr;
    }
}

void EnvironmentCube::beginOnCpu(const std::string& why) const
{
    OSG_NOTICE << "osgFbrdf: environment " << getName()
               << " is prefiltered by the CPU, and coarsely: " << why << std::endl;
    const Lock lock(mutex_);
    whyOnCpu_ = why;
    const auto compute = [panorama = panorama_, faceSize = faceSize_]() -> Made {
        const auto cube = std::make_shared<fbrdf::CubeImage>(computedCube(*panorama, faceSize));
        clampToHalves(*cube);
        return cube;
    };
    try {
        onCpu_ = std::async(std::launch::async, compute).share();
    } catch (const std::exception&) {  // there are no threads
        onCpu_ = std::async(std::launch::deferred, compute).share();
        onCpu_.wait();
    }
}

bool EnvironmentCube::waits(unsigned int contextId) const
{
    const Lock lock(mutex_);
    return waiting_.count(contextId) > 0;
}

void EnvironmentCube::setWaiting(unsigned int contextId, bool waiting) const
{
    const Lock lock(mutex_);
    if (waiting)
        waiting_.insert(contextId);
    else
        waiting_.erase(contextId);
}

/// For good: the context cannot store it.
void EnvironmentCube::refuse(unsigned int contextId) const
{
    const Lock lock(mutex_);
    refused_[contextId] =
        fbrdf::Found("no float textures").expected("OpenGL 3.0 or GL_ARB_texture_float");
}

std::string EnvironmentCube::whyNotReady(unsigned int contextId) const
{
    const bool isMade = made() != nullptr;
    const Lock lock(mutex_);
    const auto refused = refused_.find(contextId);
    if (refused != refused_.end()) return refused->second;
    if (isMade || waiting_.count(contextId) == 0) return "";
    return fbrdf::Found("an environment that the CPU prefilters (" + whyOnCpu_ + ")")
        .expected("later frames");
}

void EnvironmentCube::releaseGLObjects(osg::State* state) const
{
    osg::TextureCubeMap::releaseGLObjects(state);
    const Lock lock(mutex_);
    if (!state) {
        waiting_.clear();
        refused_.clear();
        return;
    }
    waiting_.erase(state->getContextID());
    refused_.erase(state->getContextID());
}

}  // namespace osgFbrdf
