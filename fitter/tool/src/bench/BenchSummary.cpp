#include "bench/BenchSummary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::tool {
namespace {

constexpr char kPicture[] = "psnr_linear", kSamples[] = "log_median", kItp[] = "delta_e_itp";

struct Value {
    double value;
    const std::string* material;
};

// Sorts the worst first.
ErrorSpread spreadOf(std::vector<Value> values, bool larger)
{
    std::stable_sort(values.begin(), values.end(), [larger](const Value& a, const Value& b) {
        return larger ? a.value < b.value : a.value > b.value;
    });
    ErrorSpread spread;
    for (const Value& v : values) spread.mean += v.value / static_cast<double>(values.size());
    // Percentiles are interpolated between neighbouring ranks, as usual.
    const double rank = 0.1 * static_cast<double>(values.size() - 1);
    const auto lower = static_cast<size_t>(rank), upper = std::min(lower + 1, values.size() - 1);
    const double blend = rank - static_cast<double>(lower);
    spread.tenth = values[lower].value * (1.0 - blend) + values[upper].value * blend;
    spread.worst = values[0].value;
    spread.worstMaterial = *values[0].material;
    return spread;
}

ContenderSummary summaryOf(const Contender& contender, const std::vector<MaterialScores>& materials)
{
    ContenderSummary summary;
    summary.contender = contender;
    std::map<std::string, std::vector<Value>> values;
    double belowOne = 0.0;
    for (const MaterialScores& material : materials)
        for (const Score& score : material.scores) {
            if (!sameContender(score.contender, contender)) continue;
            ++summary.materials;
            summary.bytes += static_cast<double>(score.bytes);
            summary.lookups += score.lookups;
            summary.seconds += score.seconds;
            for (const auto& [name, value] : score.errors)
                values[name].push_back({value, &material.name});
            const auto itp = score.errors.find(kItp);
            if (itp != score.errors.end() && itp->second < 1.0) belowOne += 1.0;
        }
    const auto n = static_cast<double>(std::max<size_t>(1, summary.materials));
    summary.bytes /= n;
    summary.lookups /= n;
    summary.seconds /= n;
    summary.belowOneItp = belowOne / n;
    for (auto& [name, list] : values)
        summary.errors[name] = spreadOf(std::move(list), largerIsBetter(name));
    return summary;
}

struct Best {
    const Score* score = nullptr;
    double value = 0;
};

Best bestOf(const MaterialScores& material, bool ours, const std::string& error)
{
    const bool larger = largerIsBetter(error);
    Best best;
    for (const Score& score : material.scores) {
        const auto found = score.errors.find(error);
        if (score.contender.ours != ours || found == score.errors.end()) continue;
        const double value = found->second;
        if (!best.score || (larger ? value > best.value : value < best.value))
            best = {&score, value};
    }
    return best;
}

}  // namespace

bool largerIsBetter(const std::string& error)
{
    return error == kPicture || error == "psnr_srgb" || error == "ssim";
}

std::vector<ContenderSummary> summarise(const std::vector<MaterialScores>& materials)
{
    std::vector<Contender> order;
    for (const MaterialScores& material : materials)
        for (const Score& score : material.scores)
            if (std::none_of(order.begin(), order.end(), [&](const Contender& known) {
                    return sameContender(known, score.contender);
                }))
                order.push_back(score.contender);
    std::stable_sort(order.begin(), order.end(),
                     [](const Contender& a, const Contender& b) { return a.ours > b.ours; });
    std::vector<ContenderSummary> summaries;
    for (const Contender& contender : order) summaries.push_back(summaryOf(contender, materials));
    return summaries;
}

AheadOfPeers aheadOfPeers(const std::vector<MaterialScores>& materials)
{
    AheadOfPeers result;
    for (const MaterialScores& material : materials) {
        const bool picture = bestOf(material, true, kPicture).score != nullptr;
        const std::string error = picture ? kPicture : kSamples;
        const Best ours = bestOf(material, true, error), peer = bestOf(material, false, error);
        if (!ours.score || !peer.score) continue;
        ++result.of;
        if (largerIsBetter(error) ? ours.value > peer.value : ours.value < peer.value)
            ++result.ahead;
        else
            result.behind.push_back(fmt::format("{} ({} {:.4g}, ours {:.4g})", material.name,
                                                peer.score->contender.label, peer.value,
                                                ours.value));
    }
    return result;
}

}  // namespace fbrdf::tool
