// EveryShape.h - area lights for tests: one of each shape, in the order of AreaLight::Shape, in
// front of what is at the origin.
#pragma once
#include <fbrdf/plan/AreaLight.h>

#include <vector>

namespace fbrdf::test {

inline std::vector<AreaLight> lightsOfEveryShape()
{
    std::vector<AreaLight> lights(5);
    lights[0].position = {1.0f, 1.5f, 2.0f};
    lights[1].shape = AreaLight::Shape::disc;
    lights[1].position = {-1.5f, 0.5f, 2.0f};
    lights[1].normal = {1.0f, 0.0f, -1.0f};
    lights[2].shape = AreaLight::Shape::rectangle;
    lights[2].position = {0.0f, -2.0f, 2.0f};
    lights[2].axisV = {0.1f, -0.3f, -0.5f};
    lights[2].twoSided = true;
    lights[3].shape = AreaLight::Shape::tube;
    lights[3].position = {1.5f, -1.0f, 2.0f};
    lights[3].end = {1.5f, 1.0f, 2.2f};
    lights[3].size = 0.2f;
    lights[4].shape = AreaLight::Shape::polygon;  // not convex
    lights[4].vertices = {{-2, 1, 2}, {-1, 2, 2}, {0, 1.5f, 2}, {-1.2f, 1.4f, 2}};
    lights[4].twoSided = true;
    lights[4].radius = 6.0f;
    for (AreaLight& light : lights) light.radiance = {3.0f, 2.0f, 1.0f};
    return lights;
}

}  // namespace fbrdf::test
