#include "GlLights.h"

#include "Vectors.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/Conventions.h>
#include <fbrdf/plan/Triangulate.h>

#include <osg/Math>

#include <algorithm>

namespace osgFbrdf {

namespace {

/// The most that a valid light shows of itself from far away, in m^2.
double shownArea(const fbrdf::AreaLight& light)
{
    using Shape = fbrdf::AreaLight::Shape;
    const auto size = static_cast<double>(light.size);
    const double circle = fbrdf::kPi * size * size;
    switch (light.shape) {
        case Shape::sphere:
        case Shape::disc: return circle;
        case Shape::rectangle: return 4.0 * (toOsg(light.axisU) ^ toOsg(light.axisV)).length();
        case Shape::tube:
            return circle + 2.0 * size * (toOsg(light.end) - toOsg(light.position)).length();
        case Shape::polygon:
            return glm::length(fbrdf::vectorArea({light.vertices.begin(), light.vertices.end()}));
    }
    return 0.0;
}

}  // namespace

float luminance(const fbrdf::Vec3f& rgb)
{
    return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z;  // ITU-R BT.709
}

osg::ref_ptr<osg::Light> glLight(const fbrdf::Light& source, int number)
{
    FBRDF_ASSERT(number, >=, 0);
    FBRDF_ASSERT(number, <, kMostGlLights);
    osg::ref_ptr<osg::Light> light = new osg::Light(static_cast<unsigned int>(number));
    const bool point = source.type != fbrdf::Light::Type::directional;
    const fbrdf::Vec3f colour = source.intensity / static_cast<float>(fbrdf::kPi);
    light->setPosition(
        {source.position.x, source.position.y, source.position.z, point ? 1.0f : 0.0f});
    light->setAmbient({0.0f, 0.0f, 0.0f, 1.0f});
    light->setDiffuse({colour.x, colour.y, colour.z, 1.0f});
    light->setSpecular({0.0f, 0.0f, 0.0f, 1.0f});
    light->setConstantAttenuation(point ? 0.0f : 1.0f);
    light->setQuadraticAttenuation(point ? 1.0f : 0.0f);
    if (source.type == fbrdf::Light::Type::spot) {
        light->setDirection({source.axis.x, source.axis.y, source.axis.z});
        light->setSpotCutoff(std::min(osg::RadiansToDegrees(source.outerAngle), 90.0f));
    }
    return light;
}

fbrdf::Light pointLightOf(const fbrdf::AreaLight& light)
{
    using Shape = fbrdf::AreaLight::Shape;
    const bool isRound = light.shape == Shape::sphere || light.shape == Shape::tube;
    fbrdf::Light point;
    point.position = fbrdf::Vec3f(fbrdf::centreOf(light));
    point.intensity = light.radiance * static_cast<float>(shownArea(light));
    point.radius = light.radius;
    if (isRound || light.twoSided) return point;
    point.type = fbrdf::Light::Type::spot;
    point.axis = fbrdf::Vec3f(fbrdf::normalOf(light));
    point.innerAngle = 0.0f;
    point.outerAngle = static_cast<float>(0.5 * fbrdf::kPi);
    return point;
}

}  // namespace osgFbrdf
