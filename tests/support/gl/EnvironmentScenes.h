// EnvironmentScenes.h - panoramas and tables of lobes, for tests of environment light. GL-free.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/environment/Panorama.h>
#include <fbrdf/plan/AreaLight.h>

namespace fbrdf::test {

/// A smooth table of lobes: tilted, or bent along the tangent or across it. 8 x 1 or 8 x 4 knots.
LobeTable testLobes(LobeAxes axes, int lobes, bool acrossTangent = false);
/// A material with these lobes.
Material withLobes(Material material, const LobeTable& lobes);

/// Colours that differ in every direction, and a lamp of one texel, unless that is 0.
Panorama testPanorama(int width, float lamp = 200.0f);
/// 1 everywhere.
Panorama whitePanorama();
/// The panorama as it is after environmentRotation(pi / 2). The width is a multiple of 4.
Panorama turnedPanorama(const Panorama& panorama);

constexpr AreaLight::Shape kShapes[] = {AreaLight::Shape::sphere, AreaLight::Shape::disc,
                                        AreaLight::Shape::rectangle, AreaLight::Shape::tube,
                                        AreaLight::Shape::polygon};
/// A light of this shape that shines on the sphere of the scenes.
AreaLight areaLightOf(AreaLight::Shape shape);
/// One of each shape; the disc has a radius of influence.
std::vector<AreaLight> oneOfEach();

}  // namespace fbrdf::test
