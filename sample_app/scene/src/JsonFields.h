// JsonFields.h - the fields of a JSON object, each asked for by name, with what may be in there.
#pragma once
#include "LightJson.h"

#include <string>
#include <vector>

namespace fbrdf::scene {

/// Both ends are allowed.
struct Interval {
    double lower = 0.0, upper = 0.0;
};

/// Functions change `value` where the field is there, and throw Error(input) where it is not what
/// was asked for.
class JsonFields {
public:
    /// Throws Error(input) unless the value is an object. Both must outlive this.
    JsonFields(const Json& object, std::string where);

    /// The field as it is, null where there is none. Once asked for it is known.
    const Json* field(const char* name);
    std::string place(const char* name) const;  ///< of a field, for errors
    void read(const char* name, bool& value);
    void read(const char* name, std::string& value);
    void read(const char* name, int& value, Interval range);
    void read(const char* name, double& value, Interval range);
    void read(const char* name, float& value, Interval range);
    void read(const char* name, Vec3d& value);
    /// Throws Error(input) for a field that nobody has asked for.
    void expectNoOthers() const;

private:
    const Json& object_;
    std::string where_;
    std::vector<std::string> known_;
};

}  // namespace fbrdf::scene
