// LightTable.h - the lights of a view in a float texture, a row each. Their number changes what is
// in the texture, and no shader. One texture serves all views and scenes, which draw one after the
// other.
#pragma once
#include <OgreSceneManager.h>
#include <OgreTexture.h>

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
    /// Brings the texture up to date for what is drawn now.
    void use(Ogre::SceneManager& scene, const Ogre::Camera& camera);
    /// Lights in the texture.
    int count() const { return static_cast<int>(rows_.size()); }
    /// The row of a light, -1 where it has none.
    int rowOf(const Ogre::Light* light) const;
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
    const Ogre::Camera* camera_ = nullptr;  ///< whose eye space the texture is in
    bool isStale_ = true, hasWarned_ = false;
};

}  // namespace ogreFbrdf
