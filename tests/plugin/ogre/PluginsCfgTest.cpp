// OGRE finds the plugin by the line that docs/ogre.md gives for plugins.cfg.
#include "OgreHost.h"

#include "support/FileBytes.h"
#include "support/TemporaryDir.h"

#include <gtest/gtest.h>
#include <OgrePlugin.h>

namespace fbrdf::test {
namespace {

TEST(PluginsCfg, NamesThePluginWithoutItsVersion)
{
    const TemporaryDir folder;
    const std::filesystem::path plugin = OgreHost::pluginFile();
    putFile(folder.file("plugins.cfg"),
            "PluginFolder=" + plugin.parent_path().string() + "\nPlugin=Plugin_Fbrdf\n");
    Ogre::Root root(folder.file("plugins.cfg"), "", folder.file("ogre.log"));
    ASSERT_EQ(root.getInstalledPlugins().size(), 1u);
    EXPECT_EQ(root.getInstalledPlugins().front()->getName(), "fbrdf");
}

}  // namespace
}  // namespace fbrdf::test
