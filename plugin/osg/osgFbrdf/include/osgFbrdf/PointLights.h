// PointLights.h - any number of point, directional and spot lights in a scene graph. Every
// FactorizedBrdf in the same scene is lit by all of them; nothing else is: osg::Light ends at
// eight.
#pragma once
#include <fbrdf/plan/Light.h>

#include <osg/Group>
#include <osg/Vec3f>

#include <vector>

namespace osgFbrdf {

/// Lights in the coordinates of the node: transforms above move positions and turn directions,
/// intensity and radius stay (world units). Change them in the update traversal. A light that is
/// not valid (fbrdf/plan/Light.h) lights nothing and is reported as dropped.
class PointLights : public osg::Group {
public:
    PointLights() = default;
    PointLights(const PointLights& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgFbrdf, PointLights)

    /// intensity: W/sr, falls off as 1 / r^2; radius: of influence, 0: unlimited.
    void addPoint(const osg::Vec3f& position, const osg::Vec3f& intensity, float radius = 0.0f);
    /// toLight: need not be unit; irradiance on a surface that faces the light.
    void addDirectional(const osg::Vec3f& toLight, const osg::Vec3f& irradiance);
    /// A point light inside a cone around `axis` (need not be unit): full up to innerAngle, nothing
    /// beyond outerAngle; radians.
    void addSpot(const osg::Vec3f& position, const osg::Vec3f& intensity, const osg::Vec3f& axis,
                 float innerAngle, float outerAngle, float radius = 0.0f);

    void setLights(const std::vector<fbrdf::Light>& lights) { lights_ = lights; }
    const std::vector<fbrdf::Light>& getLights() const { return lights_; }

    /// Makes transforms above DYNAMIC where osgUtil::Optimizer would flatten them.
    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~PointLights() override = default;

private:
    std::vector<fbrdf::Light> lights_;
};

}  // namespace osgFbrdf
