#include "FbrdfPlugin.h"

#include <OgreArchiveManager.h>
#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreScriptCompiler.h>
#include <OgreShaderGenerator.h>

namespace ogreFbrdf {
namespace {

using Ogre::RTShader::ShaderGenerator;

/// OGRE keeps archive factories to its end and has no way to take one back.
GlslArchiveFactory& archiveFactory()
{
    static GlslArchiveFactory factory;
    return factory;
}

bool hasRenderSystem()
{
    const Ogre::RenderSystem* system = Ogre::Root::getSingleton().getRenderSystem();
    return system && system->getCapabilities();
}

}  // namespace

FbrdfPlugin::Parts::Parts()
    : texts(archiveFactory()), services{texts, lights, materials}, states(services)
{
}

const Ogre::String& FbrdfPlugin::getName() const
{
    static const Ogre::String name = "fbrdf";
    return name;
}

void FbrdfPlugin::install()
{
    Ogre::ArchiveManager::getSingleton().addArchiveFactory(&archiveFactory());
}

void FbrdfPlugin::initialise()
{
    // OGRE calls again when there is a window, if there was none yet.
    if (parts_ || !hasRenderSystem()) return;
    ownsGenerator_ = !ShaderGenerator::getSingletonPtr();
    if (ownsGenerator_ && !ShaderGenerator::initialize()) return;
    parts_ = std::make_unique<Parts>();
    ShaderGenerator::getSingleton().addSubRenderStateFactory(&parts_->states);
    Ogre::ScriptCompilerManager::getSingleton().addTranslatorManager(&parts_->block);
}

void FbrdfPlugin::shutdown()
{
    if (!parts_) return;
    Ogre::ScriptCompilerManager::getSingleton().removeTranslatorManager(&parts_->block);
    // Programs destroy the generator themselves, as a rule before this.
    if (ShaderGenerator* generator = ShaderGenerator::getSingletonPtr()) {
        generator->removeAllShaderBasedTechniques();
        generator->removeSubRenderStateFactory(&parts_->states);
        if (ownsGenerator_) ShaderGenerator::destroy();
    }
    parts_->services.kept.clear();
    parts_->lights.release();
    parts_->texts.clear();
    parts_.reset();
}

void FbrdfPlugin::uninstall()
{
    shutdown();
}

}  // namespace ogreFbrdf
