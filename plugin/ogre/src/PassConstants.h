// PassConstants.h - the uniforms of a generated pass that OGRE does not know of.
#pragma once
#include "BrdfOptions.h"
#include "FbrdfResource.h"
#include "LightTable.h"

#include <OgrePass.h>

#include <glm/vec4.hpp>

#include <vector>

namespace ogreFbrdf {

/// Where a pass has its textures.
struct PassUnits {
    unsigned short tables = 0;  ///< the first of those of the material's tables
    unsigned short lights = 0, normalMap = 0;
};

/// Lights of one object that fit into the uniform that lists them; an object with more is lit by
/// all lights of the view, whose ranges the shader observes by itself.
constexpr int kMostListed = 256;

/// What changes from object to object.
struct ObjectConstants {
    int lights = 0;
    std::vector<float> rows;  ///< of the lights in the texture; empty: the first ones
    int shadowedLight = -1;   ///< which of them OGRE's integrated shadow dims
    glm::vec4 eye{0.0f}, emitted{0.0f};
    bool operator==(const ObjectConstants& other) const;
};

ObjectConstants objectConstants(const Ogre::LightList& lights, const LightTable& table,
                                const Ogre::Pass& pass, bool hasShadows);
void setMaterialConstants(const Ogre::Pass& pass, const FbrdfResource& material,
                          const BrdfOptions& options, const PassUnits& units);
void setObjectConstants(const Ogre::Pass& pass, const ObjectConstants& constants);

}  // namespace ogreFbrdf
