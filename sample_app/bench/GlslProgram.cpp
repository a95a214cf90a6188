#include "bench/GlslProgram.h"

#include "bench/GlslTokens.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <set>

namespace fbrdf::bench {
namespace {

const std::set<std::string> kTypes{"void",      "float",         "int",           "bool",
                                   "vec2",      "vec3",          "vec4",          "ivec2",
                                   "ivec3",     "ivec4",         "mat3",          "mat4",
                                   "sampler2D", "sampler3D",     "samplerCube",   "sampler2DArray",
                                   "bvec3",     "samplerBuffer", "isamplerBuffer"};
const std::set<std::string> kQualifiers{"const", "uniform", "in",   "out",     "inout",    "flat",
                                        "highp", "mediump", "lowp", "varying", "precision"};

/// One declaration after another, at the top level.
class DeclarationReader {
public:
    explicit DeclarationReader(const std::string& text) { program_.tokens = glslTokens(text); }

    GlslProgram read()
    {
        const auto& tokens = program_.tokens;
        while (at_ < tokens.size()) {
            if (tokens[at_] == "struct")
                readStruct();
            else if (program_.isType(tokens[at_]) && token(at_ + 2) == "(")
                readFunction();
            else if (program_.isType(tokens[at_]))
                readVariables();
            else
                ++at_;  // qualifiers, and macros that are declarations
        }
        return std::move(program_);
    }

private:
    const std::string& token(size_t at) const
    {
        static const std::string none;
        return at < program_.tokens.size() ? program_.tokens[at] : none;
    }
    const std::string& next()
    {
        if (at_ >= program_.tokens.size())
            throw Error(ErrorKind::usage, "shader", Found("an end in the midst").expected("more"));
        return program_.tokens[at_++];
    }

    void readStruct()
    {
        ++at_;
        auto& members = program_.structs[next()];
        ++at_;  // {
        while (token(at_) != "}") {
            const std::string type = next();
            do members[next()] = type;
            while (next() == ",");
        }
        at_ += 2;  // };
    }

    void readFunction()
    {
        GlslFunction function;
        function.type = next();
        const std::string name = next();
        ++at_;  // (
        while (token(at_) != ")") {
            while (GlslProgram::isQualifier(token(at_))) ++at_;
            GlslParameter parameter;
            parameter.type = next();
            if (parameter.type != "void") parameter.name = next();
            if (!parameter.name.empty()) function.parameters.push_back(parameter);
            if (token(at_) == ",") ++at_;
        }
        ++at_;
        if (next() != "{") return;  // a prototype
        function.body = at_;
        for (int depth = 1; depth > 0;) {
            const std::string& brace = next();
            depth += brace == "{" ? 1 : brace == "}" ? -1 : 0;
        }
        program_.functions.emplace(name, function);
    }

    /// Of initial values only plain numbers are known afterwards.
    void readVariables()
    {
        const std::string type = next();
        const bool isConstant = at_ > 1 && token(at_ - 2) == "const";
        while (token(at_) != ";") {
            const std::string name = next();
            GlslVariable variable{type};
            int depth = 0;
            const bool literal =
                isConstant && token(at_) == "=" && (token(at_ + 2) == "," || token(at_ + 2) == ";");
            if (literal) variable.constant = glslNumber(token(at_ + 1));
            while (depth > 0 || (token(at_) != "," && token(at_) != ";")) {
                const std::string& skipped = next();
                depth += skipped == "(" || skipped == "["   ? 1
                         : skipped == ")" || skipped == "]" ? -1
                                                            : 0;
            }
            program_.globals[name] = variable;
            if (token(at_) == ",") ++at_;
        }
        ++at_;
    }

    GlslProgram program_;
    size_t at_ = 0;
};

}  // namespace

bool GlslProgram::isType(const std::string& token) const
{
    return kTypes.count(token) > 0 || structs.count(token) > 0;
}

bool GlslProgram::isQualifier(const std::string& token)
{
    return kQualifiers.count(token) > 0;
}

bool GlslProgram::isTypeAt(size_t token) const
{
    while (token < tokens.size() && isQualifier(tokens[token])) ++token;
    // A constructor at the start of a statement declares nothing.
    return token + 1 < tokens.size() && isType(tokens[token]) && tokens[token + 1] != "(";
}

GlslVariable GlslProgram::variable(const std::string& name, const GlslVariable* local) const
{
    if (local) return *local;
    const auto global = globals.find(name);
    return global == globals.end() ? GlslVariable{"vec4"} : global->second;
}

std::string GlslProgram::memberType(const std::string& type, const std::string& member) const
{
    const auto found = structs.find(type);
    if (found != structs.end()) return found->second.at(member);
    const std::string scalar = type[0] == 'i' ? "int" : "float";
    if (member.size() == 1) return scalar;
    return type.substr(0, type.size() - 1) + std::to_string(member.size());
}

std::multimap<std::string, GlslFunction>::const_iterator GlslProgram::functionFor(
    const std::string& name, const std::vector<std::string>& types) const
{
    const auto range = functions.equal_range(name);
    auto asMany = functions.end();
    for (auto at = range.first; at != range.second; ++at) {
        const auto& parameters = at->second.parameters;
        if (parameters.size() != types.size()) continue;
        if (asMany == functions.end()) asMany = at;
        const bool same = std::equal(types.begin(), types.end(), parameters.begin(),
                                     [](const std::string& type, const GlslParameter& parameter) {
                                         return type == parameter.type;
                                     });
        if (same) return at;
    }
    return asMany;
}

GlslProgram parsedProgram(const std::string& text)
{
    return DeclarationReader(text).read();
}

}  // namespace fbrdf::bench
