#include "bench/Print.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace fbrdf::bench {
namespace {

using Json = nlohmann::ordered_json;

/// The names of all variants that occur in a table of the mesh, in order.
std::vector<std::string> variantsOf(const std::vector<const Table*>& tables)
{
    std::vector<std::string> names;
    for (const Table* table : tables)
        for (const Timing& timing : table->timings)
            if (std::find(names.begin(), names.end(), timing.variant) == names.end())
                names.push_back(timing.variant);
    return names;
}

std::string cell(const Table& table, const std::string& variant)
{
    for (const Timing& timing : table.timings)
        if (timing.variant == variant)
            return timing.ratio > 0.0
                       ? fmt::format("{:>9.2f} {:>6.2f}", timing.milliseconds, timing.ratio)
                       : fmt::format("{:>9.2f} {:>6}", timing.milliseconds, "");
    return fmt::format("{:>9} {:>6}", "-", "");
}

/// Of the most lights that it was timed with.
std::string costCell(const std::vector<const Table*>& tables, const std::string& variant)
{
    LightCost cost;
    for (const Table* table : tables)
        for (const Timing& timing : table->timings)
            if (timing.variant == variant) cost = timing.cost;
    return fmt::format("{:>7.1f} {:>7.1f} {:>7.1f}", cost.multiplyAdds, cost.specials, cost.bytes);
}

std::string meshText(const std::vector<const Table*>& tables)
{
    const std::vector<std::string> variants = variantsOf(tables);
    size_t width = std::size("lights");
    for (const std::string& variant : variants) width = std::max(width, variant.size() + 1);
    std::string text = fmt::format(
        "\n{}: ms a frame, and ratio to ggx, after multiply-adds, special functions and "
        "bytes of texels for a pixel and light\n{:<{}}{:>7} {:>7} {:>7}",
        tables.front()->mesh, "lights", width, "MACs", "special", "bytes");
    for (const Table* table : tables) text += fmt::format("{:>9} {:>6}", table->lights, "");
    text += "\n";
    for (const std::string& variant : variants) {
        text += fmt::format("{:<{}}", variant, width) + costCell(tables, variant);
        for (const Table* table : tables) text += cell(*table, variant);
        text += "\n";
    }
    for (const Table* table : tables)
        for (const LeftOut& out : table->leftOut)
            text += fmt::format("left out: {} with {} lights ({})\n", out.variant, table->lights,
                                out.reason);
    return text;
}

}  // namespace

const char* clockName(Options::Clock clock)
{
    switch (clock) {
        case Options::Clock::wall: return "wall";
        case Options::Clock::cpu: return "cpu";
        case Options::Clock::gpu: return "gpu";
    }
    return "?";
}

std::string asText(const Measurement& measurement)
{
    std::string text = fmt::format("{}, OpenGL {}, {}x{} pixels, {} time\n", measurement.glRenderer,
                                   measurement.glVersion, measurement.width, measurement.height,
                                   clockName(measurement.clock));
    std::vector<const Table*> tables;
    for (size_t i = 0; i < measurement.tables.size(); ++i) {
        tables.push_back(&measurement.tables[i]);
        const bool isLast = i + 1 == measurement.tables.size() ||
                            measurement.tables[i + 1].mesh != tables.front()->mesh;
        if (!isLast) continue;
        text += meshText(tables);
        tables.clear();
    }
    return text;
}

std::string asJson(const Measurement& measurement)
{
    Json results = Json::array(), leftOut = Json::array();
    for (const Table& table : measurement.tables) {
        for (const Timing& t : table.timings)
            results.push_back({{"mesh", table.mesh},
                               {"lights", table.lights},
                               {"variant", t.variant},
                               {"milliseconds", t.milliseconds},
                               {"ratio", t.ratio > 0.0 ? Json(t.ratio) : Json()},
                               {"frames", t.frames},
                               {"multiply_adds", t.cost.multiplyAdds},
                               {"specials", t.cost.specials},
                               {"bytes", t.cost.bytes}});
        for (const LeftOut& out : table.leftOut)
            leftOut.push_back({{"mesh", table.mesh},
                               {"lights", table.lights},
                               {"variant", out.variant},
                               {"reason", out.reason}});
    }
    return Json{{"renderer", measurement.glRenderer},
                {"version", measurement.glVersion},
                {"size", {measurement.width, measurement.height}},
                {"clock", clockName(measurement.clock)},
                {"results", results},
                {"left_out", leftOut}}
               .dump(2) +
           "\n";
}

}  // namespace fbrdf::bench
