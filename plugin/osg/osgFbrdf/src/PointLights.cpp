#include <osgFbrdf/PointLights.h>

#include "KeptTransforms.h"

#include <atomic>

namespace osgFbrdf {
namespace {

fbrdf::Vec3f toVec3(const osg::Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

unsigned int nextVersion()
{
    static std::atomic<unsigned int> last{0};
    return ++last;
}

}  // namespace

PointLights::PointLights(const PointLights& other, const osg::CopyOp& op)
    : osg::Group(other, op), lights_(other.lights_), version_(nextVersion())
{
}

void PointLights::setLights(const std::vector<fbrdf::Light>& lights)
{
    lights_ = lights;
    version_ = nextVersion();
}

void PointLights::add(const fbrdf::Light& light)
{
    lights_.push_back(light);
    version_ = nextVersion();
}

void PointLights::traverse(osg::NodeVisitor& visitor)
{
    keepTransformsAbove(visitor);
    osg::Group::traverse(visitor);
}

void PointLights::addPoint(const osg::Vec3f& position, const osg::Vec3f& intensity, float radius)
{
    add({fbrdf::Light::Type::point, toVec3(position), toVec3(intensity), radius});
}

void PointLights::addDirectional(const osg::Vec3f& toLight, const osg::Vec3f& irradiance)
{
    add({fbrdf::Light::Type::directional, toVec3(toLight), toVec3(irradiance), 0.0f});
}

void PointLights::addSpot(const Spot& spot)
{
    fbrdf::Light light;
    light.type = fbrdf::Light::Type::spot;
    light.position = toVec3(spot.position);
    light.intensity = toVec3(spot.intensity);
    light.axis = toVec3(spot.axis);
    light.innerAngle = spot.innerAngle;
    light.outerAngle = spot.outerAngle;
    light.radius = spot.radius;
    add(light);
}

}  // namespace osgFbrdf
