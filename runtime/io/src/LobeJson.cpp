#include "LobeJson.h"

namespace fbrdf {
namespace {

constexpr char kTilted[] = "tilted", kBent[] = "bent";
constexpr int kMostKnotsAlong = 1024;  // as validate has it, before anything is multiplied

/// Numbers of a knot: the cosine, then each lobe; bent lobes share one level.
size_t numbersPerKnot(const LobeTable& table)
{
    const auto lobes = static_cast<size_t>(table.lobes);
    return table.axes == LobeAxes::tilted ? 3 + 5 * lobes : 4 + 3 * lobes;
}

LobeKnot knotFrom(const LobeTable& table, const float* at)
{
    LobeKnot knot;
    knot.cosine = {at[0], at[1], at[2]};
    at += 3;
    const float common = table.axes == LobeAxes::bent ? *at++ : 0.0f;
    for (size_t k = 0; k < static_cast<size_t>(table.lobes); ++k) {
        Lobe& lobe = knot.lobes[k];
        lobe.weight = {at[0], at[1], at[2]};
        at += 3;
        lobe.level = common;
        if (table.axes == LobeAxes::bent) continue;
        lobe.level = *at++;
        lobe.tilt = *at++;
    }
    return knot;
}

}  // namespace

Json jsonFromLobes(const LobeTable& lobes)
{
    Json json;
    const bool isBent = lobes.axes == LobeAxes::bent;
    json["axes"] = isBent ? kBent : kTilted;
    json["lobes"] = lobes.lobes;
    json["thetas"] = lobes.thetas;
    json["azimuths"] = lobes.azimuths;
    if (isBent) {
        json["spread"] = lobes.spread;
        json["across"] = lobes.acrossTangent;
    }
    json["error"] = lobes.error;
    if (!lobes.fewerErrors.empty()) json["fewer_errors"] = lobes.fewerErrors;
    return json;
}

std::vector<float> lobeNumbers(const LobeTable& lobes)
{
    std::vector<float> numbers;
    const auto add = [&](const Vec3f& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
    for (const LobeKnot& knot : lobes.knots) {
        add(knot.cosine);
        if (lobes.axes == LobeAxes::bent) numbers.push_back(knot.lobes[0].level);
        for (size_t k = 0; k < static_cast<size_t>(lobes.lobes); ++k) {
            add(knot.lobes[k].weight);
            if (lobes.axes == LobeAxes::bent) continue;
            numbers.push_back(knot.lobes[k].level);
            numbers.push_back(knot.lobes[k].tilt);
        }
    }
    return numbers;
}

LobeTable lobesFromJson(const JsonField& json, const std::vector<float>& numbers)
{
    LobeTable table;
    const JsonField axes = json.at("axes");
    if (axes.text() != kTilted && axes.text() != kBent) axes.fail("'tilted' or 'bent'");
    table.axes = axes.text() == kBent ? LobeAxes::bent : LobeAxes::tilted;
    const auto count = [&](const char* name, int most) {
        const JsonField field = json.at(name);
        const int value = field.integer();
        if (value < 1 || value > most) field.fail("1 to " + std::to_string(most));
        return value;
    };
    table.lobes = count("lobes", kMostLobes);
    table.thetas = count("thetas", kMostKnotsAlong);
    table.azimuths = count("azimuths", kMostKnotsAlong);
    if (table.axes == LobeAxes::bent) {
        table.spread = static_cast<float>(json.at("spread").number());
        table.acrossTangent = json.at("across").boolean();
    }
    table.error = json.at("error").number();
    if (json.has("fewer_errors")) {
        const JsonField errors = json.at("fewer_errors");
        for (size_t i = 0; i < errors.size(); ++i)
            table.fewerErrors.push_back(errors.at(i).number());
    }
    const size_t each = numbersPerKnot(table);
    const auto knots = static_cast<size_t>(table.thetas) * static_cast<size_t>(table.azimuths);
    if (numbers.size() != knots * each)
        json.fail(std::to_string(knots * each) + " numbers of knots, not " +
                  std::to_string(numbers.size()));
    for (size_t i = 0; i < knots; ++i) table.knots.push_back(knotFrom(table, &numbers[i * each]));
    validate(table, json.where());
    return table;
}

}  // namespace fbrdf
