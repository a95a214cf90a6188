#include <fbrdf/scene/Stats.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson textOrNull(const std::string& text)
{
    return text.empty() ? OrderedJson(nullptr) : OrderedJson(text);
}

}  // namespace

Spread spreadOf(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {median, values.front(), values.back()};
}

namespace {

OrderedJson environmentJson(const Stats& stats)
{
    if (stats.environment.empty()) return nullptr;
    return {{"name", stats.environment},
            {"note", textOrNull(stats.environmentNote)},
            {"error", stats.environmentError},
            {"why_not", textOrNull(stats.whyNoEnvironment)},
            {"why_not_sampled", textOrNull(stats.whyNotSampled)}};
}

std::string textOf(const OrderedJson& json)
{
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

OrderedJson sideJson(const CompareSideStats& side)
{
    return {{"name", side.name},   {"technique", side.technique}, {"note", textOrNull(side.note)},
            {"bytes", side.bytes}, {"samples", side.samples},     {"fit_seconds", side.fitSeconds}};
}

OrderedJson finiteOrNull(double number)
{
    return std::isfinite(number) ? OrderedJson(number) : OrderedJson(nullptr);
}

OrderedJson compareJson(const CompareStats& stats)
{
    const CompareNumbers& n = stats.numbers;
    return {{"a", sideJson(stats.a)},
            {"b", sideJson(stats.b)},
            {"mode", stats.mode},
            {"pixels", n.pixels},
            {"psnr_linear", finiteOrNull(n.psnrLinear)},
            {"psnr_srgb", finiteOrNull(n.psnrSrgb)},
            {"ssim", n.ssim},
            {"delta_e_itp", n.deltaEItp},
            {"flip", n.flip},
            {"largest", n.largest}};
}

OrderedJson pathJson(const Stats& stats)
{
    if (!stats.path) return nullptr;
    return {{"samples", stats.path->samples},
            {"bounces", stats.path->bounces},
            {"noise", stats.path->noise}};
}

OrderedJson windowJson(const Stats& stats)
{
    if (!stats.window) return nullptr;
    const WindowStats& window = *stats.window;
    OrderedJson opened = OrderedJson::array();
    for (const OpenedStats& file : window.opened)
        opened.push_back({{"file", file.file},
                          {"seconds", file.seconds ? OrderedJson(*file.seconds) : nullptr},
                          {"why", textOrNull(file.why)}});
    return {{"first_picture_seconds", window.firstPictureSeconds},
            {"frames", window.frames},
            {"longest_frame", window.longestFrame},
            {"frames_while_fitting", window.framesWhileFitting},
            {"longest_while_fitting", window.longestWhileFitting},
            {"materials_made", window.materialsMade},
            {"made_while_held", window.madeWhileHeld},
            {"seconds_while_held", window.secondsWhileHeld},
            {"opened", opened}};
}

}  // namespace

std::string statsToJson(const Stats& stats)
{
    const Spread time = spreadOf(stats.milliseconds);
    const OrderedJson json{
        {"backend", stats.backend},
        {"gl_renderer", textOrNull(stats.glRenderer)},
        {"gl_version", textOrNull(stats.glVersion)},
        {"technique", stats.technique},
        {"look_up", textOrNull(stats.lookUp)},
        {"filter", textOrNull(stats.filter)},
        {"technique_drawn", textOrNull(stats.techniqueDrawn)},
        {"why_replaced", textOrNull(stats.whyReplaced)},
        {"error_bound", {{"relative", stats.errorRelative}, {"absolute", stats.errorAbsolute}}},
        {"environment", environmentJson(stats)},
        {"path", pathJson(stats)},
        {"compare", stats.compare ? compareJson(*stats.compare) : OrderedJson(nullptr)},
        {"mesh", stats.mesh},
        {"materials", stats.materials},
        {"window", windowJson(stats)},
        {"evaluated", stats.evaluated},
        {"size", {stats.width, stats.height}},
        {"samples", stats.samples},
        {"ground", stats.ground},
        {"shadows", stats.shadows},
        {"covered_pixels", stats.coveredPixels},
        {"passes", stats.passes},
        {"draw_calls", stats.drawCalls},
        {"lights",
         {{"given", stats.lightsGiven},
          {"used", stats.lightsUsed},
          {"dropped", stats.lightsDropped}}},
        {"max_lookups", stats.maxLookups},
        {"accumulation", stats.accumulation},
        {"frames", stats.milliseconds.size()},
        {"clock", "cpu"},
        {"milliseconds", {{"median", time.median}, {"min", time.min}, {"max", time.max}}},
    };
    return textOf(json);
}

std::string compareToJson(const std::vector<CompareStats>& stats)
{
    OrderedJson all = OrderedJson::array();
    for (const CompareStats& one : stats) all.push_back(compareJson(one));
    return textOf(all);
}

}  // namespace fbrdf::scene
