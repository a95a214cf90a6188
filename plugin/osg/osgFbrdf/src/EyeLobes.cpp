#include "EyeLobes.h"

#include "MaterialStates.h"
#include "Vectors.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <utility>

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

void addAreas(EyeLobes& eye, const SceneLights& scene, const osg::Matrixd& toEye,
              const fbrdf::Sphere& bounds, float exposure)
{
    const osg::Vec3d centre = toOsg(bounds.centre) * osg::Matrixd::inverse(toEye);
    const fbrdf::LightSelection selection =
        fbrdf::selectLights(scene.areaLights, {toVec3(centre), bounds.radius}, 0);
    for (const int index : selection.lights) {
        fbrdf::AreaLight light = scene.areaLights[static_cast<size_t>(index)];
        light.radiance *= exposure;
        fbrdf::appendAreaVectors(light, kNotAttenuated, toGlm(toEye), eye.areas);
    }
    eye.areaLights = static_cast<int>(selection.lights.size());
    eye.culled = selection.culled;
}

void addEnvironment(EyeLobes& eye, const SceneEnvironment& scene, const osg::Matrixd& toEye,
                    float exposure)
{
    eye.cube = scene.cube;
    const osg::Matrixd turn = turnOf(scene.toWorld * toEye);
    // OpenGL has columns one after the other: what a direction along each axis of the eye is in the
    // panorama. The matrix is rigid, so that its inverse is its transpose.
    for (int column = 0; column < 3; ++column)
        for (int i = 0; i < 3; ++i)
            eye.fromEye[3 * column + i] = static_cast<float>(turn(i, column));
    eye.scale = osg::Vec4f(scene.intensity * exposure, scene.cube->levelOffset());
}

}  // namespace

void EyeLobes::leaveOut(const std::string& why)
{
    whyNot = why;
    if (!std::exchange(cube, nullptr)) {
        areaLights = 0;
        areas.clear();
    }
    if (light().isEmpty()) lobes = nullptr;
}

EyeLobes lobesOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                 const FactorizedBrdf& effect, unsigned int contextId)
{
    EyeLobes eye;
    addAreas(eye, scene, toEye, bounds, effect.getExposure());
    const SceneEnvironment& environment = scene.environment;
    if (environment.cube) eye.whyNot = environment.cube->whyNotReady(contextId);
    if (environment.cube && eye.whyNot.empty())
        addEnvironment(eye, environment, toEye, effect.getExposure());
    if (eye.light().isEmpty()) return eye;
    std::string whyNoLobes;
    eye.lobes = effect.getMaterial()->states()->lobes(environment.lobes, whyNoLobes);
    while (!eye.lobes && !eye.light().isEmpty()) eye.leaveOut(whyNoLobes);
    return eye;
}

}  // namespace osgFbrdf
