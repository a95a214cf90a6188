#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/TextFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::string& where, const std::string& what)
{
    throw Error(ErrorKind::input, where, what);
}

/// A JSON value as an error shows it, cut to a few words.
std::string quoted(const Json& value)
{
    constexpr size_t kLongest = 60;
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

/// The named member of a light, or null.
const Json* member(const Json& light, const char* name)
{
    const auto entry = light.find(name);
    return entry == light.end() ? nullptr : &*entry;
}

const Json& required(const Json& light, const char* name, const std::string& where)
{
    const Json* value = member(light, name);
    if (!value)
        fail(where, Found(std::string("no '") + name + "'").expected("a light that has one"));
    return *value;
}

float finiteFloat(const Json& value, const std::string& where, const char* expected)
{
    if (!value.is_number()) fail(where, Found(quoted(value)).expected(expected));
    const float number = static_cast<float>(value.get<double>());
    if (!std::isfinite(number)) fail(where, Found(quoted(value)).expected(expected));
    return number;
}

Vec3f vectorOf(const Json& light, const char* name, const std::string& where)
{
    const Json& value = required(light, name, where);
    const std::string field = where + "." + name;
    if (!value.is_array() || value.size() != 3)
        fail(field, Found(quoted(value)).expected("an array of three numbers"));
    Vec3f vector;
    for (int k = 0; k < 3; ++k)
        vector[k] = finiteFloat(value[static_cast<size_t>(k)], field, "three finite numbers");
    return vector;
}

Vec3f directionOf(const Json& light, const char* name, const std::string& where)
{
    const Vec3d direction(vectorOf(light, name, where));
    const double length = glm::length(direction);
    if (!(length > 0.0))
        fail(where + "." + name, Found("a vector of length 0").expected("a direction"));
    return Vec3f(direction / length);
}

Vec3f intensityOf(const Json& light, const std::string& where)
{
    const Vec3f intensity = vectorOf(light, "intensity", where);
    for (int k = 0; k < 3; ++k)
        if (intensity[k] < 0.0f)
            fail(where + ".intensity",
                 Found(quoted(light["intensity"])).expected("three numbers >= 0"));
    return intensity;
}

void placeLight(Light& light, const Json& json, const std::string& where)
{
    light.position = vectorOf(json, "position", where);
    if (const Json* radius = member(json, "radius"))
        light.radius = finiteFloat(*radius, where + ".radius", "a finite number >= 0");
    if (light.radius < 0.0f)
        fail(where + ".radius", Found(quoted(json["radius"])).expected("a finite number >= 0"));
}

float angleOf(const Json& light, const char* name, double lowestDegrees, const std::string& where)
{
    const char* const expected = "degrees, 0 <= inner_degrees <= outer_degrees <= 180";
    const Json& value = required(light, name, where);
    const std::string field = where + "." + name;
    const double degrees = static_cast<double>(finiteFloat(value, field, expected));
    if (degrees < lowestDegrees || degrees > 180.0)
        fail(field, Found(quoted(value)).expected(expected));
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
    if (!json.is_object()) fail(where, Found(quoted(json)).expected("an object"));
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
        fail(where + ".type",
             Found(quoted(type)).expected("\"point\", \"spot\" or \"directional\""));
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

Json jsonFromVector(const Vec3f& vector)
{
    return Json::array({vector.x, vector.y, vector.z});
}

}  // namespace

std::vector<Light> lightsFromJson(std::string_view text, const std::string& where)
{
    Json document;
    try {
        document = Json::parse(text);
    } catch (const Json::exception& error) {
        fail(where, Found(error.what()).expected("JSON {\"lights\": [...]}"));
    }
    if (!document.is_object() || !document.contains("lights") || !document["lights"].is_array())
        fail(where, Found(quoted(document)).expected("an object with an array 'lights'"));
    std::vector<Light> lights;
    for (const Json& light : document["lights"])
        lights.push_back(
            lightFromJson(light, where + ": lights[" + std::to_string(lights.size()) + "]"));
    return lights;
}

std::vector<Light> readLights(const std::string& path)
{
    return lightsFromJson(readText(path, "a JSON file of lights"), path);
}

std::string lightsToJson(const std::vector<Light>& lights)
{
    Json list = Json::array();
    for (const Light& light : lights) {
        const bool isDirectional = light.type == Light::Type::directional;
        Json entry{{"type", typeName(light.type)},
                   {isDirectional ? "direction" : "position", jsonFromVector(light.position)},
                   {"intensity", jsonFromVector(light.intensity)}};
        if (light.radius > 0.0f) entry["radius"] = light.radius;
        if (light.type == Light::Type::spot) {
            entry["axis"] = jsonFromVector(light.axis);
            entry["inner_degrees"] = static_cast<double>(light.innerAngle) * 180.0 / kPi;
            entry["outer_degrees"] = static_cast<double>(light.outerAngle) * 180.0 / kPi;
        }
        list.push_back(entry);
    }
    return Json{{"lights", list}}.dump(2) + "\n";
}

}  // namespace fbrdf::scene
