// FormJson.h - forms as JSON (docs/format.md, section Form JSON), and checked access to the fields
// of any JSON.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <nlohmann/json.hpp>
#include <string>

namespace fbrdf {

using Json = nlohmann::ordered_json;

/// A value and its place ("a.json: form/tables/0"). Its readers throw Error(input) that names the
/// place.
class JsonField {
public:
    JsonField(const Json& value, std::string where) : value_(&value), where_(std::move(where)) {}

    JsonField at(const char* key) const;
    JsonField at(size_t index) const;
    bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
    size_t size() const;  ///< number of elements of an array
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
