#include "TableTexture.h"

#include <fbrdf/shaders/TextureImage.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreRoot.h>
#include <OgreTextureManager.h>

namespace ogreFbrdf {
namespace {

Ogre::PixelFormat formatOf(fbrdf::TexelType type)
{
    switch (type) {
        case fbrdf::TexelType::unorm16: return Ogre::PF_SHORT_RGB;
        case fbrdf::TexelType::half: return Ogre::PF_FLOAT16_RGB;
        case fbrdf::TexelType::float32: return Ogre::PF_FLOAT32_RGB;
    }
    return Ogre::PF_UNKNOWN;
}

}  // namespace

fbrdf::Capabilities capabilitiesOfRenderSystem()
{
    fbrdf::Capabilities result;
    const Ogre::RenderSystem* system = Ogre::Root::getSingleton().getRenderSystem();
    if (!system) return result;
    const Ogre::RenderSystemCapabilities& has = *system->getCapabilities();
    const int native = system->getNativeShadingLanguageVersion();
    for (const int version : {120, 140, 150, 330})
        if (version <= native) result.glsl = version;
    result.maxTextureUnits = has.getNumTextureUnits();
    result.maxUniformVectors = has.getFragmentProgramConstantFloatCount();
    result.floatTextures = has.hasCapability(Ogre::RSC_TEXTURE_FLOAT);
    return result;
}

TableTexture tableTexture(const fbrdf::Table& table, bool uniform, const Ogre::String& name,
                          const Ogre::String& group)
{
    TableTexture result;
    if (uniform) {
        result.knots = fbrdf::uniformKnots(table);
        result.encoding.logarithmic = isLog(table.storage);
        return result;
    }
    fbrdf::TextureImage image = fbrdf::textureImage(table, capabilitiesOfRenderSystem());
    result.encoding = image.encoding;
    result.lower = image.lower;
    result.extent = image.extent;
    const auto width = static_cast<Ogre::uint32>(image.size[0]),
               height = static_cast<Ogre::uint32>(image.size[1]),
               depth = static_cast<Ogre::uint32>(image.size[2]);
    const Ogre::PixelFormat format = formatOf(image.type);
    result.texture = Ogre::TextureManager::getSingleton().createManual(
        name, group, dimensionCount(table.domain) == 3 ? Ogre::TEX_TYPE_3D : Ogre::TEX_TYPE_2D,
        width, height, depth, 0, format);
    void* texels = image.words.data();
    if (image.type == fbrdf::TexelType::float32) texels = image.floats.data();
    result.texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(width, height, depth, format, texels));
    return result;
}

}  // namespace ogreFbrdf
