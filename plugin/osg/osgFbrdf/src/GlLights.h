// GlLights.h - lights of the runtime as osg::Lights, for the fallback and for plain forms.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Light.h>

#include <osg/Light>
#include <osg/ref_ptr>

namespace osgFbrdf {

// Every OpenGL with fixed function has eight; an osg::Light with a higher number raises GL errors.
constexpr int kMostGlLights = 8;

float luminance(const fbrdf::Vec3f& rgb);  ///< ITU-R BT.709

/// The light with which a white diffuse surface reflects what it would under `source`; the window
/// of a radius and the soft edge of a spot are lost. number: 0 .. kMostGlLights - 1.
osg::ref_ptr<osg::Light> glLight(const fbrdf::Light& source, int number);

/// A light at the centre of a valid area light that is as bright from far away, where the area
/// light shows most of itself; a flat one that shines from one side is a spot.
fbrdf::Light pointLightOf(const fbrdf::AreaLight& light);

}  // namespace osgFbrdf
