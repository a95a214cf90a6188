#include "ViewLights.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderer.h>
#include <vtkTransform.h>

#include <algorithm>

namespace fbrdf::vtk {
namespace {

Vec3d toVec3(const double* v)
{
    return {v[0], v[1], v[2]};
}

/// Where a light is and shines, in the view. Lights that follow the camera may be moved once more.
struct Placed {
    Vec3d position, direction;
};

Placed placed(vtkLight& light, vtkOpenGLRenderer& renderer)
{
    vtkTransform* const toView = renderer.GetActiveCamera()->GetModelViewTransformObject();
    const Vec3d from = toVec3(light.GetTransformedPosition()),
                along = toVec3(light.GetTransformedFocalPoint()) - from;
    Placed result{toVec3(toView->TransformPoint(from.x, from.y, from.z)),
                  toVec3(toView->TransformVector(along.x, along.y, along.z))};
    vtkTransform* const moved = renderer.GetUserLightTransform();
    if (!moved || light.LightTypeIsSceneLight()) return result;
    return {toVec3(moved->TransformPoint(&result.position.x)),
            toVec3(moved->TransformVector(&result.direction.x))};
}

/// VTK multiplies albedo, colour and cosine, a Lambertian surface albedo / pi, irradiance and
/// cosine.
Light converted(vtkLight& source, const Placed& at)
{
    Light light;
    light.intensity = Vec3f(kPi * source.GetIntensity() * Vec3d(toVec3(source.GetDiffuseColor())));
    light.type = source.GetPositional() ? Light::Type::point : Light::Type::directional;
    light.position = Vec3f(source.GetPositional() ? at.position : -at.direction);
    if (source.GetPositional() && source.GetConeAngle() < 90.0) {
        light.type = Light::Type::spot;
        light.axis = Vec3f(at.direction);
        light.innerAngle = light.outerAngle =
            static_cast<float>(std::max(source.GetConeAngle(), 0.0) * kPi / 180.0);
    }
    return light;
}

glm::vec4 attenuationOf(vtkLight& source, const Light& light)
{
    const Vec3d values = toVec3(source.GetAttenuationValues());
    const double exponent = light.type == Light::Type::spot ? source.GetExponent() : 0.0;
    return glm::vec4(glm::dvec4(values.x, values.y, values.z, exponent));
}

/// True where the runtime's own 1 / r^2 serves: the quadratic coefficient divides the intensity.
bool isInverseSquare(const glm::vec4& a)
{
    return a.x == 0.0f && a.y == 0.0f && a.z > 0.0f && a.w <= 0.0f;
}

/// Only what shines: lights of no colour or intensity cost nothing.
bool isLit(vtkLight& light)
{
    const double* const colour = light.GetDiffuseColor();
    return light.GetSwitch() && light.GetIntensity() != 0.0 &&
           (colour[0] != 0.0 || colour[1] != 0.0 || colour[2] != 0.0);
}

bool isFinite(const glm::vec4& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

void add(ViewLights& all, vtkLight& source, vtkOpenGLRenderer& renderer)
{
    Light light = converted(source, placed(source, renderer));
    const glm::vec4 attenuation = attenuationOf(source, light);
    if (!isValid(light) || !isFinite(attenuation)) {
        ++all.dropped;
        return;
    }
    const bool isDirectional = light.type == Light::Type::directional;
    const bool isPlain = isDirectional || isInverseSquare(attenuation);
    if (isPlain && !isDirectional) light.intensity /= attenuation.z;
    const LightVectors vectors = lightVectors(light, glm::dmat4(1.0));
    if (isPlain) return all.lights.push_back(vectors);
    const auto place = static_cast<std::ptrdiff_t>(all.attenuations.size());
    all.lights.insert(all.lights.begin() + place, vectors);
    all.attenuations.push_back(attenuation);
}

}  // namespace

ViewLights viewLights(vtkOpenGLRenderer& renderer)
{
    ViewLights all;
    vtkCollectionSimpleIterator at;
    vtkLightCollection* const lights = renderer.GetLights();
    lights->InitTraversal(at);
    while (vtkLight* const light = lights->GetNextLight(at))
        if (isLit(*light)) add(all, *light, renderer);
    return all;
}

unsigned long long lightsTime(vtkOpenGLRenderer& renderer)
{
    vtkLightCollection* const lights = renderer.GetLights();
    unsigned long long time = std::max(lights->GetMTime(), renderer.GetActiveCamera()->GetMTime());
    if (vtkTransform* const moved = renderer.GetUserLightTransform())
        time = std::max<unsigned long long>(time, moved->GetMTime());
    vtkCollectionSimpleIterator at;
    lights->InitTraversal(at);
    while (vtkLight* const light = lights->GetNextLight(at)) {
        time = std::max<unsigned long long>(time, light->GetMTime());
        if (vtkMatrix4x4* const matrix = light->GetTransformMatrix())
            time = std::max<unsigned long long>(time, matrix->GetMTime());
    }
    return time;
}

}  // namespace fbrdf::vtk
