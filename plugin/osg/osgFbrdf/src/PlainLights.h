// PlainLights.h - osg::Lights as lights of the runtime. Their laws of distance and cone are
// OpenGL's, not the runtime's: programs apply them by a hook (laws.glsl).
#pragma once
#include <fbrdf/plan/Light.h>

#include <osg/Light>
#include <osg/Matrixd>
#include <osg/ref_ptr>
#include <osg/Vec4f>

#include <array>

namespace osgFbrdf {

/// An osg::LightSource. `toWorld` ends in the coordinates of the root, or of the eye.
struct PlainLight {
    osg::ref_ptr<const osg::Light> light;
    osg::Matrixd toWorld;
    bool inEye = false;
};

// As osgFbrdfLaws of laws.glsl has room for.
constexpr int kMostLaws = 8, kVectorsPerLaw = 3;
using Law = std::array<osg::Vec4f, kVectorsPerLaw>;

/// What stands for an osg::Light in eye space: a white Lambertian (1 / pi) reflects its diffuse
/// colour where nothing attenuates it, as in fixed function.
struct StandIn {
    fbrdf::Light light;
    bool hasLaw = false;  ///< it falls off otherwise than by 1 / r^2, or towards the edge of a cone
    Law law;
};
StandIn standIn(const PlainLight& plain, const osg::Matrixd& toEye);

/// For a light whose law no program applies: what the law gives at `centre` (eye).
fbrdf::Light approximated(const StandIn& source, const osg::Vec3d& centre);

}  // namespace osgFbrdf
