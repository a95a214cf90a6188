// The parts of a model that have effects of their own, in FactorizedBrdf.
#include "EffectCull.h"
#include "EffectInternals.h"
#include "NestedBin.h"
#include "PartVisitor.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Found.h>

#include <osg/Notify>

#include <algorithm>
#include <map>
#include <optional>

namespace osgFbrdf {

std::vector<FactorizedBrdf*> FactorizedBrdf::effectsOfParts() const
{
    std::vector<FactorizedBrdf*> effects;
    for (const ModelPart& part : parts_)
        if (std::find(effects.begin(), effects.end(), part.effect) == effects.end())
            effects.push_back(part.effect.get());
    return effects;
}

void FactorizedBrdf::setPart(const std::string& name, FactorizedBrdf* effect)
{
    internals_->partsAreKnown = false;
    const osg::ref_ptr<FactorizedBrdf> kept(effect);
    parts_.erase(std::remove_if(parts_.begin(), parts_.end(),
                                [&](const ModelPart& part) { return part.name == name; }),
                 parts_.end());
    if (!effect) return;
    parts_.push_back({name, kept});
    // One line for each part: the one of who has read its file.
    if (!effect->getMaterial() && !effect->getMaterialFile().empty())
        effect->internals_->log.knows(kNoMaterial);
}

void FactorizedBrdf::setPartMaterial(const std::string& name, MaterialObject* material)
{
    const osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    effect->setName(name);
    effect->takeProperties(*this);
    effect->setMaterial(material);
    setPart(name, effect);
    if (material) shareEffectOf(parts_.back());
}

bool FactorizedBrdf::setPartMaterialFile(const std::string& name, const std::string& file,
                                         const osgDB::Options* options)
{
    const osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    effect->setName(name);
    effect->takeProperties(*this);
    const bool isRead = effect->setMaterialFile(file, options);
    setPart(name, effect);
    if (isRead) shareEffectOf(parts_.back());
    return isRead;
}

/// Gives the part the effect of another part with the same material, where there is one.
void FactorizedBrdf::shareEffectOf(ModelPart& part)
{
    for (const ModelPart& other : parts_)
        if (other.effect != part.effect &&
            other.effect->getMaterial() == part.effect->getMaterial()) {
            other.effect->setName(other.effect->getName() + ", " + part.name);
            part.effect = other.effect;
            return;
        }
}

void FactorizedBrdf::warnOfNamesWithoutPart()
{
    const PartNames names(parts_);
    for (const std::string& name : names.namesWithoutPart(*this))
        OSG_WARN << "osgFbrdf: '" << name << "': "
                 << fbrdf::Found("no part of that name in the model")
                        .expected("a node, a state set or an osg::Material")
                 << std::endl;
}

void FactorizedBrdf::cullParts(osgUtil::CullVisitor& visitor)
{
    if (getBound().valid() && !internals_->partsAreKnown.exchange(true)) warnOfNamesWithoutPart();
    // Each effect in a bin of its own: what is under one state is drawn together, and effects that
    // add up in surfaces are drawn one after the other.
    std::map<const FactorizedBrdf*, PartPasses> passes;
    const auto passesOf = [&](FactorizedBrdf& effect) -> const PartPasses* {
        const auto [entry, isNew] = passes.try_emplace(&effect);
        if (!isNew) return &entry->second;
        PartPasses& found = entry->second;
        const NestedBin bin(visitor, static_cast<int>(passes.size()));
        const std::function<void()> blended = [&] {
            found.blended = visitor.getCurrentStateGraph();
        };
        effect.cullAs(
            visitor, *this,
            [&] {
                found.passes.push_back(
                    {visitor.getCurrentStateGraph(), visitor.getCurrentRenderBin()});
            },
            effect.getModelTextures().hasAlpha() ? blended : nullptr);
        return &found;
    };
    std::optional<NestedBin> bin(std::in_place, visitor, kEffectBin);
    std::vector<const PartPasses*> ofParts;
    for (const ModelPart& part : parts_) ofParts.push_back(passesOf(*part.effect));
    const PartPasses* ofRest = drawsRest(*this) ? passesOf(*this) : nullptr;
    bin.reset();
    if (!ofRest) internals_->log.report(*this, {"the model's own state", "", 1});
    const PartNames names(parts_);
    const osg::ref_ptr<PartVisitor> parts = new PartVisitor(visitor, names, ofParts, ofRest);
    parts->cull(*this);
}

}  // namespace osgFbrdf
