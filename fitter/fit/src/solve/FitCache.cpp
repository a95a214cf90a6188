#include "solve/FitCache.h"

#include <fbrdf/fit/Fit.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kMostRows = 2;      // 130 MB each for a grid of 1.5 million samples and hdio
constexpr size_t kMostSystems = 12;  // 20 MB each

}  // namespace

GridSystems::GridSystems(const Form& form, const std::vector<NormalSums>& sums)
    : layout(form), smoothness(form, layout)
{
    for (const NormalSums& sum : sums) {
        systems.push_back(
            std::make_unique<SmoothSystem>(sum.matrix(0, workspace), smoothness, workspace));
        systems.back()->keepFactors();
    }
}

template <class Value>
std::shared_ptr<const Value> FitCache::Shelf<Value>::find(const std::string& key, uint64_t now)
{
    const auto found = values.find(key);
    if (found == values.end()) return nullptr;
    found->second.first = now;
    return found->second.second;
}

// Takes the place of what was used longest ago.
template <class Value>
void FitCache::Shelf<Value>::keep(const std::string& key, std::shared_ptr<const Value> value,
                                  uint64_t now, size_t most)
{
    if (values.count(key) == 0 && values.size() >= most)
        values.erase(std::min_element(
            values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.second.first < b.second.first; }));
    values[key] = {now, std::move(value)};
}

std::shared_ptr<FitCache> makeFitCache()
{
    return std::make_shared<FitCache>();
}

std::shared_ptr<const RowGeometries> FitCache::rows(const std::string& key)
{
    const std::lock_guard lock(mutex_);
    return rows_.find(key, ++clock_);
}

void FitCache::keepRows(const std::string& key, std::shared_ptr<const RowGeometries> rows)
{
    const std::lock_guard lock(mutex_);
    rows_.keep(key, std::move(rows), ++clock_, kMostRows);
}

std::shared_ptr<const GridSystems> FitCache::systems(const std::string& key)
{
    const std::lock_guard lock(mutex_);
    return systems_.find(key, ++clock_);
}

void FitCache::keepSystems(const std::string& key, std::shared_ptr<const GridSystems> systems)
{
    const std::lock_guard lock(mutex_);
    systems_.keep(key, std::move(systems), ++clock_, kMostSystems);
}

std::shared_ptr<const std::vector<double>> FitCache::texelWeights(const std::string& key)
{
    const std::lock_guard lock(mutex_);
    return texelWeights_.find(key, ++clock_);
}

void FitCache::keepTexelWeights(const std::string& key,
                                std::shared_ptr<const std::vector<double>> weights)
{
    const std::lock_guard lock(mutex_);
    texelWeights_.keep(key, std::move(weights), ++clock_, kMostSystems);
}

}  // namespace fbrdf
