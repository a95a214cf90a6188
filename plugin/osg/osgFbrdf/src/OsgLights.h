// OsgLights.h - osg::Lights as lights of the runtime. How they fall off with distance and towards
// the edge of a cone is OpenGL's definition, not the runtime's: programs apply it by a hook
// (attenuation.glsl).
#pragma once
#include <fbrdf/plan/Light.h>

#include <osg/Light>
#include <osg/Matrixd>
#include <osg/ref_ptr>
#include <osg/Vec4f>

#include <array>

namespace osgFbrdf {

/// The light of an osg::LightSource. `toWorld` ends in the coordinates of the root, or in those of
/// the eye.
struct PlacedOsgLight {
    osg::ref_ptr<const osg::Light> light;
    osg::Matrixd toWorld;
    bool inEye = false;
};

/// What attenuation.glsl reads of one light: see there. OpenGL has eight lights.
constexpr int kMostAttenuations = 8, kVectorsPerAttenuation = 3;
/// What attenuation.glsl is told of lights that have none.
constexpr int kNotAttenuated = kMostAttenuations;
using Attenuation = std::array<osg::Vec4f, kVectorsPerAttenuation>;

/// An osg::Light as the runtime has it, in eye space. A white Lambertian (1 / pi) reflects the
/// diffuse colour of the light where nothing attenuates it, as in fixed function.
struct ConvertedLight {
    fbrdf::Light light;
    /// True where the light does not fall off by 1 / r^2, or falls off towards the edge of a cone.
    bool isAttenuated = false;
    Attenuation attenuation;
};
ConvertedLight converted(const PlacedOsgLight& source, const osg::Matrixd& toEye);

/// A light whose attenuation no program applies, as bright everywhere as it should be at `centre`
/// (eye space).
fbrdf::Light approximatedAt(const osg::Vec3d& centre, const ConvertedLight& source);

}  // namespace osgFbrdf
