// EyeLobes.h - what lights the lobes of one object, in eye coordinates: the environment of the
// scene, and the area lights that reach the object.
#pragma once
#include "LobesOfMaterial.h"
#include "SceneLights.h"

#include <fbrdf/plan/LightSelection.h>
#include <fbrdf/plan/Lobes.h>

#include <osg/Uniform>
#include <osg/Vec4f>

#include <vector>

namespace osgFbrdf {

class FactorizedBrdf;

struct EyeLobes {
    LobesOfMaterial::Table lobes;        ///< of the material; null where nothing lights them
    osg::ref_ptr<EnvironmentCube> cube;  ///< null: no environment lights the object
    /// The uniforms fbrdfToEnvironment and fbrdfEnvironmentScale.
    osg::Matrix3 fromEye;
    osg::Vec4f scale;
    std::vector<fbrdf::AreaVectors> areas;  ///< of the area lights, exposed
    int areaLights = 0;                     ///< how many they are: a polygon has several vectors
    int culled = 0;                         ///< area lights that cannot reach the object
    /// Why the environment, or area lights that reach the object, do not light it; empty where they
    /// do or there are none.
    std::string whyNot;

    fbrdf::LobeLight light() const { return {cube.valid(), static_cast<int>(areas.size())}; }
    /// True where the object would be lit by lobes and is not.
    bool isMissing() const { return light().isEmpty() && !whyNot.empty(); }
    /// Leaves the environment out, or the area lights where it is out already.
    void leaveOut(const std::string& why);
};

/// toEye: from world coordinates. bounds: of the effect, which has a material, in eye coordinates.
/// contextId: of the visitor that culls.
EyeLobes lobesOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                 const FactorizedBrdf& effect, unsigned int contextId);

}  // namespace osgFbrdf
