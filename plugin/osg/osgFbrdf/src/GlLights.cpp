#include "GlLights.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/Conventions.h>

#include <osg/Math>

#include <algorithm>

namespace osgFbrdf {

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

}  // namespace osgFbrdf
