// TableTexture.h - a table of a material as a texture of OGRE, or as knots for a uniform.
#pragma once
#include <fbrdf/brdf/Table.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <OgreTexture.h>

#include <string>
#include <vector>

namespace ogreFbrdf {

struct TableTexture {
    Ogre::TexturePtr texture;  ///< empty where the table is in a uniform
    std::vector<fbrdf::Vec3f> knots;
    fbrdf::TableEncoding encoding;
    fbrdf::Vec3f lower{0.0f}, extent{1.0f};  ///< where encoding.ranged
};

/// What OGRE's render system can do.
fbrdf::Capabilities capabilitiesOfRenderSystem();

/// name: of the texture, unique in the group. uniform: the form has the table in a uniform.
TableTexture tableTexture(const fbrdf::Table& table, bool uniform, const Ogre::String& name,
                          const Ogre::String& group);

}  // namespace ogreFbrdf
