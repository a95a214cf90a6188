// Lights.h - converts a light of the ABI into one of the planner.
#pragma once
#include "Boundary.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/plan/AreaLight.h>

namespace fbrdf::capi {

/// Checks the type only, because draws drop and count lights that are not valid. Throws Failure.
inline Light lightOf(const fbrdf_light& light)
{
    Light result;
    result.type = enumerator(light.type, Light::Type::spot, "light type");
    for (int k = 0; k < 3; ++k) {
        result.position[k] = light.position[k];
        result.intensity[k] = light.intensity[k];
        result.axis[k] = light.axis[k];
    }
    result.radius = light.radius;
    result.innerAngle = light.inner_angle;
    result.outerAngle = light.outer_angle;
    return result;
}

inline Vec3f vectorOf(const float (&v)[3])
{
    return {v[0], v[1], v[2]};
}

/// The same for an area light; also checks what is read through its pointer.
inline AreaLight areaLightOf(const fbrdf_area_light& light)
{
    AreaLight result;
    result.shape = enumerator(light.shape, AreaLight::Shape::polygon, "area shape");
    result.position = vectorOf(light.position);
    result.end = vectorOf(light.end);
    result.size = light.size;
    result.normal = vectorOf(light.normal);
    result.axisU = vectorOf(light.axis_u);
    result.axisV = vectorOf(light.axis_v);
    result.radiance = vectorOf(light.radiance);
    result.twoSided = light.two_sided != 0;
    result.radius = light.radius;
    if (result.shape != AreaLight::Shape::polygon) return result;
    if (light.vertex_count > static_cast<uint32_t>(kMostVertices))
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "vertex_count: " + Found(std::to_string(light.vertex_count))
                                             .expected("at most " + std::to_string(kMostVertices)));
    if (!light.vertices && light.vertex_count > 0)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "vertices: " + Found("NULL").expected("those of a polygon"));
    for (size_t i = 0; i < light.vertex_count; ++i)
        result.vertices.emplace_back(light.vertices[3 * i], light.vertices[3 * i + 1],
                                     light.vertices[3 * i + 2]);
    return result;
}

}  // namespace fbrdf::capi
