#include "PlainLights.h"

#include "Vectors.h"

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

/// OpenGL's cone has a sharp edge: 180 degrees are no cone, others are at most 90.
void setCone(fbrdf::Light& light, const osg::Light& source, const osg::Vec3d& axis)
{
    if (source.getSpotCutoff() > 90.0f || axis.length2() == 0.0) return;
    light.type = fbrdf::Light::Type::spot;
    light.axis = toVec3(axis);
    light.innerAngle = light.outerAngle = osg::DegreesToRadians(source.getSpotCutoff());
}

void setLaw(StandIn& result, const osg::Light& source, const osg::Vec3d& place,
            const osg::Vec3d& axis)
{
    const float constant = source.getConstantAttenuation(), linear = source.getLinearAttenuation(),
                quadratic = source.getQuadraticAttenuation();
    const bool aimed = result.light.type == fbrdf::Light::Type::spot;
    const float exponent = aimed ? std::max(source.getSpotExponent(), 0.0f) : 0.0f;
    result.hasLaw = constant != 0.0f || linear != 0.0f || quadratic <= 0.0f || exponent > 0.0f;
    if (!result.hasLaw) result.light.intensity /= quadratic;
    result.law = {osg::Vec4f(osg::Vec3f(place), exponent),
                  osg::Vec4f(constant, linear, quadratic, 0.0f),
                  osg::Vec4f(osg::Vec3f(axis), 0.0f)};
}

}  // namespace

StandIn standIn(const PlainLight& plain, const osg::Matrixd& toEye)
{
    const osg::Light& source = *plain.light;
    const osg::Matrixd matrix = plain.inEye ? plain.toWorld : plain.toWorld * toEye;
    const osg::Vec4d position = osg::Vec4d(source.getPosition()) * matrix;
    const osg::Vec4f& diffuse = source.getDiffuse();
    StandIn result;
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
        setLaw(result, source, place, axis);
    }
    light.position = toVec3(place);
    return result;
}

fbrdf::Light approximated(const StandIn& source, const osg::Vec3d& centre)
{
    fbrdf::Light light = source.light;
    if (!source.hasLaw) return light;
    const osg::Vec4f &place = source.law[0], &attenuation = source.law[1], &axis = source.law[2];
    const osg::Vec3d way = osg::Vec3d(osg::Vec3f(place.x(), place.y(), place.z())) - centre;
    const double d = way.length();
    const double divisor = static_cast<double>(attenuation.x()) +
                           static_cast<double>(attenuation.y()) * d +
                           static_cast<double>(attenuation.z()) * d * d;
    double factor = divisor > 0.0 ? d * d / divisor : 1.0;
    if (place.w() > 0.0f && d > 0.0)
        factor *= std::pow(
            std::max(0.0, -(osg::Vec3d(osg::Vec3f(axis.x(), axis.y(), axis.z())) * way) / d),
            static_cast<double>(place.w()));
    light.intensity *= static_cast<float>(factor);
    return light;
}

}  // namespace osgFbrdf
