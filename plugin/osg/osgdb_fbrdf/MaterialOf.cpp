#include "MaterialOf.h"

#include <fbrdf/base/Found.h>

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/NodeVisitor>

#include <set>

namespace osgFbrdf {
namespace {

struct Collector : public osg::NodeVisitor {
    Collector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Group& group) override
    {
        if (const auto* effect = dynamic_cast<const FactorizedBrdf*>(&group)) {
            add(*effect);
            for (const FactorizedBrdf* part : effect->effectsOfParts()) add(*part);
        }
        traverse(group);
    }
    void add(const FactorizedBrdf& effect)
    {
        if (effect.getMaterial() && effect.getMaterial()->valid())
            materials.insert(effect.getMaterial());
    }
    std::set<const MaterialObject*> materials;
};

}  // namespace

osg::ref_ptr<const MaterialObject> materialOf(const osg::Object& object, std::string& problem)
{
    const auto* material = dynamic_cast<const MaterialObject*>(&object);
    Collector found;
    if (material && material->valid()) found.materials.insert(material);
    // Visitors change nothing here, but OSG has none for what is constant.
    if (const auto* node = dynamic_cast<const osg::Node*>(&object))
        const_cast<osg::Node*>(node)->accept(found);
    if (found.materials.size() == 1) return *found.materials.begin();
    problem = fbrdf::Found(std::to_string(found.materials.size()) + " materials")
                  .expected("one; a whole scene is written to SCENE.osgt.fbrdf");
    return nullptr;
}

}  // namespace osgFbrdf
