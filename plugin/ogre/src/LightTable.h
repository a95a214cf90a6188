// LightTable.h - the lights of a view in a float texture, a row each. Their number changes what is
// in the texture, and no shader. One texture serves all views and scenes, which draw one after the
// other.
#pragma once
#include <OgreSceneManager.h>
#include <OgreTexture.h>

#include <glm/vec4.hpp>

#include <set>
#include <unordered_map>
#include <vector>

namespace ogreFbrdf {

class LightTable : public Ogre::SceneManager::Listener {
public:
    /// Lights of a view; those after them are left out.
    static constexpr int kMostLights = 4096;

    ~LightTable() override;

    /// The texture, 4 x kMostLights texels of RGBA32F.
    const Ogre::TexturePtr& texture();
    /// Brings the texture up to date for what is drawn now. True where it was written, which binds
    /// it at whatever texture unit is the active one.
    bool use(Ogre::SceneManager& scene, const Ogre::Camera& camera);
    /// Lights in the texture.
    int count() const { return static_cast<int>(rows_.size()); }
    /// The row of a light, -1 where it has none.
    int rowOf(const Ogre::Light* light) const;
    /// The viewer in eye space, as eyeFromProjection gives it.
    const glm::vec4& eye() const { return eye_; }
    /// Takes leave of all scenes and of the texture.
    void release();

private:
    void preFindVisibleObjects(Ogre::SceneManager* scene,
                               Ogre::SceneManager::IlluminationRenderStage stage,
                               Ogre::Viewport* viewport) override;
    void sceneManagerDestroyed(Ogre::SceneManager* scene) override;
    void write(const Ogre::LightList& lights, const Ogre::Camera& camera);

    Ogre::TexturePtr texture_;
    std::unordered_map<const Ogre::Light*, int> rows_;
    std::vector<float> texels_;
    std::set<Ogre::SceneManager*> scenes_;  ///< those that are listened to
    glm::vec4 eye_{0.0f};
    const Ogre::Camera* camera_ = nullptr;  ///< whose eye space the texture is in
    bool isStale_ = true, hasWarned_ = false;
};

}  // namespace ogreFbrdf
