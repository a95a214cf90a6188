#include "ScriptBlock.h"

#include "BrdfStateFactory.h"

#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreScriptCompiler.h>
#include <OgreShaderGenerator.h>
#include <OgreShaderRenderState.h>
#include <OgreTechnique.h>

namespace ogreFbrdf {
namespace {

/// The block's words: material NAME, and those of its lines.
Ogre::StringVector wordsOf(const Ogre::ObjectAbstractNode& block)
{
    Ogre::StringVector words{"material", block.name};
    for (const Ogre::AbstractNodePtr& node : block.children) {
        if (node->type != Ogre::ANT_PROPERTY) continue;
        const auto& property = static_cast<const Ogre::PropertyAbstractNode&>(*node);
        words.push_back(property.name);
        for (const Ogre::AbstractNodePtr& value : property.values)
            words.push_back(value->getValue());
    }
    return words;
}

}  // namespace

void ScriptBlock::translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node)
{
    const auto& block = static_cast<const Ogre::ObjectAbstractNode&>(*node);
    const auto& section = static_cast<const Ogre::ObjectAbstractNode&>(*block.parent);
    auto* const* pass = Ogre::any_cast<Ogre::Pass*>(&section.parent->context);
    if (!pass) {
        compiler->addError(Ogre::ScriptCompiler::CE_UNEXPECTEDTOKEN, node->file,
                           static_cast<int>(node->line), "fbrdf belongs into a pass");
        return;
    }
    auto& generator = Ogre::RTShader::ShaderGenerator::getSingleton();
    const Ogre::String scheme =
        section.name.empty() ? Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME : section.name;
    const Ogre::Material& material = *(*pass)->getParent()->getParent();
    Ogre::RTShader::RenderState* state = generator.getRenderState(
        scheme, material.getName(), material.getGroup(), (*pass)->getIndex());
    if (!state) return;
    auto* stage = generator.createSubRenderState(BrdfState::typeName());
    if (!setOptions(*stage, wordsOf(block)))
        compiler->addError(Ogre::ScriptCompiler::CE_INVALIDPARAMETERS, node->file,
                           static_cast<int>(node->line));
    state->addTemplateSubRenderState(stage);
}

Ogre::ScriptTranslator* ScriptBlock::getTranslator(const Ogre::AbstractNodePtr& node)
{
    if (node->type != Ogre::ANT_OBJECT) return nullptr;
    return static_cast<const Ogre::ObjectAbstractNode&>(*node).cls == kScriptWord ? this : nullptr;
}

}  // namespace ogreFbrdf
