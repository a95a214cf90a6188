// FbrdfPlugin.h - the plugin as OGRE's Root sees it.
#pragma once
#include "BrdfStateFactory.h"
#include "FbrdfResourceManager.h"
#include "GlslArchive.h"
#include "LightTable.h"
#include "ScriptBlock.h"

#include <OgrePlugin.h>

#include <memory>

namespace ogreFbrdf {

class FbrdfPlugin : public Ogre::Plugin {
public:
    const Ogre::String& getName() const override;
    void install() override;
    /// OGRE calls it when the first window is there. Starts the shader generator, if the program
    /// has not done that.
    void initialise() override;
    void shutdown() override;
    void uninstall() override;

private:
    /// What needs a render system.
    struct Parts {
        Parts();
        FbrdfResourceManager materials;
        LightTable lights;
        GlslArchiveFactory& texts;
        Services services;
        BrdfStateFactory states;
        ScriptBlock block;
    };
    std::unique_ptr<Parts> parts_;
    bool ownsGenerator_ = false;
};

}  // namespace ogreFbrdf
