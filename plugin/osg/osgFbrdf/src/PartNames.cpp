#include "PartNames.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/Material>
#include <osg/NodeVisitor>

#include <algorithm>
#include <set>

namespace osgFbrdf {
namespace {

/// Notes the parts that there are.
struct PartFinder : public osg::NodeVisitor {
    explicit PartFinder(const PartNames& table)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), names(table)
    {
        setNodeMaskOverride(~0u);
    }
    void apply(osg::Node& node) override
    {
        found.insert(names.inside(node, {}).part);
        traverse(node);
    }
    const PartNames& names;
    std::set<int> found;
};

}  // namespace

bool drawsRest(const FactorizedBrdf& effect)
{
    return effect.getParts().empty() || effect.getMaterial() || !effect.getMaterialFile().empty();
}

PartNames::PartNames(const std::vector<ModelPart>& parts)
{
    for (const ModelPart& part : parts)
        indices_.emplace(part.name, static_cast<int>(indices_.size()));
}

int PartNames::find(const std::string& name) const
{
    if (name.empty()) return kRest;
    const auto found = indices_.find(name);
    return found == indices_.end() ? kRest : found->second;
}

PartPlace PartNames::inside(const osg::Node& node, const PartPlace& above) const
{
    PartPlace place = above;
    if (const osg::StateSet* state = node.getStateSet()) {
        const int beside = above.byOsgMaterial ? above.beside : above.part;
        if (const auto* material = state->getAttribute(osg::StateAttribute::MATERIAL)) {
            if (const int part = find(material->getName()); part != kRest)
                return {part, true, beside};
            place = {beside};
        }
        if (const int part = find(state->getName()); part != kRest) return {part};
    }
    const int part = find(node.getName());
    return part == kRest ? place : PartPlace{part};
}

std::vector<std::string> PartNames::namesWithoutPart(osg::Group& model) const
{
    PartFinder finder(*this);
    for (unsigned int i = 0; i < model.getNumChildren(); ++i) model.getChild(i)->accept(finder);
    std::vector<std::string> names;
    for (const auto& [name, index] : indices_)
        if (finder.found.count(index) == 0) names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace osgFbrdf
