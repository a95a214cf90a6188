#include "BrdfStateFactory.h"

#include "LogLine.h"

#include <OgreMaterialSerializer.h>
#include <OgreScriptCompiler.h>
#include <OgreShaderScriptTranslator.h>

namespace ogreFbrdf {

const char kScriptWord[] = "fbrdf";

bool setOptions(Ogre::RTShader::SubRenderState& state, const Ogre::StringVector& words)
{
    bool areTaken = true;
    for (size_t i = 0; i < words.size(); i += 2)
        areTaken &= state.setParameter(words[i], i + 1 < words.size() ? words[i + 1] : "");
    return areTaken;
}

#ifdef FBRDF_OGRE_SCRIPT_PROPERTY

Ogre::RTShader::SubRenderState* BrdfStateFactory::createInstance(
    const ScriptProperty& property, Ogre::Pass*, Ogre::RTShader::SGScriptTranslator* translator)
{
    if (property.name != kScriptWord) return nullptr;
    Ogre::StringVector words{"material"};
    words.insert(words.end(), property.values.begin(), property.values.end());
    auto* state = createOrRetrieveInstance(translator);
    if (!setOptions(*state, words)) translator->emitError();
    return state;
}

#else

Ogre::RTShader::SubRenderState* BrdfStateFactory::createInstance(
    Ogre::ScriptCompiler* compiler, Ogre::PropertyAbstractNode* property, Ogre::Pass*,
    Ogre::RTShader::SGScriptTranslator* translator)
{
    if (property->name != kScriptWord) return nullptr;
    Ogre::StringVector words{"material"};
    for (const Ogre::AbstractNodePtr& node : property->values) {
        words.emplace_back();
        Ogre::RTShader::SGScriptTranslator::getString(node, &words.back());
    }
    auto* state = createOrRetrieveInstance(translator);
    if (!setOptions(*state, words))
        compiler->addError(Ogre::ScriptCompiler::CE_INVALIDPARAMETERS, property->file,
                           static_cast<int>(property->line));
    return state;
}

#endif

void BrdfStateFactory::writeInstance(Ogre::MaterialSerializer* serializer,
                                     Ogre::RTShader::SubRenderState* state, Ogre::Pass*,
                                     Ogre::Pass*)
{
    serializer->writeAttribute(4, kScriptWord);
    for (const auto& [name, value] : optionsOf(static_cast<BrdfState*>(state)->options())) {
        if (name != "material") serializer->writeValue(name);
        serializer->writeValue(serializer->quoteWord(value));
    }
}

Ogre::RTShader::SubRenderState* BrdfStateFactory::createInstanceImpl()
{
    return new BrdfState(services_);
}

}  // namespace ogreFbrdf
