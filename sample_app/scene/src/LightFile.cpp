#include "LightJson.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/TextFile.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

Vec3f intensityOf(const Json& light, const std::string& where)
{
    const Vec3f intensity = vectorOf(light, "intensity", where);
    for (int k = 0; k < 3; ++k)
        if (intensity[k] < 0.0f)
            failLight(where + ".intensity",
                      Found(quoted(light["intensity"])).expected("three numbers >= 0"));
    return intensity;
}

void placeLight(Light& light, const Json& json, const std::string& where)
{
    light.position = vectorOf(json, "position", where);
    if (const Json* radius = member(json, "radius"))
        light.radius = finiteFloat(*radius, where + ".radius", "a finite number >= 0");
    if (light.radius < 0.0f)
        failLight(where + ".radius",
                  Found(quoted(json["radius"])).expected("a finite number >= 0"));
}

float angleOf(const Json& light, const char* name, double lowestDegrees, const std::string& where)
{
    const char* const expected = "degrees, 0 <= inner_degrees <= outer_degrees <= 180";
    const Json& value = required(light, name, where);
    const std::string field = where + "." + name;
    const double degrees = static_cast<double>(finiteFloat(value, field, expected));
    if (degrees < lowestDegrees || degrees > 180.0)
        failLight(field, Found(quoted(value)).expected(expected));
    // The float that is nearest to pi is above pi, so an angle of 180 degrees is cut to it.
    return std::min(static_cast<float>(degrees * kPi / 180.0), static_cast<float>(kPi));
}

void aimSpot(Light& light, const Json& json, const std::string& where)
{
    light.type = Light::Type::spot;
    light.axis = directionOf(json, "axis", where);
    light.innerAngle = angleOf(json, "inner_degrees", 0.0, where);
    light.outerAngle = angleOf(json, "outer_degrees", json["inner_degrees"].get<double>(), where);
}

Light lightFromJson(const Json& json, const std::string& where)
{
    const Json& type = required(json, "type", where);
    Light light;
    if (type == "point") {
        placeLight(light, json, where);
    } else if (type == "spot") {
        placeLight(light, json, where);
        aimSpot(light, json, where);
    } else if (type == "directional") {
        light.type = Light::Type::directional;
        light.position = directionOf(json, "direction", where);
    } else {
        failLight(where + ".type",
                  Found(quoted(type))
                      .expected("\"point\", \"spot\", \"directional\", \"sphere\", \"disc\", "
                                "\"rectangle\", \"tube\" or \"polygon\""));
    }
    light.intensity = intensityOf(json, where);
    return light;
}

const char* typeName(Light::Type type)
{
    switch (type) {
        case Light::Type::point: return "point";
        case Light::Type::directional: return "directional";
        case Light::Type::spot: return "spot";
    }
    return "";
}

}  // namespace

LightSet lightsFromJson(std::string_view text, const std::string& where)
{
    Json document;
    try {
        document = Json::parse(text);
    } catch (const Json::exception& error) {
        failLight(where, Found(error.what()).expected("JSON {\"lights\": [...]}"));
    }
    if (!document.is_object() || !document.contains("lights") || !document["lights"].is_array())
        failLight(where, Found(quoted(document)).expected("an object with an array 'lights'"));
    return lightsFromList(document["lights"], where + ": lights");
}

LightSet lightsFromList(const Json& list, const std::string& where)
{
    LightSet set;
    for (const Json& light : list) {
        const std::string place = where + "[" + std::to_string(set.size()) + "]";
        if (!light.is_object()) failLight(place, Found(quoted(light)).expected("an object"));
        if (isAreaLight(light))
            set.areaLights.push_back(areaLightFromJson(light, place));
        else
            set.lights.push_back(lightFromJson(light, place));
    }
    return set;
}

LightSet readLights(const std::string& path)
{
    return lightsFromJson(readText(path, "a JSON file of lights"), path);
}

Json listFromLights(const LightSet& set)
{
    Json list = Json::array();
    for (const Light& light : set.lights) {
        const bool isDirectional = light.type == Light::Type::directional;
        Json entry{{"type", typeName(light.type)},
                   {isDirectional ? "direction" : "position", jsonFromVector(light.position)},
                   {"intensity", jsonFromVector(light.intensity)}};
        if (light.radius > 0.0f) entry["radius"] = jsonFromFloat(light.radius);
        if (light.type == Light::Type::spot) {
            entry["axis"] = jsonFromVector(light.axis);
            entry["inner_degrees"] = static_cast<double>(light.innerAngle) * 180.0 / kPi;
            entry["outer_degrees"] = static_cast<double>(light.outerAngle) * 180.0 / kPi;
        }
        list.push_back(entry);
    }
    for (const AreaLight& light : set.areaLights) list.push_back(jsonFromAreaLight(light));
    return list;
}

std::string lightsToJson(const LightSet& set)
{
    return Json{{"lights", listFromLights(set)}}.dump(2) + "\n";
}

}  // namespace fbrdf::scene
