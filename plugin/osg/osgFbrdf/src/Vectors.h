// Vectors.h - vectors of OpenSceneGraph as those of the runtime.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <osg/Vec3d>

namespace osgFbrdf {

inline fbrdf::Vec3f toVec3(const osg::Vec3d& v)
{
    return fbrdf::Vec3f(fbrdf::Vec3d(v.x(), v.y(), v.z()));
}

}  // namespace osgFbrdf
