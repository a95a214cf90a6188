// LightJson.h - fields of a light in a JSON file, checked. All throw Error(input) naming the field.
#pragma once
#include <fbrdf/scene/Lights.h>

#include <nlohmann/json.hpp>

#include <string>

namespace fbrdf::scene {

using Json = nlohmann::json;

[[noreturn]] void failLight(const std::string& where, const std::string& what);
/// A JSON value as an error shows it, cut to a few words.
std::string quoted(const Json& value);
/// The named member of a light, or null.
const Json* member(const Json& light, const char* name);
const Json& required(const Json& light, const char* name, const std::string& where);
float finiteFloat(const Json& value, const std::string& where, const char* expected);
Vec3f vectorFrom(const Json& value, const std::string& field);
Vec3f vectorOf(const Json& light, const char* name, const std::string& where);
Vec3f directionOf(const Json& light, const char* name, const std::string& where);
/// A float in the fewest digits that give it back.
Json jsonFromFloat(float number);
Json jsonFromVector(const Vec3f& vector);

/// True for the type of a light with a shape.
bool isAreaLight(const Json& light);
AreaLight areaLightFromJson(const Json& light, const std::string& where);
Json jsonFromAreaLight(const AreaLight& light);

/// The lights of an array, and back, as in Lights.h.
LightSet lightsFromList(const Json& list, const std::string& where);
Json listFromLights(const LightSet& set);

}  // namespace fbrdf::scene
