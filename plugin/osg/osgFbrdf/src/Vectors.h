// Vectors.h - vectors of OpenSceneGraph as those of the runtime, and the other way round.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <glm/mat4x4.hpp>
#include <osg/Matrixd>
#include <osg/Vec3d>

namespace osgFbrdf {

inline fbrdf::Vec3f toVec3(const osg::Vec3d& v)
{
    return fbrdf::Vec3f(fbrdf::Vec3d(v.x(), v.y(), v.z()));
}

inline osg::Vec3d toOsg(const fbrdf::Vec3f& v)
{
    const fbrdf::Vec3d d(v);
    return {d.x, d.y, d.z};
}

/// Both store what multiplies a row vector from the right by rows.
inline glm::dmat4 toGlm(const osg::Matrixd& matrix)
{
    glm::dmat4 result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result[i][j] = matrix(i, j);
    return result;
}

}  // namespace osgFbrdf
