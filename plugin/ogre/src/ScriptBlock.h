// ScriptBlock.h - the other way to write a material in a script:
//     rtshader_system {
//         fbrdf gold.fbrdf {
//             exposure 2
//             technique single
//         }
//     }
// OGRE's shader generator hands blocks in its section to whatever translator knows them.
#pragma once
#include <OgreScriptTranslator.h>

namespace ogreFbrdf {

class ScriptBlock : public Ogre::ScriptTranslator, public Ogre::ScriptTranslatorManager {
public:
    void translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) override;
    /// This, for a block `fbrdf`.
    Ogre::ScriptTranslator* getTranslator(const Ogre::AbstractNodePtr& node) override;
};

}  // namespace ogreFbrdf
