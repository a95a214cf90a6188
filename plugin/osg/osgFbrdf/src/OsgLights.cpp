#include "OsgLights.h"

#include "Vectors.h"

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

/// OpenGL's cone has a sharp edge. A cut-off of 180 degrees means no cone; others are at most 90.
void setCone(fbrdf::Light& light, const osg::Light& source, const osg::Vec3d& axis)
{
    if (source.getSpotCutoff() > 90.0f || axis.length2() == 0.0) return;
    light.type = fbrdf::Light::Type::spot;
    light.axis = toVec3(axis);
    light.innerAngle = light.outerAngle = osg::DegreesToRadians(source.getSpotCutoff());
}

void setAttenuation(ConvertedLight& result, const osg::Light& source, const osg::Vec3d& place,
                    const osg::Vec3d& axis)
{
    const float constant = source.getConstantAttenuation(), linear = source.getLinearAttenuation(),
                quadratic = source.getQuadraticAttenuation();
    const bool aimed = result.light.type == fbrdf::Light::Type::spot;
    const float exponent = aimed ? std::max(source.getSpotExponent(), 0.0f) : 0.0f;
    result.isAttenuated =
        constant != 0.0f || linear != 0.0f || quadratic <= 0.0f || exponent > 0.0f;
    if (!result.isAttenuated) result.light.intensity /= quadratic;
    result.attenuation = {osg::Vec4f(osg::Vec3f(place), exponent),
                          osg::Vec4f(constant, linear, quadratic, 0.0f),
                          osg::Vec4f(osg::Vec3f(axis), 0.0f)};
}

osg::Vec3d vectorOf(const osg::Vec4f& v)
{
    return osg::Vec3d(osg::Vec3f(v.x(), v.y(), v.z()));
}

}  // namespace

ConvertedLight converted(const PlacedOsgLight& placed, const osg::Matrixd& toEye)
{
    const osg::Light& source = *placed.light;
    const osg::Matrixd matrix = placed.inEye ? placed.toWorld : placed.toWorld * toEye;
    const osg::Vec4d position = osg::Vec4d(source.getPosition()) * matrix;
    const osg::Vec4f& diffuse = source.getDiffuse();
    ConvertedLight result;
    fbrdf::Light& light = result.light;
    light.intensity =
        static_cast<float>(fbrdf::kPi) * fbrdf::Vec3f(diffuse.r(), diffuse.g(), diffuse.b());
    osg::Vec3d place(position.x(), position.y(), position.z());
    if (position.w() == 0.0) {
        light.type = fbrdf::Light::Type::directional;
        place.normalize();
    } else {
        place /= position.w();
        osg::Vec3d axis = osg::Matrixd::transform3x3(osg::Vec3d(source.getDirection()), matrix);
        axis.normalize();
        setCone(light, source, axis);
        setAttenuation(result, source, place, axis);
    }
    light.position = toVec3(place);
    return result;
}

fbrdf::Light approximatedAt(const osg::Vec3d& centre, const ConvertedLight& source)
{
    fbrdf::Light light = source.light;
    if (!source.isAttenuated) return light;
    const auto& [place, coefficients, axis] = source.attenuation;
    const osg::Vec3d toLight = vectorOf(place) - centre;
    const double d = toLight.length(), exponent = static_cast<double>(place.w());
    const double divisor = static_cast<double>(coefficients.x()) +
                           static_cast<double>(coefficients.y()) * d +
                           static_cast<double>(coefficients.z()) * d * d;
    double factor = divisor > 0.0 ? d * d / divisor : 1.0;
    if (exponent > 0.0 && d > 0.0)
        factor *= std::pow(std::max(0.0, -(vectorOf(axis) * toLight) / d), exponent);
    light.intensity *= static_cast<float>(factor);
    return light;
}

}  // namespace osgFbrdf
