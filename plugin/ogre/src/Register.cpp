// The two functions by which OGRE's Root starts and stops a plugin that plugins.cfg names.
#include "FbrdfPlugin.h"

#include <OgreRoot.h>

#include <memory>

namespace {

std::unique_ptr<ogreFbrdf::FbrdfPlugin>& plugin()
{
    static std::unique_ptr<ogreFbrdf::FbrdfPlugin> instance;
    return instance;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void dllStartPlugin()
{
    plugin() = std::make_unique<ogreFbrdf::FbrdfPlugin>();
    Ogre::Root::getSingleton().installPlugin(plugin().get());
}

extern "C" __attribute__((visibility("default"))) void dllStopPlugin()
{
    Ogre::Root::getSingleton().uninstallPlugin(plugin().get());
    plugin().reset();
}
