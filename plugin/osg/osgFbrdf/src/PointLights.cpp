#include <osgFbrdf/PointLights.h>

#include "KeptTransforms.h"

namespace osgFbrdf {
namespace {

fbrdf::Vec3f toVec3(const osg::Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

}  // namespace

PointLights::PointLights(const PointLights& other, const osg::CopyOp& op)
    : osg::Group(other, op), lights_(other.lights_)
{
}

void PointLights::traverse(osg::NodeVisitor& visitor)
{
    keepTransformsAbove(visitor);
    osg::Group::traverse(visitor);
}

void PointLights::addPoint(const osg::Vec3f& position, const osg::Vec3f& intensity, float radius)
{
    lights_.push_back({fbrdf::Light::Type::point, toVec3(position), toVec3(intensity), radius});
}

void PointLights::addDirectional(const osg::Vec3f& toLight, const osg::Vec3f& irradiance)
{
    lights_.push_back({fbrdf::Light::Type::directional, toVec3(toLight), toVec3(irradiance), 0.0f});
}

void PointLights::addSpot(const osg::Vec3f& position, const osg::Vec3f& intensity,
                          const osg::Vec3f& axis, float innerAngle, float outerAngle, float radius)
{
    lights_.push_back({fbrdf::Light::Type::spot, toVec3(position), toVec3(intensity), radius,
                       toVec3(axis), innerAngle, outerAngle});
}

}  // namespace osgFbrdf
