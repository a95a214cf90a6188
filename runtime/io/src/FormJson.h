// FormJson.h - forms as JSON text (as files: fbrdf/io/FormFile.h), and checked access to the fields
// of any JSON.
// {"name": "pqp",
//  "tables": [{"name": "p", "domain": {"disc": {"size": 32, "gamma": 0.5, "radius": 15.5}}},
//             {"name": "r", "uniform": true, "domain": {"grid": {"symmetric": false,
//                 "axes": [{"size": 16, "from": "1-cos", "exponent": 0.5}]}}}],
//  "terms": [[{"table": 0, "argument": "wo"}, {"table": 1, "argument": ["theta_d"]}]]}
#pragma once
#include <fbrdf/brdf/Form.h>

#include <nlohmann/json.hpp>
#include <string>

namespace fbrdf {

using Json = nlohmann::ordered_json;

/// A value and where it is ("a.json: form/tables/0"); its readers throw Error(input) that says so.
class JsonField {
public:
    JsonField(const Json& value, std::string where) : value_(&value), where_(std::move(where)) {}

    JsonField at(const char* key) const;
    JsonField at(size_t index) const;
    bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
    size_t size() const;  ///< elements of an array
    int integer() const;
    double number() const;  ///< finite
    bool boolean() const;
    std::string text() const;
    const Json& object() const;
    const std::string& where() const { return where_; }
    [[noreturn]] void fail(const std::string& expected) const;

private:
    const Json* value_;
    std::string where_;
};

/// Throws Error(input) with the byte where the text stops being JSON.
Json parseJson(const std::string& text, const std::string& where);

Json jsonFromForm(const Form& form);
/// The form, validated.
Form formFromJson(const JsonField& json);

}  // namespace fbrdf
