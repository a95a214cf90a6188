#include "Errors.h"

#include <fbrdf/base/Text.h>

#include "TextTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::tool {
namespace {

struct Metric {
    const char* name;
    const char* meaning;
};

// f is the reference, g its approximation, c = cos theta_i (docs/method.md, section Errors).
constexpr Metric kMetrics[] = {
    {"log_rms", "rms of ln g/f"},
    {"log_median", "median of |ln g/f|"},
    {"log_median_r", "the same, red"},
    {"log_median_g", "the same, green"},
    {"log_median_b", "the same, blue"},
    {"cos_rms", "rms of c (g - f), relative"},
    {"cuberoot_rms", "rms of difference of cube roots of c f, relative"},
    {"nbrdf_loss", "mean difference of ln(1 + c f)"},
    {"psnr_linear", "dB, standard sphere, linear"},
    {"psnr_srgb", "dB, standard sphere, sRGB"},
    {"ssim", "structural similarity, standard sphere"},
    {"delta_e_itp", "mean colour difference, standard sphere"},
    {"flip", "mean FLIP, standard sphere"},
    {"reciprocity", "median |ln f(a, b) / f(b, a)|"},
    {"albedo_max", "largest directional albedo"},
};

ErrorMap finite(const ErrorMap& errors)
{
    ErrorMap kept;
    for (const auto& [name, value] : errors)
        if (std::isfinite(value)) kept[name] = value;
    return kept;
}

bool isColourOfMedian(const std::string& name)
{
    return name == "log_median_r" || name == "log_median_g" || name == "log_median_b";
}

Json medianOf(const ErrorMap& errors)
{
    Json median = Json::array();
    for (const char* name : {"log_median_r", "log_median_g", "log_median_b"}) {
        const auto found = errors.find(name);
        median.push_back(found == errors.end() ? Json() : Json(found->second));
    }
    return median;
}

std::vector<std::string> tableRow(const Metric& metric, const std::vector<ErrorMap>& columns)
{
    std::vector<std::string> row{metric.name};
    for (const ErrorMap& errors : columns) {
        const auto found = errors.find(metric.name);
        row.push_back(found == errors.end() ? "-" : fmt::format("{:.4g}", found->second));
    }
    row.push_back(metric.meaning);
    return row;
}

}  // namespace

ErrorMap errorMap(const SampleErrors& errors)
{
    return finite(named(errors));
}

ErrorMap errorMap(const ImageErrors& errors)
{
    ErrorMap map = named(errors);
    for (const char* name : {"psnr_linear", "psnr_srgb"})
        if (map[name] > kIdenticalPsnr) map[name] = kIdenticalPsnr;
    return finite(map);
}

ErrorMap errorMap(const PhysicsErrors& errors)
{
    return finite(named(errors));
}

const std::vector<std::string>& errorNames()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Metric& metric : kMetrics) all.push_back(metric.name);
        return all;
    }();
    return names;
}

Json jsonOf(const ErrorMap& errors)
{
    Json json = Json::object();
    for (const Metric& metric : kMetrics) {
        const auto found = errors.find(metric.name);
        if (found == errors.end()) continue;
        if (isColourOfMedian(metric.name))
            json["log_median_rgb"] = medianOf(errors);
        else
            json[metric.name] = found->second;
    }
    return json;
}

Json jsonOf(double number)
{
    return std::isfinite(number) ? Json(number) : Json();
}

Json jsonOf(const Vec3f& colour)
{
    Json json = Json::array();
    for (int c = 0; c < 3; ++c) {  // 0.1f as 0.1, not as 0.10000000149011612
        double shortest = 0.0;
        parseNumber(fmt::format("{}", colour[c]), shortest);
        json.push_back(jsonOf(shortest));
    }
    return json;
}

Json jsonOf(const Vec3d& colour)
{
    return Json::array({jsonOf(colour.x), jsonOf(colour.y), jsonOf(colour.z)});
}

std::string text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string errorTable(const std::vector<ErrorMap>& columns, const std::vector<std::string>& titles)
{
    std::vector<std::vector<std::string>> rows;
    if (!titles.empty()) {
        rows.push_back({""});
        rows.back().insert(rows.back().end(), titles.begin(), titles.end());
    }
    for (const Metric& metric : kMetrics)
        if (std::any_of(columns.begin(), columns.end(),
                        [&](const ErrorMap& errors) { return errors.count(metric.name) > 0; }))
            rows.push_back(tableRow(metric, columns));
    std::vector<Align> align(columns.size() + 2, Align::right);
    align.front() = align.back() = Align::left;
    return alignedTable(align, rows, 4);
}

}  // namespace fbrdf::tool
