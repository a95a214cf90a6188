// KeptTransforms.h - keeps osgUtil::Optimizer from removing transforms that matter. It flattens
// static transforms into the vertices and normals below, but neither into lights nor into tangents
// in a vertex attribute. Transforms above those become DYNAMIC, which keeps them, when a visitor of
// the optimizer comes by.
#pragma once
#include <osg/NodeVisitor>

namespace osg {
class Group;
}

namespace osgFbrdf {

/// Keeps the transforms on the path of a visitor that optimizes, and returns true; does nothing for
/// other visitors.
bool keepTransformsAbove(osg::NodeVisitor& visitor);

/// Keeps the transforms above geometries of the group that have tangents (kTangentAttribute), those
/// on the path of the visitor included.
void keepTransformsAboveTangents(osg::NodeVisitor& visitor, osg::Group& group);

}  // namespace osgFbrdf
