// AreaLights.h - any number of lights with a shape in a scene graph: spheres, discs, rectangles,
// tubes and polygons. All of them light every FactorizedBrdf in the same scene, and nothing else.
//
// Materials reflect them by their lobes (fbrdf/brdf/LobeTable.h). Lobes of a material file that has
// none are fitted by a thread when the material first meets such a light; until then effects are
// drawn without.
#pragma once
#include <fbrdf/plan/AreaLight.h>

#include <osg/Group>

#include <vector>

namespace osgFbrdf {

/// Lights in the coordinates of the node. Transforms above move, turn and scale their shapes: those
/// that have a size grow by the cube root of the change of volumes, and a light shines from the
/// same side of a mirrored one. Radiance stays, and so does the radius of influence, in units of
/// the world. Change lights in the update traversal. A light that is not valid (whyInvalid) lights
/// nothing and is reported as dropped.
class AreaLights : public osg::Group {
public:
    AreaLights() = default;
    AreaLights(const AreaLights& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgFbrdf, AreaLights)

    void addLight(const fbrdf::AreaLight& light) { lights_.push_back(light); }
    void setLights(const std::vector<fbrdf::AreaLight>& lights) { lights_ = lights; }
    const std::vector<fbrdf::AreaLight>& getLights() const { return lights_; }

    /// Makes transforms above DYNAMIC where osgUtil::Optimizer would flatten them.
    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~AreaLights() override = default;

private:
    std::vector<fbrdf::AreaLight> lights_;
};

}  // namespace osgFbrdf
