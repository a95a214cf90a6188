// Sphere.h - the model on which a material is shown.
#pragma once
#include <osg/Geometry>

namespace osgFbrdf {

/// Unit sphere at the origin, normals outward, tangents (kTangentAttribute) along increasing
/// azimuth about +z: OSG's viewers look along +y, so that no pole is in the middle.
osg::ref_ptr<osg::Geometry> unitSphere();

}  // namespace osgFbrdf
