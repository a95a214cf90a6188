// BrdfStateFactory.h - makes BrdfStates for OGRE's shader generator, from C++ and from
//     rtshader_system { fbrdf gold.fbrdf exposure 2 }
// in a material script, and writes that again.
#pragma once
#include "BrdfState.h"

namespace ogreFbrdf {

#ifdef FBRDF_OGRE_SCRIPT_PROPERTY
namespace names {
using namespace Ogre;
using namespace Ogre::RTShader;
}  // namespace names
using names::ScriptProperty;  // of either namespace
#endif

class BrdfStateFactory : public Ogre::RTShader::SubRenderStateFactory {
public:
    explicit BrdfStateFactory(Services& services) : services_(services) {}
    const Ogre::String& getType() const override { return BrdfState::typeName(); }
    using Ogre::RTShader::SubRenderStateFactory::createInstance;
#ifdef FBRDF_OGRE_SCRIPT_PROPERTY
    Ogre::RTShader::SubRenderState* createInstance(
        const ScriptProperty& property, Ogre::Pass* pass,
        Ogre::RTShader::SGScriptTranslator* translator) override;
#else
    Ogre::RTShader::SubRenderState* createInstance(
        Ogre::ScriptCompiler* compiler, Ogre::PropertyAbstractNode* property, Ogre::Pass* pass,
        Ogre::RTShader::SGScriptTranslator* translator) override;
#endif
    using Ogre::RTShader::SubRenderStateFactory::writeInstance;
    void writeInstance(Ogre::MaterialSerializer* serializer, Ogre::RTShader::SubRenderState* state,
                       Ogre::Pass* sourcePass, Ogre::Pass* pass) override;

private:
    Ogre::RTShader::SubRenderState* createInstanceImpl() override;

    Services& services_;
};

/// The keyword in scripts.
extern const char kScriptWord[];

/// Sets options from NAME VALUE NAME VALUE; false, with an error of the compiler, where one is
/// refused.
bool setOptions(Ogre::RTShader::SubRenderState& state, const Ogre::StringVector& words);

}  // namespace ogreFbrdf
