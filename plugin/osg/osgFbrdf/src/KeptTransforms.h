// KeptTransforms.h - osgUtil::Optimizer flattens static transforms into the vertices and normals
// below: not into lights, nor into tangents in a vertex attribute. Transforms above those become
// DYNAMIC, which keeps them, when a visitor of the optimizer comes by.
#pragma once
#include <osg/NodeVisitor>

namespace osg {
class Group;
}

namespace osgFbrdf {

/// Keeps the transforms on the path of a visitor that optimizes; others pass.
void keepTransformsAbove(osg::NodeVisitor& visitor);

/// Keeps those above geometries with tangents (kTangentAttribute), the path of the visitor
/// included.
void keepTransformsAboveTangents(osg::NodeVisitor& visitor, osg::Group& group);

}  // namespace osgFbrdf
