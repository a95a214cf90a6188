// Sphere.h - what a material is shown on.
#pragma once
#include <osg/Geometry>

namespace osgFbrdf {

/// Unit sphere at the origin, normals outward, tangents (kTangentAttribute) along increasing
/// azimuth about +y.
osg::ref_ptr<osg::Geometry> unitSphere();

}  // namespace osgFbrdf
