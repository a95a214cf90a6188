// FbrdfResourceManager.h - the resource manager of .fbrdf files, of the resource type "Fbrdf":
// groups, declarations and reloading are those of all resources of OGRE.
#pragma once
#include "FbrdfResource.h"

#include <OgreResourceManager.h>

namespace ogreFbrdf {

class FbrdfResourceManager : public Ogre::ResourceManager {
public:
    FbrdfResourceManager();
    ~FbrdfResourceManager() override;
    /// The loaded resource.
    FbrdfResourcePtr loaded(const Ogre::String& name, const Ogre::String& group);

private:
    Ogre::Resource* createImpl(const Ogre::String& name, Ogre::ResourceHandle handle,
                               const Ogre::String& group, bool isManual,
                               Ogre::ManualResourceLoader* loader,
                               const Ogre::NameValuePairList* parameters) override;
};

}  // namespace ogreFbrdf
