#include "LightJson.h"

#include <fbrdf/base/Found.h>

#include <optional>

namespace fbrdf::scene {
namespace {

using Shape = AreaLight::Shape;

constexpr Shape kShapes[] = {Shape::sphere, Shape::disc, Shape::rectangle, Shape::tube,
                             Shape::polygon};

std::optional<Shape> shapeOf(const Json& light)
{
    const Json* const type = member(light, "type");
    for (const Shape shape : kShapes)
        if (type && *type == shapeName(shape)) return shape;
    return std::nullopt;
}

float sizeOf(const Json& light, const std::string& where)
{
    return finiteFloat(required(light, "size", where), where + ".size", "a finite number > 0");
}

std::vector<Vec3f> verticesOf(const Json& light, const std::string& where)
{
    const Json& list = required(light, "vertices", where);
    const std::string field = where + ".vertices";
    if (!list.is_array()) failLight(field, Found(quoted(list)).expected("an array of points"));
    std::vector<Vec3f> vertices;
    for (const Json& vertex : list)
        vertices.push_back(vectorFrom(vertex, field + "[" + std::to_string(vertices.size()) + "]"));
    return vertices;
}

void setShape(AreaLight& light, const Json& json, const std::string& where)
{
    switch (light.shape) {
        case Shape::polygon: light.vertices = verticesOf(json, where); return;
        case Shape::tube:
            light.position = vectorOf(json, "from", where);
            light.end = vectorOf(json, "to", where);
            light.size = sizeOf(json, where);
            return;
        case Shape::rectangle:
            light.position = vectorOf(json, "position", where);
            light.axisU = vectorOf(json, "axis_u", where);
            light.axisV = vectorOf(json, "axis_v", where);
            return;
        case Shape::disc: light.normal = directionOf(json, "normal", where); break;
        case Shape::sphere: break;
    }
    light.position = vectorOf(json, "position", where);
    light.size = sizeOf(json, where);
}

bool isFlat(Shape shape)
{
    return shape != Shape::sphere && shape != Shape::tube;
}

}  // namespace

bool isAreaLight(const Json& light)
{
    return shapeOf(light).has_value();
}

AreaLight areaLightFromJson(const Json& json, const std::string& where)
{
    AreaLight light;
    light.shape = *shapeOf(json);
    setShape(light, json, where);
    light.radiance = vectorOf(json, "radiance", where);
    if (const Json* radius = member(json, "radius"))
        light.radius = finiteFloat(*radius, where + ".radius", "a finite number >= 0");
    if (const Json* sides = member(json, "two_sided")) {
        if (!sides->is_boolean())
            failLight(where + ".two_sided", Found(quoted(*sides)).expected("true or false"));
        light.twoSided = sides->get<bool>();
    }
    // "FIELD: found X, expected Y".
    const std::string why = whyInvalid(light);
    if (const size_t colon = why.find(": "); colon != std::string::npos)
        failLight(where + "." + why.substr(0, colon), why.substr(colon + 2));
    return light;
}

Json jsonFromAreaLight(const AreaLight& light)
{
    Json json{{"type", shapeName(light.shape)}, {"radiance", jsonFromVector(light.radiance)}};
    const bool isTube = light.shape == Shape::tube;
    if (light.shape != Shape::polygon)
        json[isTube ? "from" : "position"] = jsonFromVector(light.position);
    if (isTube) json["to"] = jsonFromVector(light.end);
    if (!isFlat(light.shape) || light.shape == Shape::disc)
        json["size"] = jsonFromFloat(light.size);
    if (light.shape == Shape::disc) json["normal"] = jsonFromVector(light.normal);
    if (light.shape == Shape::rectangle) {
        json["axis_u"] = jsonFromVector(light.axisU);
        json["axis_v"] = jsonFromVector(light.axisV);
    }
    if (light.shape == Shape::polygon)
        for (const Vec3f& vertex : light.vertices)
            json["vertices"].push_back(jsonFromVector(vertex));
    if (isFlat(light.shape)) json["two_sided"] = light.twoSided;
    if (light.radius > 0.0f) json["radius"] = jsonFromFloat(light.radius);
    return json;
}

}  // namespace fbrdf::scene
