#include "KeptTransforms.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/Geometry>
#include <osg/Transform>
#include <osgUtil/Optimizer>

namespace osgFbrdf {
namespace {

bool optimizes(osg::NodeVisitor& visitor)
{
    return dynamic_cast<osgUtil::BaseOptimizerVisitor*>(&visitor) != nullptr;
}

void keep(const osg::NodePath& path)
{
    for (osg::Node* node : path)
        if (node->asTransform()) node->setDataVariance(osg::Object::DYNAMIC);
}

struct TangentFinder : public osg::NodeVisitor {
    TangentFinder() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Geometry& geometry) override
    {
        if (!geometry.getVertexAttribArray(kTangentAttribute)) return;
        found = true;
        keep(getNodePath());
    }
    bool found = false;
};

}  // namespace

bool keepTransformsAbove(osg::NodeVisitor& visitor)
{
    if (!optimizes(visitor)) return false;
    keep(visitor.getNodePath());
    return true;
}

void keepTransformsAboveTangents(osg::NodeVisitor& visitor, osg::Group& group)
{
    if (!optimizes(visitor)) return;
    TangentFinder finder;
    for (unsigned int i = 0; i < group.getNumChildren(); ++i) group.getChild(i)->accept(finder);
    if (finder.found) keep(visitor.getNodePath());
}

}  // namespace osgFbrdf
