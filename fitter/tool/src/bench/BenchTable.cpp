// BenchTable.cpp - the scores of BenchSummary.h as text and as JSON.
#include "bench/BenchSummary.h"
#include "TextTable.h"

#include <fmt/format.h>

namespace fbrdf::tool {
namespace {

constexpr size_t kFewMaterials = 8;  // up to which each has a table of its own

struct Column {
    const char* error;
    const char* title;
    const char* format;
};
constexpr Column kColumns[] = {
    {"psnr_linear", "PSNR", "{:.2f}"},      {"ssim", "SSIM", "{:.4f}"},
    {"delta_e_itp", "dE ITP", "{:.2f}"},    {"flip", "FLIP", "{:.4f}"},
    {"log_median", "log median", "{:.4f}"}, {"log_rms", "log rms", "{:.4f}"},
    {"cos_rms", "cos rms", "{:.4f}"},
};

using Rows = std::vector<std::vector<std::string>>;

std::string cell(const ErrorMap& errors, const Column& column)
{
    const auto found = errors.find(column.error);
    return found == errors.end() ? "-" : fmt::format(fmt::runtime(column.format), found->second);
}

std::vector<Align> alignmentOf(size_t columns)
{
    std::vector<Align> align(columns, Align::right);
    align.front() = Align::left;
    return align;
}

std::string materialText(const MaterialScores& material)
{
    if (!material.error.empty()) return material.name + ": " + material.error + "\n";
    Rows rows{{"", "bytes", "look-ups", "seconds"}};
    for (const Column& column : kColumns) rows[0].push_back(column.title);
    for (const Score& score : material.scores) {
        rows.push_back({(score.contender.ours ? "" : "peer ") + score.contender.label,
                        withSeparators(score.bytes), fmt::format("{}", score.lookups),
                        fmt::format("{:.2f}", score.seconds)});
        for (const Column& column : kColumns) rows.back().push_back(cell(score.errors, column));
    }
    return material.name + "\n" + alignedTable(alignmentOf(rows[0].size()), rows);
}

std::string spreadText(const ContenderSummary& summary, const Column& column, bool worstToo)
{
    const auto found = summary.errors.find(column.error);
    if (found == summary.errors.end()) return "-";
    const auto number = [&](double value) {
        return fmt::format(fmt::runtime(column.format), value);
    };
    std::string text = number(found->second.mean);
    if (worstToo) text += " / " + number(found->second.tenth) + " / " + number(found->second.worst);
    return text;
}

std::string summaryText(const std::vector<ContenderSummary>& summaries)
{
    Rows rows{{"", "materials", "bytes", "look-ups", "seconds"}};
    for (const Column& column : kColumns) rows[0].push_back(column.title);
    rows[0].push_back("dE < 1");
    rows[0].push_back("worst");
    for (const ContenderSummary& summary : summaries) {
        rows.push_back({(summary.contender.ours ? "" : "peer ") + summary.contender.label,
                        fmt::format("{}", summary.materials), fmt::format("{:.0f}", summary.bytes),
                        fmt::format("{:.1f}", summary.lookups),
                        fmt::format("{:.2f}", summary.seconds)});
        for (const Column& column : kColumns)
            rows.back().push_back(spreadText(summary, column, &column == kColumns));
        const bool picture = summary.errors.count(kColumns[0].error) > 0;
        const auto key = summary.errors.find(picture ? kColumns[0].error : "log_median");
        rows.back().push_back(picture ? fmt::format("{:.0f} %", 100.0 * summary.belowOneItp) : "-");
        rows.back().push_back(key == summary.errors.end() ? "-" : key->second.worstMaterial);
    }
    return "means over materials; PSNR also tenth percentile and worst\n" +
           alignedTable(alignmentOf(rows[0].size()), rows);
}

std::string aheadText(const AheadOfPeers& ahead)
{
    if (ahead.of == 0) return "";
    std::string text =
        fmt::format("ahead of every peer on {} of {} materials ({:.1f} %)\n", ahead.ahead, ahead.of,
                    100.0 * static_cast<double>(ahead.ahead) / static_cast<double>(ahead.of));
    for (const std::string& line : ahead.behind) text += "  behind on " + line + "\n";
    return text;
}

Json scoreJson(const Score& score)
{
    return {{"name", score.contender.label},
            {"peer", !score.contender.ours},
            {"bytes", score.bytes},
            {"lookups", score.lookups},
            {"seconds", jsonOf(score.seconds)},
            {"errors", jsonOf(score.errors)},
            {"note", score.note}};
}

Json materialJson(const MaterialScores& material)
{
    Json scores = Json::array();
    for (const Score& score : material.scores) scores.push_back(scoreJson(score));
    Json json = {{"name", material.name}, {"source", material.source}, {"scores", scores}};
    if (!material.error.empty()) json["error"] = material.error;
    return json;
}

Json summaryJson(const ContenderSummary& summary)
{
    Json errors = Json::object();
    for (const std::string& name : errorNames()) {
        const auto found = summary.errors.find(name);
        if (found == summary.errors.end()) continue;
        errors[name] = {{"mean", found->second.mean},
                        {"tenth_percentile", found->second.tenth},
                        {"worst", found->second.worst},
                        {"worst_material", found->second.worstMaterial}};
    }
    return {{"name", summary.contender.label},
            {"peer", !summary.contender.ours},
            {"materials", summary.materials},
            {"bytes", summary.bytes},
            {"lookups", summary.lookups},
            {"seconds", summary.seconds},
            {"errors", errors},
            {"delta_e_itp_below_1", summary.belowOneItp}};
}

}  // namespace

std::string benchText(const std::vector<MaterialScores>& materials)
{
    std::string text;
    for (const MaterialScores& material : materials)
        if (materials.size() <= kFewMaterials || !material.error.empty())
            text += materialText(material);
    if (materials.size() > 1) text += summaryText(summarise(materials));
    return text + aheadText(aheadOfPeers(materials));
}

Json benchJson(const std::vector<MaterialScores>& materials)
{
    Json each = Json::array(), summary = Json::array();
    for (const MaterialScores& material : materials) each.push_back(materialJson(material));
    for (const ContenderSummary& s : summarise(materials)) summary.push_back(summaryJson(s));
    const AheadOfPeers ahead = aheadOfPeers(materials);
    return {{"summary", summary},
            {"ahead_of_every_peer",
             {{"materials", ahead.ahead}, {"of", ahead.of}, {"behind", ahead.behind}}},
            {"materials", each}};
}

}  // namespace fbrdf::tool
