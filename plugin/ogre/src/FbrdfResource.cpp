#include "FbrdfResource.h"

#include "LogLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>

#include <OgreResourceGroupManager.h>
#include <OgreShaderGenerator.h>
#include <OgreTextureManager.h>

#include <tuple>

namespace ogreFbrdf {
namespace {

/// The bytes of a resource. Throws fbrdf::Error where there are none.
std::string bytesOf(const Ogre::String& name, const Ogre::String& group, Ogre::Resource* resource)
{
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    try {
        return groups.openResource(name, group, resource)->getAsString();
    } catch (const Ogre::Exception&) {
        const bool isListed = groups.resourceExistsInAnyGroup(name);
        const fbrdf::Found found(isListed ? "a file that cannot be read" : "no such file");
        throw fbrdf::Error(fbrdf::ErrorKind::input, name, found.expected("a material"));
    }
}

}  // namespace

bool MaterialUser::operator<(const MaterialUser& other) const
{
    return std::tie(scheme, material, group) < std::tie(other.scheme, other.material, other.group);
}

FbrdfResource::FbrdfResource(Ogre::ResourceManager* manager, const Ogre::String& name,
                             Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                             Ogre::ManualResourceLoader* loader)
    : Ogre::Resource(manager, name, handle, group, isManual, loader)
{
    createParamDictionary("Fbrdf");
}

FbrdfResource::~FbrdfResource()
{
    unload();
}

void FbrdfResource::loadImpl()
{
    try {
        read();
    } catch (const fbrdf::Error& error) {
        problem_ = error.what();
        // Without a material that stays, those who would draw it write the line.
        if (hasMaterial_) warn("the last good material stays", problem_);
    }
    if (hasMaterial_) makeTables();
    for (const MaterialUser& user : users_)
        Ogre::RTShader::ShaderGenerator::getSingleton().invalidateMaterial(
            user.scheme, user.material, user.group);
}

void FbrdfResource::read()
{
    const std::string bytes = bytesOf(mName, mGroup, this);
    fbrdf::Material material = fbrdf::materialFromFileBytes(bytes, mName);
    fbrdf::validate(material, mName);
    material_ = std::move(material);
    albedo_ = fbrdf::diffuseAlbedo(material_);
    hasMaterial_ = true;
    problem_.clear();
}

void FbrdfResource::makeTables()
{
    for (size_t k = 0; k < material_.tables.size(); ++k)
        tables_.push_back(tableTexture(material_.tables[k], material_.form.tables[k].uniform,
                                       "Fbrdf/" + mGroup + "/" + mName + "/" + std::to_string(k),
                                       Ogre::ResourceGroupManager::INTERNAL_RESOURCE_GROUP_NAME));
}

void FbrdfResource::unloadImpl()
{
    for (const TableTexture& table : tables_)
        if (table.texture) Ogre::TextureManager::getSingleton().remove(table.texture);
    tables_.clear();
}

size_t FbrdfResource::calculateSize() const
{
    return fbrdf::materialBytes(material_);
}

}  // namespace ogreFbrdf
