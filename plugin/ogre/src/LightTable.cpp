#include "LightTable.h"

#include "LightRow.h"
#include "LogLine.h"
#include "Matrices.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreResourceGroupManager.h>
#include <OgreTextureManager.h>

#include <algorithm>

namespace ogreFbrdf {

LightTable::~LightTable() = default;

const Ogre::TexturePtr& LightTable::texture()
{
    if (!texture_)
        texture_ = Ogre::TextureManager::getSingleton().createManual(
            "Fbrdf/Lights", Ogre::ResourceGroupManager::INTERNAL_RESOURCE_GROUP_NAME,
            Ogre::TEX_TYPE_2D, kTexelsPerLight, kMostLights, 0, Ogre::PF_FLOAT32_RGBA);
    return texture_;
}

bool LightTable::use(Ogre::SceneManager& scene, const Ogre::Camera& camera)
{
    if (scenes_.insert(&scene).second) scene.addListener(this);
    if (!isStale_ && camera_ == &camera) return false;
    write(scene._getLightsAffectingFrustum(), camera);
    eye_ = glm::vec4(fbrdf::eyeFromProjection(
        glm::dmat4(matrixOf(Ogre::Matrix4(camera.getProjectionMatrix())))));
    camera_ = &camera;
    isStale_ = false;
    return true;
}

void LightTable::write(const Ogre::LightList& lights, const Ogre::Camera& camera)
{
    const size_t used = std::min(lights.size(), static_cast<size_t>(kMostLights));
    if (used < lights.size() && !hasWarned_) {
        hasWarned_ = true;
        warn("camera '" + camera.getName() + "'",
             "lights are left out: " + fbrdf::Found(std::to_string(lights.size()))
                                           .expected("at most " + std::to_string(kMostLights)));
    }
    const glm::dmat4 toEye = glm::dmat4(matrixOf(Ogre::Matrix4(camera.getViewMatrix(true))));
    rows_.clear();
    texels_.clear();
    for (size_t i = 0; i < used; ++i) {
        rows_.emplace(lights[i], static_cast<int>(i));
        for (const glm::vec4& texel : lightRow(*lights[i], toEye))
            texels_.insert(texels_.end(), {texel.x, texel.y, texel.z, texel.w});
    }
    if (used == 0) return;
    const auto rows = static_cast<Ogre::uint32>(used);
    const Ogre::PixelBox box(kTexelsPerLight, rows, 1, Ogre::PF_FLOAT32_RGBA, texels_.data());
    texture()->getBuffer()->blitFromMemory(box, Ogre::Box(0, 0, kTexelsPerLight, rows));
}

int LightTable::rowOf(const Ogre::Light* light) const
{
    const auto found = rows_.find(light);
    return found == rows_.end() ? -1 : found->second;
}

void LightTable::release()
{
    for (Ogre::SceneManager* scene : scenes_) scene->removeListener(this);
    scenes_.clear();
    if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
    texture_.reset();
    rows_.clear();
    isStale_ = true;
}

void LightTable::preFindVisibleObjects(Ogre::SceneManager*,
                                       Ogre::SceneManager::IlluminationRenderStage, Ogre::Viewport*)
{
    isStale_ = true;
}

void LightTable::sceneManagerDestroyed(Ogre::SceneManager* scene)
{
    scenes_.erase(scene);
}

}  // namespace ogreFbrdf
