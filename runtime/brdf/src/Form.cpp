#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/Form.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Bounds on what a file may ask for; far above any useful table, far below what exhausts memory.
constexpr int kMaxSize = 4096;
constexpr int kMaxTables = 64;
constexpr double kMaxWeight = 1e3;

constexpr bool isInOrder()
{
    for (size_t i = 0; i < kAngles.size(); ++i)
        if (kAngles[i].angle != static_cast<Angle>(i)) return false;
    return true;
}
static_assert(isInOrder(), "angleInfo indexes the rows by enumerator");

bool directionDependsOnLight(const Direction& direction)
{
    switch (direction.kind) {
        case Direction::Kind::combination: return direction.weight_wi != 0.0;
        case Direction::Kind::difference: return true;
        case Direction::Kind::mirror: return false;
    }
    return true;
}

void validateAxis(const Axis& axis, const std::string& where)
{
    if (axis.size < 1 || axis.size > kMaxSize)
        throw Error(ErrorKind::input, where,
                    Found("axis of " + std::to_string(axis.size) + " knots")
                        .expected("1 to " + std::to_string(kMaxSize)));
    if (!(axis.map.exponent > 0.0) || !(axis.map.exponent <= 16.0))
        throw Error(ErrorKind::input, where,
                    Found("axis exponent " + numberText(axis.map.exponent))
                        .expected("above 0 and at most 16"));
}

void validateDomain(const TableSpec& spec, const std::string& where)
{
    if (const auto* disc = std::get_if<DiscDomain>(&spec.domain)) {
        if (disc->size < 2 || disc->size > kMaxSize)
            throw Error(ErrorKind::input, where,
                        Found("disc map of " + std::to_string(disc->size) + " texels")
                            .expected("2 to " + std::to_string(kMaxSize)));
        if (!(disc->gamma > 0.0) || !(disc->gamma <= 16.0))
            throw Error(
                ErrorKind::input, where,
                Found("gamma " + numberText(disc->gamma)).expected("above 0 and at most 16"));
        if (!(disc->radius > 0.0) || !(disc->radius <= 0.5 * (disc->size - 1)))
            throw Error(ErrorKind::input, where,
                        Found("disc radius " + numberText(disc->radius))
                            .expected("at most half of size - 1"));
        if (spec.uniform)
            throw Error(ErrorKind::input, where,
                        Found("a uniform disc map").expected("one axis of at most 64 knots"));
        return;
    }
    const auto& grid = std::get<GridDomain>(spec.domain);
    if (grid.axes.empty() || grid.axes.size() > 3)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(grid.axes.size()) + " axes").expected("1 to 3"));
    double texels = 1.0;
    for (const Axis& axis : grid.axes) {
        validateAxis(axis, where);
        texels *= axis.size;
    }
    if (texels > double(kMaxSize) * kMaxSize)
        throw Error(ErrorKind::input, where,
                    Found(numberText(texels) + " texels").expected("at most 2^24"));
    if (grid.symmetric && (grid.axes.size() != 2 || grid.axes[0].size != grid.axes[1].size ||
                           grid.axes[0].map.from != grid.axes[1].map.from ||
                           grid.axes[0].map.exponent != grid.axes[1].map.exponent))
        throw Error(ErrorKind::input, where,
                    Found("a symmetric table with unequal axes").expected("two equal axes"));
    if (spec.uniform && (grid.axes.size() != 1 || grid.axes[0].size > 64))
        throw Error(ErrorKind::input, where,
                    Found("a uniform table").expected("one axis of at most 64 knots"));
}

void validateDirection(const Direction& direction, const std::string& where)
{
    for (const double weight : {direction.weight_wo, direction.weight_wi, direction.weight_n})
        if (!(std::abs(weight) <= kMaxWeight))
            throw Error(ErrorKind::input, where,
                        Found("direction weight " + numberText(weight))
                            .expected("at most " + numberText(kMaxWeight) + " in magnitude"));
}

std::string describe(const Domain& domain)
{
    if (const auto* disc = std::get_if<DiscDomain>(&domain))
        return "[disc " + std::to_string(disc->size) + "x" + std::to_string(disc->size) +
               " gamma " + numberText(disc->gamma) + "]";
    std::string text = "[";
    const auto& grid = std::get<GridDomain>(domain);
    for (size_t i = 0; i < grid.axes.size(); ++i) {
        const AxisMap& map = grid.axes[i].map;
        text += (i ? " x " : "") + std::to_string(grid.axes[i].size) +
                (map.from == AxisMap::From::cosine ? " cos^" : " (1-cos)^") +
                numberText(map.exponent);
    }
    return text + (grid.symmetric ? " symmetric]" : "]");
}

std::string describe(const Argument& argument)
{
    if (const auto* direction = std::get_if<Direction>(&argument))
        return "(" + directionName(*direction) + ")";
    std::string text = "(";
    for (const Angle angle : std::get<std::vector<Angle>>(argument))
        text += (text.size() > 1 ? ", " : "") + std::string(angleName(angle));
    return text + ")";
}

}  // namespace

std::string directionName(const Direction& direction)
{
    if (direction == Direction::wi) return "wi";
    if (direction == Direction::wo) return "wo";
    if (direction == Direction::h) return "h";
    if (direction == Direction::d) return "d";
    if (direction == Direction::mirror) return "mirror";
    return "norm(" + numberText(direction.weight_wi) + " wi + " + numberText(direction.weight_wo) +
           " wo + " + numberText(direction.weight_n) + " n)";
}

const char* angleName(Angle angle)
{
    return angleInfo(angle).name;
}

bool dependsOnLight(const Factor& factor)
{
    if (const auto* direction = std::get_if<Direction>(&factor.argument))
        return directionDependsOnLight(*direction);
    const auto& angles = std::get<std::vector<Angle>>(factor.argument);
    return std::any_of(angles.begin(), angles.end(),
                       [](Angle a) { return angleInfo(a).dependsOnLight; });
}

bool isIsotropic(const Form& form)
{
    return std::none_of(form.tables.begin(), form.tables.end(),
                        [](const TableSpec& t) { return isDisc(t.domain); });
}

void validate(const Form& form, const std::string& where)
{
    if (form.tables.empty() || form.tables.size() > kMaxTables)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(form.tables.size()) + " tables")
                        .expected("1 to " + std::to_string(kMaxTables)));
    for (const TableSpec& spec : form.tables)
        validateDomain(spec, where + ": table '" + spec.name + "'");
    if (form.terms.empty() || form.terms.size() > kMaxTables)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(form.terms.size()) + " terms")
                        .expected("1 to " + std::to_string(kMaxTables)));
    for (const Term& term : form.terms) {
        if (term.factors.empty())
            throw Error(ErrorKind::input, where,
                        Found("a term without factors").expected("at least one"));
        if (term.factors.size() > kMaxTables)
            throw Error(ErrorKind::input, where,
                        Found("a term of " + std::to_string(term.factors.size()) + " factors")
                            .expected("at most " + std::to_string(kMaxTables)));
        for (const Factor& factor : term.factors) {
            if (factor.table < 0 || factor.table >= static_cast<int>(form.tables.size()))
                throw Error(ErrorKind::input, where,
                            Found("table index " + std::to_string(factor.table))
                                .expected("below " + std::to_string(form.tables.size())));
            const TableSpec& spec = form.tables[static_cast<size_t>(factor.table)];
            if (!argumentFits(spec.domain, factor.argument))
                throw Error(
                    ErrorKind::input, where,
                    Found("table '" + spec.name + "' looked up with " + describe(factor.argument))
                        .expected("one direction for a disc or one angle an axis"));
            if (const auto* direction = std::get_if<Direction>(&factor.argument))
                validateDirection(*direction, where + ": table '" + spec.name + "'");
        }
    }
}

std::string describe(const Form& form)
{
    std::string text;
    std::vector<bool> described(form.tables.size(), false);
    for (const Term& term : form.terms) {
        if (!text.empty()) text += "+ ";
        for (const Factor& factor : term.factors) {
            const auto index = static_cast<size_t>(factor.table);
            text += form.tables[index].name;
            if (!described[index]) text += describe(form.tables[index].domain);
            described[index] = true;
            text += describe(factor.argument) + " ";
        }
    }
    if (!text.empty()) text.pop_back();
    return text;
}

Form formPqp(int size, double gamma)
{
    const DiscDomain disc = DiscDomain::fitting(size, gamma);
    return {"pqp",
            {{"p", disc}, {"q", disc}},
            {{{{0, Direction::wo}, {1, Direction::h}, {0, Direction::wi}}}}};
}

Form formPqpr(int size, double gamma, int knots)
{
    Form form = formPqp(size, gamma);
    form.name = "pqpr";
    form.tables.push_back(
        {"r", GridDomain{{Axis{knots, {AxisMap::From::oneMinusCosine, 0.5}}}}, true});
    form.terms[0].factors.push_back({2, std::vector<Angle>{Angle::theta_d}});
    return form;
}

Form formHdio(const HdioSizes& sizes)
{
    const Axis h{sizes.h, {AxisMap::From::oneMinusCosine, 0.25}},
        d{sizes.d, {AxisMap::From::oneMinusCosine, 0.5}};
    // cos^(1/2): knots gather towards grazing, where shadowing varies fastest (a GGX metal of alpha
    // 0.02 gains 13 dB).
    const Axis io{sizes.io, {AxisMap::From::cosine, 0.5}};
    return {"hdio",
            {{"T1", GridDomain{{h, d}}}, {"T2", GridDomain{{io, io}, true}}},
            {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d}},
               {1, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}}}};
}

}  // namespace fbrdf
