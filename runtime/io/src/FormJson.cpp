#include "FormJson.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

namespace fbrdf {
namespace {

constexpr char kOneMinusCosine[] = "1-cos", kCosine[] = "cos";

// Containers are only counted: printing one recurses, and hostile text nests as deep as it is long.
std::string summary(const Json& value)
{
    if (value.is_object()) return "an object of " + std::to_string(value.size());
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

Json jsonFromDomain(const Domain& domain)
{
    if (const auto* disc = std::get_if<DiscDomain>(&domain))
        return {{"disc", {{"size", disc->size}, {"gamma", disc->gamma}, {"radius", disc->radius}}}};
    const auto& grid = std::get<GridDomain>(domain);
    Json axes = Json::array();
    for (const Axis& axis : grid.axes)
        axes.push_back(
            {{"size", axis.size},
             {"from", axis.map.from == AxisMap::From::cosine ? kCosine : kOneMinusCosine},
             {"exponent", axis.map.exponent}});
    return {{"grid", {{"symmetric", grid.symmetric}, {"axes", axes}}}};
}

// Directions that have a name are written by it, because three weights say little to a reader.
const std::array<Direction, 5> kNamedDirections{Direction::wi, Direction::wo, Direction::h,
                                                Direction::d, Direction::mirror};

bool isNamed(const Direction& direction)
{
    return std::find(kNamedDirections.begin(), kNamedDirections.end(), direction) !=
           kNamedDirections.end();
}

Json jsonFromArgument(const Argument& argument)
{
    if (const auto* direction = std::get_if<Direction>(&argument)) {
        if (isNamed(*direction)) return directionName(*direction);
        return {{"norm", {direction->weight_wi, direction->weight_wo, direction->weight_n}}};
    }
    Json angles = Json::array();
    for (const Angle angle : std::get<std::vector<Angle>>(argument))
        angles.push_back(angleName(angle));
    return angles;
}

Axis axisFromJson(const JsonField& json)
{
    Axis axis;
    axis.size = json.at("size").integer();
    const JsonField from = json.at("from");
    if (from.text() != kCosine && from.text() != kOneMinusCosine) from.fail("'1-cos' or 'cos'");
    axis.map.from = from.text() == kCosine ? AxisMap::From::cosine : AxisMap::From::oneMinusCosine;
    axis.map.exponent = json.at("exponent").number();
    return axis;
}

Domain domainFromJson(const JsonField& json)
{
    if (json.has("disc")) {
        const JsonField disc = json.at("disc");
        return DiscDomain{disc.at("size").integer(), disc.at("gamma").number(),
                          disc.at("radius").number()};
    }
    const JsonField grid = json.at("grid"), axes = grid.at("axes");
    GridDomain domain;
    if (axes.size() > 3) axes.fail("1 to 3 axes");
    for (size_t i = 0; i < axes.size(); ++i) domain.axes.push_back(axisFromJson(axes.at(i)));
    domain.symmetric = grid.at("symmetric").boolean();
    return domain;
}

Direction directionFromJson(const JsonField& json)
{
    if (json.has("norm")) {
        const JsonField weights = json.at("norm");
        if (weights.size() != 3) weights.fail("three weights, of wi, wo and n");
        const double weight_wi = weights.at(size_t{0}).number(), weight_wo = weights.at(1).number();
        return Direction::combination(weight_wo, weight_wi, weights.at(2).number());
    }
    for (const Direction& direction : kNamedDirections)
        if (json.text() == directionName(direction)) return direction;
    json.fail("'wi', 'wo', 'h', 'd', 'mirror' or {'norm': [weights of wi, wo, n]}");
}

Angle angleFromName(const JsonField& json)
{
    for (int i = 0; i < kAngleCount; ++i)
        if (json.text() == angleName(static_cast<Angle>(i))) return static_cast<Angle>(i);
    json.fail("'theta_h', 'theta_d', 'theta_i', 'theta_o', 'phi_d', 'half_phi_d' or 'side_phi_d'");
}

Argument argumentFromJson(const JsonField& json, bool direction)
{
    if (direction) return directionFromJson(json);
    std::vector<Angle> angles;
    for (size_t i = 0; i < json.size(); ++i) angles.push_back(angleFromName(json.at(i)));
    return angles;
}

Factor factorFromJson(const JsonField& json, const Form& form)
{
    Factor factor;
    const JsonField table = json.at("table");
    factor.table = table.integer();
    if (factor.table < 0 || factor.table >= static_cast<int>(form.tables.size()))
        table.fail("an index below " + std::to_string(form.tables.size()));
    // A string could be a direction or an angle; the domain of the table decides.
    const bool disc = isDisc(form.tables[static_cast<size_t>(factor.table)].domain);
    factor.argument = argumentFromJson(json.at("argument"), disc);
    return factor;
}

TableSpec tableFromJson(const JsonField& json)
{
    TableSpec spec;
    spec.name = json.at("name").text();
    spec.domain = domainFromJson(json.at("domain"));
    spec.uniform = json.has("uniform") && json.at("uniform").boolean();
    return spec;
}

}  // namespace

void JsonField::fail(const std::string& expected) const
{
    throw Error(ErrorKind::input, where_, Found(summary(*value_)).expected(expected));
}

JsonField JsonField::at(const char* key) const
{
    if (!has(key)) fail(std::string("an object with '") + key + "'");
    return {(*value_)[key], where_ + "/" + key};
}

JsonField JsonField::at(size_t index) const
{
    if (index >= size()) fail("more than " + std::to_string(index) + " elements");
    return {(*value_)[index], where_ + "/" + std::to_string(index)};
}

size_t JsonField::size() const
{
    if (!value_->is_array()) fail("an array");
    return value_->size();
}

int JsonField::integer() const
{
    // As double any JSON integer, signed or not, is in the range of int or plainly out of it.
    if (!value_->is_number_integer() || std::abs(value_->get<double>()) > INT_MAX)
        fail("an integer");
    return value_->get<int>();
}

double JsonField::number() const
{
    if (!value_->is_number() || !std::isfinite(value_->get<double>())) fail("a finite number");
    return value_->get<double>();
}

bool JsonField::boolean() const
{
    if (!value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
}

std::string JsonField::text() const
{
    if (!value_->is_string()) fail("a string");
    return value_->get<std::string>();
}

const Json& JsonField::object() const
{
    if (!value_->is_object()) fail("an object");
    return *value_;
}

Json parseJson(const std::string& text, const std::string& where)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        // The parser's own sentence quotes the text around the byte, which may be anything.
        throw Error(ErrorKind::input, where + ": byte " + std::to_string(error.byte),
                    Found("text that is not JSON").expected("JSON"));
    } catch (const Json::exception& error) {
        throw Error(ErrorKind::input, where,
                    Found(std::string("JSON with ") + error.what()).expected("plain JSON"));
    }
}

Json jsonFromForm(const Form& form)
{
    Json tables = Json::array(), terms = Json::array();
    for (const TableSpec& spec : form.tables)
        tables.push_back({{"name", spec.name},
                          {"uniform", spec.uniform},
                          {"domain", jsonFromDomain(spec.domain)}});
    for (const Term& term : form.terms) {
        Json factors = Json::array();
        for (const Factor& factor : term.factors)
            factors.push_back(
                {{"table", factor.table}, {"argument", jsonFromArgument(factor.argument)}});
        terms.push_back(factors);
    }
    return {{"name", form.name}, {"tables", tables}, {"terms", terms}};
}

Form formFromJson(const JsonField& json)
{
    Form form;
    form.name = json.at("name").text();
    const JsonField tables = json.at("tables"), terms = json.at("terms");
    // Factors refer to tables by index, so tables are read first.
    if (tables.size() == 0) tables.fail("at least one table");
    for (size_t i = 0; i < tables.size(); ++i) form.tables.push_back(tableFromJson(tables.at(i)));
    for (size_t t = 0; t < terms.size(); ++t) {
        const JsonField factors = terms.at(t);
        Term term;
        for (size_t k = 0; k < factors.size(); ++k)
            term.factors.push_back(factorFromJson(factors.at(k), form));
        form.terms.push_back(term);
    }
    // The JSON has the right types by now; sizes and exponents are judged as those of any form.
    validate(form, json.where());
    return form;
}

}  // namespace fbrdf
