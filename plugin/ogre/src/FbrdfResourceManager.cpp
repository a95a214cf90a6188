#include "FbrdfResourceManager.h"

#include <OgreResourceGroupManager.h>

namespace ogreFbrdf {
namespace {

/// Materials of OGRE (order 100) come after what they are made of.
constexpr float kLoadingOrder = 90.0f;
const char kResourceType[] = "Fbrdf";

}  // namespace

FbrdfResourceManager::FbrdfResourceManager()
{
    mLoadOrder = kLoadingOrder;
    mResourceType = kResourceType;
    Ogre::ResourceGroupManager::getSingleton()._registerResourceManager(mResourceType, this);
}

FbrdfResourceManager::~FbrdfResourceManager()
{
    removeAll();
    Ogre::ResourceGroupManager::getSingleton()._unregisterResourceManager(mResourceType);
}

FbrdfResourcePtr FbrdfResourceManager::loaded(const Ogre::String& name, const Ogre::String& group)
{
    const Ogre::ResourcePtr resource = createOrRetrieve(name, group).first;
    resource->load();
    return std::static_pointer_cast<FbrdfResource>(resource);
}

Ogre::Resource* FbrdfResourceManager::createImpl(const Ogre::String& name,
                                                 Ogre::ResourceHandle handle,
                                                 const Ogre::String& group, bool isManual,
                                                 Ogre::ManualResourceLoader* loader,
                                                 const Ogre::NameValuePairList*)
{
    return new FbrdfResource(this, name, handle, group, isManual, loader);
}

}  // namespace ogreFbrdf
