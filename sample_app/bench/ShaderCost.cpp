#include "bench/ShaderCost.h"

#include "bench/GlslProgram.h"
#include "bench/GlslTokens.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace fbrdf::bench {
namespace {

/// What is known of an expression.
struct GlslValue {
    std::string type = "float";
    std::optional<double> constant = {};
    std::string name = {};  ///< of the variable, or of the sampler, that it is
};

using Scope = std::map<std::string, GlslVariable>;

bool isInteger(const std::string& type)
{
    return type == "int" || type == "bool" || type[0] == 'i' || type[0] == 'b';
}

/// Components of a value that arithmetic touches.
double componentsOf(const std::string& type)
{
    if (type == "mat3") return 9.0;
    if (type == "mat4") return 16.0;
    const bool vector = type.find("vec") != std::string::npos;
    return vector ? static_cast<double>(type.back() - '0') : 1.0;
}

const std::set<std::string> kSpecials{"sqrt", "inversesqrt", "exp",  "exp2", "log",  "log2", "sin",
                                      "cos",  "tan",         "atan", "acos", "asin", "pow"};
const std::set<std::string> kFree{"max",   "min",  "abs",   "sign",          "floor",      "ceil",
                                  "fract", "step", "clamp", "lessThanEqual", "greaterThan"};
const std::set<std::string> kFetches{"FBRDF_TEXTURE2",
                                     "FBRDF_TEXTURE3",
                                     "FBRDF_TEXTURE_CUBE",
                                     "FBRDF_TEXTURE2_LEVEL",
                                     "FBRDF_TEXTURE_CUBE_LEVEL",
                                     "FBRDF_TEXTURE_MIPMAPPED",
                                     "texture",
                                     "textureLod",
                                     "texelFetch"};

double totalOf(const ShaderCost& cost)
{
    return cost.multiplications + cost.additions + cost.specials;
}

/// Runs statements once, without values but for constants, and adds up what they cost.
class CostCounter {
public:
    CostCounter(const GlslProgram& program, const std::map<std::string, double>& values)
        : program_(program), tokens_(program.tokens), values_(values)
    {
    }

    ShaderCost ofMain()
    {
        call({"main", program_.functions.find("main")}, {});
        return cost_;
    }

private:
    struct Callee {
        std::string name;
        std::multimap<std::string, GlslFunction>::const_iterator found;
    };

    [[noreturn]] void fail(const std::string& expected) const
    {
        throw Error(
            ErrorKind::usage, "shader",
            Found(at_ < tokens_.size() ? "'" + tokens_[at_] + "'" : "the end").expected(expected));
    }
    bool isNext(const std::string& token) const
    {
        return at_ < tokens_.size() && tokens_[at_] == token;
    }
    bool take(const std::string& token)
    {
        if (!isNext(token)) return false;
        ++at_;
        return true;
    }
    void expect(const std::string& token)
    {
        if (!take(token)) fail("'" + token + "'");
    }
    std::string next()
    {
        if (at_ >= tokens_.size()) fail("more");
        return tokens_[at_++];
    }

    /// The cost of what `run` goes through, which is not added.
    template <class Run>
    ShaderCost apart(const Run& run)
    {
        const ShaderCost before = std::exchange(cost_, {});
        run();
        return std::exchange(cost_, before);
    }
    template <class Run>
    void ignore(const Run& run)
    {
        apart(run);
    }

    /// True where the statement returns.
    bool statement()
    {
        if (take("{")) return block();
        if (take("if")) return branch();
        if (take("for")) return loop();
        if (take("return")) {
            if (!isNext(";")) expression();
            expect(";");
            return true;
        }
        if (program_.isTypeAt(at_)) {
            declaration();
            return false;
        }
        if (!isNext(";")) expression();
        expect(";");
        return false;
    }

    bool block()
    {
        scopes_.emplace_back();
        bool returned = false;
        while (!take("}")) {
            if (returned)
                ignore([&] { statement(); });
            else
                returned = statement();
        }
        scopes_.pop_back();
        return returned;
    }

    bool branch()
    {
        expect("(");
        const GlslValue condition = expression();
        expect(")");
        bool thenReturns = false, elseReturns = false;
        const ShaderCost then = apart([&] { thenReturns = statement(); });
        ShaderCost otherwise;
        if (take("else")) otherwise = apart([&] { elseReturns = statement(); });
        if (condition.constant) {
            cost_ += *condition.constant != 0.0 ? then : otherwise;
            return *condition.constant != 0.0 ? thenReturns : elseReturns;
        }
        cost_ += totalOf(then) > totalOf(otherwise) ? then : otherwise;
        return thenReturns && elseReturns;
    }

    /// for (int i = A; i < B; ++i)
    bool loop()
    {
        scopes_.emplace_back();
        expect("(");
        expect("int");
        const std::string name = next();
        expect("=");
        const GlslValue first = expression();
        expect(";");
        scopes_.back()[name] = {"int", {}, {}};
        next();
        expect("<");
        const GlslValue end = expression();
        expect(";");
        expect("++");
        next();
        expect(")");
        if (!first.constant || !end.constant) fail("a loop whose steps are known, before");
        const ShaderCost once = apart([&] { statement(); });
        cost_ += once * std::max(0.0, *end.constant - *first.constant);
        scopes_.pop_back();
        return false;
    }

    void declaration()
    {
        while (program_.isQualifier(tokens_[at_])) ++at_;
        const std::string type = next();
        do {
            const std::string name = next();
            if (take("[")) {
                expression();
                expect("]");
            }
            GlslValue value{type};
            if (take("=")) value = assignment();
            scopes_.back()[name] = {type, value.constant, {}};
        } while (take(","));
        expect(";");
    }

    GlslValue expression()
    {
        GlslValue value = assignment();
        while (take(",")) value = assignment();
        return value;
    }

    GlslValue assignment()
    {
        GlslValue left = ternary();
        const std::string token = at_ < tokens_.size() ? tokens_[at_] : "";
        const bool compound = token == "+=" || token == "-=" || token == "*=" || token == "/=";
        if (token != "=" && !compound) return left;
        ++at_;
        const GlslValue right = assignment();
        if (compound) arithmetic(token.substr(0, 1), {left.type}, right);
        if (GlslVariable* variable = local(left.name)) variable->constant.reset();
        return {left.type};
    }

    GlslValue ternary()
    {
        GlslValue condition = binary(0);
        if (!take("?")) return condition;
        GlslValue yes, no;
        const ShaderCost then = apart([&] { yes = assignment(); });
        expect(":");
        const ShaderCost otherwise = apart([&] { no = assignment(); });
        if (condition.constant) {
            cost_ += *condition.constant != 0.0 ? then : otherwise;
            return *condition.constant != 0.0 ? yes : no;
        }
        cost_ += totalOf(then) > totalOf(otherwise) ? then : otherwise;
        return {yes.type};
    }

    GlslValue binary(size_t level)
    {
        static const std::vector<std::set<std::string>> kLevels{
            {"||"}, {"&&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"+", "-"}, {"*", "/"}};
        if (level == kLevels.size()) return unary();
        GlslValue left = binary(level + 1);
        while (at_ < tokens_.size() && kLevels[level].count(tokens_[at_])) {
            const std::string operation = next();
            const GlslValue right = binary(level + 1);
            left = arithmetic(operation, left, right);
        }
        return left;
    }

    static std::optional<double> folded(const std::string& operation, const GlslValue& a,
                                        const GlslValue& b)
    {
        if (!a.constant || !b.constant) return {};
        const double x = *a.constant, y = *b.constant;
        if (operation == "+") return x + y;
        if (operation == "-") return x - y;
        if (operation == "*") return x * y;
        if (operation == "/") return x / y;
        if (operation == "==") return x == y ? 1.0 : 0.0;
        if (operation == "!=") return x != y ? 1.0 : 0.0;
        return {};
    }

    GlslValue arithmetic(const std::string& operation, const GlslValue& a, const GlslValue& b)
    {
        const double sizeA = componentsOf(a.type), sizeB = componentsOf(b.type),
                     size = std::max(sizeA, sizeB);
        const bool arithmetical =
            operation == "+" || operation == "-" || operation == "*" || operation == "/";
        if (!arithmetical) return {"bool", folded(operation, a, b)};
        GlslValue result{sizeA >= sizeB ? a.type : b.type, folded(operation, a, b)};
        if (result.constant || (isInteger(a.type) && isInteger(b.type))) return result;
        const bool matrixTimesVector = sizeA >= 9.0 && sizeB > 1.0 && sizeB < 9.0;
        if (operation == "*" && matrixTimesVector) {
            cost_.multiplications += sizeA;
            cost_.additions += sizeA - sizeB;
            return {b.type};
        }
        if (operation == "*") cost_.multiplications += size;
        if (operation == "+" || operation == "-") cost_.additions += size;
        if (operation == "/") {
            cost_.multiplications += size;
            if (!b.constant) cost_.specials += sizeB;
        }
        return result;
    }

    GlslValue unary()
    {
        if (take("-")) {
            GlslValue value = unary();
            if (value.constant) value.constant = -*value.constant;
            return {value.type, value.constant};
        }
        if (take("!")) {
            GlslValue value = unary();
            if (value.constant) value.constant = *value.constant == 0.0 ? 1.0 : 0.0;
            return {"bool", value.constant};
        }
        if (take("+") || take("++") || take("--")) return unary();
        return postfix(primary());
    }

    GlslValue postfix(GlslValue value)
    {
        while (true) {
            if (take(".")) {
                value = {program_.memberType(value.type, next())};
            } else if (take("[")) {
                expression();
                expect("]");
                value = {value.name.empty() && value.type.find("mat") == 0
                             ? "vec" + value.type.substr(3)
                             : value.type};
            } else if (!take("++") && !take("--")) {
                return value;
            }
        }
    }

    GlslValue primary()
    {
        const std::string token = next();
        if (token == "(") {
            const GlslValue value = expression();
            expect(")");
            return value;
        }
        if (std::isdigit(static_cast<unsigned char>(token[0])) || token[0] == '.')
            return {token.find_first_of(".e") == std::string::npos ? "int" : "float",
                    glslNumber(token)};
        if (token == "true" || token == "false") return {"bool", token == "true" ? 1.0 : 0.0};
        if (program_.isType(token) && take("[")) {  // float[8](...)
            if (!isNext("]")) expression();
            expect("]");
        }
        if (take("(")) return called(token, arguments());
        const auto known = values_.find(token);
        if (known != values_.end()) return {"int", known->second};
        const GlslVariable variable = program_.variable(token, local(token));
        return {variable.type, variable.constant,
                variable.sampler.empty() ? token : variable.sampler};
    }

    std::vector<GlslValue> arguments()
    {
        std::vector<GlslValue> values;
        while (!take(")")) {
            values.push_back(assignment());
            take(",");
        }
        return values;
    }

    GlslValue called(std::string name, const std::vector<GlslValue>& values)
    {
        if (name == "FBRDF_TEXTURE_PRECISE") name = "fbrdfFiltered";  // version.glsl
        if (program_.isType(name))
            return {name, values.size() == 1 ? values[0].constant : std::nullopt};
        if (kFetches.count(name)) {
            cost_.fetches[values.at(0).name] += 1.0;
            return {"vec4"};
        }
        const std::vector<std::string> types = [&] {
            std::vector<std::string> result;
            for (const GlslValue& value : values) result.push_back(value.type);
            return result;
        }();
        const auto found = program_.functionFor(name, types);
        if (found != program_.functions.end()) return call({name, found}, values);
        if (values.empty()) fail("a function, before");
        return builtIn(name, values);
    }

    GlslValue builtIn(const std::string& name, const std::vector<GlslValue>& values)
    {
        double size = 0.0;
        std::string type;
        for (const GlslValue& value : values)
            if (componentsOf(value.type) > size) {
                size = componentsOf(value.type);
                type = value.type;
            }
        if (kSpecials.count(name)) {
            cost_.specials += size * (name == "pow" ? 2.0 : 1.0);
            if (name == "pow") cost_.multiplications += size;
        } else if (name == "dot" || name == "length" || name == "normalize") {
            cost_.multiplications += name == "normalize" ? 2.0 * size : size;
            cost_.additions += size - 1.0;
            cost_.specials += name == "dot" ? 0.0 : 1.0;
            if (name != "normalize") type = "float";
        } else if (name == "cross") {
            cost_.multiplications += 6.0;
            cost_.additions += 3.0;
        } else if (name == "mix") {
            cost_.multiplications += size;
            cost_.additions += 2.0 * size;
        } else if (!kFree.count(name)) {
            --at_;
            fail("a function that is known, not " + name + ", before");
        }
        return {type};
    }

    GlslValue call(const Callee& callee, const std::vector<GlslValue>& values)
    {
        if (callee.found == program_.functions.end()) fail(callee.name);
        const GlslFunction& function = callee.found->second;
        std::vector<Scope> outer = std::exchange(scopes_, {Scope{}});
        for (size_t i = 0; i < values.size(); ++i)
            scopes_.back()[function.parameters[i].name] = {
                function.parameters[i].type, values[i].constant,
                function.parameters[i].type.find("sampler") == std::string::npos ? ""
                                                                                 : values[i].name};
        const size_t after = std::exchange(at_, function.body);
        block();
        at_ = after;
        scopes_ = std::move(outer);
        return {function.type};
    }

    GlslVariable* local(const std::string& name)
    {
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
            const auto found = scope->find(name);
            if (found != scope->end()) return &found->second;
        }
        return nullptr;
    }

    const GlslProgram& program_;
    const std::vector<std::string>& tokens_;
    const std::map<std::string, double>& values_;
    size_t at_ = 0;
    ShaderCost cost_;
    std::vector<Scope> scopes_;
};

}  // namespace

ShaderCost& ShaderCost::operator+=(const ShaderCost& other)
{
    multiplications += other.multiplications;
    additions += other.additions;
    specials += other.specials;
    for (const auto& [sampler, count] : other.fetches) fetches[sampler] += count;
    return *this;
}

ShaderCost ShaderCost::operator*(double times) const
{
    ShaderCost result{multiplications * times, additions * times, specials * times, fetches};
    for (auto& [sampler, count] : result.fetches) count *= times;
    return result;
}

ShaderCost costOf(const std::string& fragmentSource, const std::map<std::string, double>& values)
{
    return CostCounter(parsedProgram(fragmentSource), values).ofMain();
}

}  // namespace fbrdf::bench
