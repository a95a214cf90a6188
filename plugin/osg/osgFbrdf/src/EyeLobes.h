// EyeEnvironment.h - the environment of one object in eye coordinates, and the lobes by which its
// material reflects it.
#pragma once
#include "LobesOfMaterial.h"
#include "SceneLights.h"

#include <osg/Uniform>
#include <osg/Vec4f>

namespace osgFbrdf {

class MaterialStates;

struct EyeEnvironment {
    osg::ref_ptr<EnvironmentCube> cube;  ///< null: no environment lights the object
    LobesOfMaterial::Table lobes;        ///< null where cube is
    /// The uniforms fbrdfToEnvironment and, but for the exposure, fbrdfEnvironmentScale.
    osg::Matrix3 fromEye;
    osg::Vec4f scale;
    std::string whyNot;  ///< why that of the scene does not; empty where it does or there is none
};

/// toEye: from world coordinates. contextId: of the visitor that culls.
EyeEnvironment environmentOf(const SceneEnvironment& scene, const osg::Matrixd& toEye,
                             MaterialStates& material, unsigned int contextId);

}  // namespace osgFbrdf
