// EnvironmentCube.h - an environment convolved with the lobes of materials (fbrdf/environment/
// Prefilter.h), as a cube map for all contexts. The first context that applies it makes it by
// drawing; where it cannot, a thread of the CPU does. What was made is kept for other contexts.
#pragma once
#include <fbrdf/environment/CubeImage.h>

#include <osg/TextureCubeMap>

#include <OpenThreads/Mutex>

#include <future>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace osgFbrdf {

/// Does not change. Thread-safe, where contexts that share objects are drawn by one thread, as OSG
/// demands.
class EnvironmentCube : public osg::TextureCubeMap {
public:
    EnvironmentCube() = default;  ///< binds no texture: OSG makes one as the default of a unit
    /// faceSize: a power of two from fbrdf::kSmallestFace on. The panorama is valid.
    EnvironmentCube(std::shared_ptr<const fbrdf::Panorama> panorama, int faceSize,
                    const std::string& name);
    EnvironmentCube(const EnvironmentCube& other,
                    const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_StateAttribute(osgFbrdf, EnvironmentCube, TEXTURE)

    /// What is added to a level of a lobe to get the level of the cube map.
    float levelOffset() const;
    /// Why the context has none yet; empty where it has, or has not tried.
    std::string whyNotReady(unsigned int contextId) const;
    /// The mean radiance of all directions.
    const fbrdf::Vec3f& mean() const { return mean_; }
    const std::shared_ptr<const fbrdf::Panorama>& panorama() const { return panorama_; }

    int compare(const osg::StateAttribute& other) const override;
    void apply(osg::State& state) const override;
    void compileGLObjects(osg::State& state) const override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~EnvironmentCube() override = default;

private:
    using Made = std::shared_ptr<const fbrdf::CubeImage>;
    void bindNewTexture(osg::State& state) const;
    Made made() const;
    Made madeBy(osg::State& state) const;
    void beginOnCpu(const std::string& why) const;
    bool waits(unsigned int contextId) const;
    void setWaiting(unsigned int contextId, bool waiting) const;
    void refuse(unsigned int contextId) const;

    std::shared_ptr<const fbrdf::Panorama> panorama_;  ///< null: see the first constructor
    int faceSize_ = 0;
    fbrdf::Vec3f mean_{0.0f};
    mutable OpenThreads::Mutex drawing_;  ///< one context draws it, and others wait for that
    mutable OpenThreads::Mutex mutex_;    ///< guards what follows
    mutable Made made_;
    mutable std::set<unsigned int> waiting_;  ///< contexts whose texture is black for want of it
    mutable std::map<unsigned int, std::string> refused_;  ///< those that can have none, and why
    mutable std::shared_future<Made> onCpu_;               ///< its destructor waits
    mutable std::string whyOnCpu_;
};

}  // namespace osgFbrdf
