// KeyLights.h - the few lights that matter most: those that cast shadows, and those of a scene that
// has an environment already.
#pragma once
#include <fbrdf/plan/Light.h>
#include <fbrdf/scene/Meshes.h>

#include <vector>

namespace fbrdf::scene {

constexpr int kMostShadowed = 4;

/// Shadows are as soft as those of a disc that a light's target sees under this radius: that of a
/// studio lamp, and eleven times the sun's.
constexpr double kShadowSoftness = 3.0 * kDegree;

/// A light that casts shadows.
struct ShadowedLight {
    int place = 0;  ///< in the list of all lights
    Light from;     ///< where its shadow is cast from
};

/// Of the lights that are outside of the ball of objects, the up to kMostShadowed ones that send
/// most to its centre, strongest first. Each sample of a pixel casts shadows from another point of
/// the lights' discs, sample 0 from its middle, so the mean of many is soft.
std::vector<ShadowedLight> shadowedLights(const std::vector<Light>& lights, const Bounds& objects,
                                          int sample);

/// A key light from the front and a rim light from behind, for objects of any size under an
/// environment whose irradiance on a surface that faces up is pi.
std::vector<Light> keyLights();

}  // namespace fbrdf::scene
