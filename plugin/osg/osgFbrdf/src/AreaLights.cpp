#include <osgFbrdf/AreaLights.h>

#include "KeptTransforms.h"

namespace osgFbrdf {

AreaLights::AreaLights(const AreaLights& other, const osg::CopyOp& op)
    : osg::Group(other, op), lights_(other.lights_)
{
}

void AreaLights::traverse(osg::NodeVisitor& visitor)
{
    keepTransformsAbove(visitor);
    osg::Group::traverse(visitor);
}

}  // namespace osgFbrdf
