// GlslProgram.h - the declarations of a GLSL text: structs, variables, functions.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::bench {

struct GlslVariable {
    std::string type;  ///< of arrays that of an element
    std::optional<double> constant = {};
    std::string sampler = {};  ///< of a parameter: the sampler that was handed over
};

struct GlslParameter {
    std::string type, name;
};

struct GlslFunction {
    std::string type;
    std::vector<GlslParameter> parameters;
    size_t body = 0;  ///< index of the first token after the brace
};

struct GlslProgram {
    std::vector<std::string> tokens;
    std::map<std::string, std::map<std::string, std::string>> structs;  ///< types of members
    std::map<std::string, GlslVariable> globals;
    std::multimap<std::string, GlslFunction> functions;

    bool isType(const std::string& token) const;
    static bool isQualifier(const std::string& token);
    /// True where a declaration begins.
    bool isTypeAt(size_t token) const;
    /// The local one, where it is not null, or the global one; names that nothing declares are
    /// those of OpenGL and of macros, which are vec4.
    GlslVariable variable(const std::string& name, const GlslVariable* local) const;
    /// Of a struct, or of as many components of a vector.
    std::string memberType(const std::string& type, const std::string& member) const;
    /// The one with parameters of these types, or the first with as many.
    std::multimap<std::string, GlslFunction>::const_iterator functionFor(
        const std::string& name, const std::vector<std::string>& types) const;
};

/// Throws Error(usage) for braces that do not match.
GlslProgram parsedProgram(const std::string& text);

}  // namespace fbrdf::bench
