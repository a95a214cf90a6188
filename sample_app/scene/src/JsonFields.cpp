#include "JsonFields.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

std::string inInterval(const char* kind, Interval range)
{
    return std::string(kind) + " from " + numberText(range.lower) + " to " +
           numberText(range.upper);
}

[[noreturn]] void failField(const std::string& place, const Json& value, const std::string& what)
{
    failLight(place, Found(quoted(value)).expected(what));
}

}  // namespace

JsonFields::JsonFields(const Json& object, std::string where)
    : object_(object), where_(std::move(where))
{
    if (!object.is_object()) failField(where_, object, "an object");
}

const Json* JsonFields::field(const char* name)
{
    known_.emplace_back(name);
    return member(object_, name);
}

std::string JsonFields::place(const char* name) const
{
    return where_ + (where_.find(": ") == std::string::npos ? ": " : ".") + name;
}

void JsonFields::read(const char* name, bool& value)
{
    const Json* const found = field(name);
    if (!found) return;
    if (!found->is_boolean()) failField(place(name), *found, "true or false");
    value = found->get<bool>();
}

void JsonFields::read(const char* name, std::string& value)
{
    const Json* const found = field(name);
    if (!found) return;
    if (!found->is_string()) failField(place(name), *found, "a text");
    value = found->get<std::string>();
}

void JsonFields::read(const char* name, int& value, Interval range)
{
    double number = value;
    const Json* const found = member(object_, name);
    read(name, number, range);
    if (number != std::floor(number))
        failField(place(name), *found, inInterval("a whole number", range));
    value = static_cast<int>(number);
}

void JsonFields::read(const char* name, double& value, Interval range)
{
    const Json* const found = field(name);
    if (!found) return;
    const double number = found->is_number() ? found->get<double>() : std::nan("");
    if (!(number >= range.lower && number <= range.upper))
        failField(place(name), *found, inInterval("a number", range));
    value = number;
}

void JsonFields::read(const char* name, float& value, Interval range)
{
    auto number = static_cast<double>(value);
    read(name, number, range);
    value = static_cast<float>(number);
}

void JsonFields::read(const char* name, Vec3d& value)
{
    const Json* const found = field(name);
    if (!found) return;
    if (!found->is_array() || found->size() != 3)
        failField(place(name), *found, "an array of three numbers");
    for (int k = 0; k < 3; ++k) {
        const Json& number = (*found)[static_cast<size_t>(k)];
        if (!number.is_number() || !std::isfinite(number.get<double>()))
            failField(place(name), *found, "an array of three finite numbers");
        value[k] = number.get<double>();
    }
}

void JsonFields::expectNoOthers() const
{
    for (const auto& [name, value] : object_.items()) {
        if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
        std::string all;
        for (const std::string& known : known_) all += (all.empty() ? "" : ", ") + known;
        failLight(place(quoted(Json(name)).c_str()),
                  Found("a field of no such name").expected("one of " + all));
    }
}

}  // namespace fbrdf::scene
