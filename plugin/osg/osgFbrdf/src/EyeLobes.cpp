#include "EyeEnvironment.h"

#include "MaterialStates.h"

namespace osgFbrdf {
namespace {

/// Rows are the axes of the panorama where the matrix takes them, at right angles: its up stays.
osg::Matrixd turnOf(const osg::Matrixd& matrix)
{
    const auto row = [&](int i) { return osg::Vec3d(matrix(i, 0), matrix(i, 1), matrix(i, 2)); };
    osg::Vec3d up = row(1), back = row(2), right = row(0);
    up.normalize();
    back -= up * (back * up);
    back.normalize();
    right -= up * (right * up) + back * (right * back);
    right.normalize();
    return {right.x(), right.y(), right.z(), 0.0, up.x(), up.y(), up.z(), 0.0,
            back.x(),  back.y(),  back.z(),  0.0, 0.0,    0.0,    0.0,    1.0};
}

}  // namespace

EyeEnvironment environmentOf(const SceneEnvironment& scene, const osg::Matrixd& toEye,
                             MaterialStates& material, unsigned int contextId)
{
    EyeEnvironment environment;
    if (!scene.cube) return environment;
    environment.whyNot = scene.cube->whyNotReady(contextId);
    if (!environment.whyNot.empty()) return environment;
    environment.lobes = material.lobes(scene.lobes, environment.whyNot);
    if (!environment.lobes) return environment;
    environment.cube = scene.cube;
    const osg::Matrixd turn = turnOf(scene.toWorld * toEye);
    // OpenGL has columns one after the other: what a direction along each axis of the eye is in the
    // panorama. The matrix is rigid, so that its inverse is its transpose.
    for (int column = 0; column < 3; ++column)
        for (int i = 0; i < 3; ++i)
            environment.fromEye[3 * column + i] = static_cast<float>(turn(i, column));
    environment.scale = osg::Vec4f(scene.intensity, scene.cube->levelOffset());
    return environment;
}

}  // namespace osgFbrdf
