// PointLights.h - any number of point, directional and spot lights in a scene graph, of which
// osg::Light has eight. All of them light every FactorizedBrdf in the same scene, and nothing else.
#pragma once
#include <fbrdf/plan/Light.h>

#include <osg/Group>
#include <osg/Vec3f>

#include <vector>

namespace osgFbrdf {

/// Lights in the coordinates of the node. Transforms above move positions and turn directions;
/// intensity and radius stay, in units of the world. Change lights in the update traversal. A light
/// that is not valid (fbrdf/plan/Light.h) lights nothing and is reported as dropped.
class PointLights : public osg::Group {
public:
    PointLights() = default;
    PointLights(const PointLights& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgFbrdf, PointLights)

    /// intensity: W/sr, falls off as 1 / r^2; radius: of influence, 0: unlimited.
    void addPoint(const osg::Vec3f& position, const osg::Vec3f& intensity, float radius = 0.0f);
    /// toLight: need not be unit; irradiance: on a surface that faces the light.
    void addDirectional(const osg::Vec3f& toLight, const osg::Vec3f& irradiance);
    /// A point light inside a cone.
    struct Spot {
        osg::Vec3f position;
        osg::Vec3f intensity{1.0f, 1.0f, 1.0f};  ///< on the axis; W/sr, falls off as 1 / r^2
        osg::Vec3f axis{0.0f, 0.0f, -1.0f};      ///< where it shines; need not be unit
        /// Radians from the axis: full inside the inner angle, nothing outside the outer one.
        float innerAngle = 0.0f, outerAngle = 0.785398f;  // 45 degrees, as of fbrdf::Light
        float radius = 0.0f;                              ///< of influence, 0: unlimited
    };
    void addSpot(const Spot& spot);

    void setLights(const std::vector<fbrdf::Light>& lights);
    const std::vector<fbrdf::Light>& getLights() const { return lights_; }
    /// Another number after each change of the lights, and no other node has it: what was made of
    /// the lights need not be made again while it stays.
    unsigned int getVersion() const { return version_; }

    /// Makes transforms above DYNAMIC where osgUtil::Optimizer would flatten them.
    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~PointLights() override = default;

private:
    void add(const fbrdf::Light& light);

    std::vector<fbrdf::Light> lights_;
    unsigned int version_ = 0;  ///< of none: no light
};

}  // namespace osgFbrdf
