#include <fbrdf/fit/FormKey.h>

#include <array>
#include <charconv>

namespace fbrdf {
namespace {

// The fewest digits that give the same double back.
std::string exact(double value)
{
    std::array<char, 32> digits;  // a double never needs more than 24
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return std::string(digits.data(), end);
}

std::string keyOf(const DiscDomain& disc)
{
    return "disc " + std::to_string(disc.size) + " gamma " + exact(disc.gamma) + " radius " +
           exact(disc.radius);
}

std::string keyOf(const GridDomain& grid)
{
    std::string key = grid.symmetric ? "symmetric" : "grid";
    for (const Axis& axis : grid.axes)
        key += " " + std::to_string(axis.size) +
               (axis.map.from == AxisMap::From::cosine ? " cos^" : " (1-cos)^") +
               exact(axis.map.exponent);
    return key;
}

std::string keyOf(const Direction& direction)
{
    switch (direction.kind) {
        case Direction::Kind::difference: return "d";
        case Direction::Kind::mirror: return "mirror";
        case Direction::Kind::combination: break;
    }
    return exact(direction.weight_wi) + "wi " + exact(direction.weight_wo) + "wo " +
           exact(direction.weight_n) + "n";
}

std::string keyOf(const std::vector<Angle>& angles)
{
    std::string key;
    for (const Angle angle : angles)
        key += (key.empty() ? "" : ",") + std::string(angleName(angle));
    return key;
}

template <class... Kinds>
std::string keyOfAny(const std::variant<Kinds...>& value)
{
    return std::visit([](const auto& kind) { return keyOf(kind); }, value);
}

}  // namespace

std::string formKey(const Form& form)
{
    std::string key;
    for (const TableSpec& spec : form.tables)
        key += "[" + keyOfAny(spec.domain) + (spec.uniform ? " uniform]" : "]");
    for (const Term& term : form.terms) {
        key += key.back() == ']' ? "=" : "+";
        for (const Factor& factor : term.factors)
            key += std::to_string(factor.table) + "(" + keyOfAny(factor.argument) + ")";
    }
    return key;
}

}  // namespace fbrdf
