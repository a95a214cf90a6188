#include "LightJson.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>

#include <cmath>

namespace fbrdf::scene {

void failLight(const std::string& where, const std::string& what)
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
        failLight(where, Found(std::string("no '") + name + "'").expected("a light that has one"));
    return *value;
}

float finiteFloat(const Json& value, const std::string& where, const char* expected)
{
    if (!value.is_number()) failLight(where, Found(quoted(value)).expected(expected));
    const float number = static_cast<float>(value.get<double>());
    if (!std::isfinite(number)) failLight(where, Found(quoted(value)).expected(expected));
    return number;
}

Vec3f vectorFrom(const Json& value, const std::string& field)
{
    if (!value.is_array() || value.size() != 3)
        failLight(field, Found(quoted(value)).expected("an array of three numbers"));
    Vec3f vector;
    for (int k = 0; k < 3; ++k)
        vector[k] = finiteFloat(value[static_cast<size_t>(k)], field, "three finite numbers");
    return vector;
}

Vec3f vectorOf(const Json& light, const char* name, const std::string& where)
{
    return vectorFrom(required(light, name, where), where + "." + name);
}

Vec3f directionOf(const Json& light, const char* name, const std::string& where)
{
    const Vec3d direction(vectorOf(light, name, where));
    const double length = glm::length(direction);
    if (!(length > 0.0))
        failLight(where + "." + name, Found("a vector of length 0").expected("a direction"));
    return Vec3f(direction / length);
}

Json jsonFromFloat(float number)
{
    // 9 digits give every float back; fewer are easier to read.
    for (const int digits : {7, 8}) {
        double rounded = 0.0;
        parseNumber(numberText(static_cast<double>(number), digits), rounded);
        if (static_cast<float>(rounded) == number) return rounded;
    }
    return static_cast<double>(number);
}

Json jsonFromVector(const Vec3f& vector)
{
    return Json::array({jsonFromFloat(vector.x), jsonFromFloat(vector.y), jsonFromFloat(vector.z)});
}

}  // namespace fbrdf::scene
