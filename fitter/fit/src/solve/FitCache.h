// FitCache.h - what fits to data on the same grid share: rows and factorizations depend on the
// pairs of directions and the form, not on the values.
#pragma once
#include "solve/RowStore.h"
#include "solve/SmoothSystem.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace fbrdf {

/// Systems of one grid and one form, with equal weights of all samples.
struct GridSystems {
    Layout layout;
    Smoothness smoothness;
    Workspace workspace;
    std::vector<std::unique_ptr<SmoothSystem>> systems;

    /// One system for each of the sums.
    GridSystems(const Form& form, const std::vector<NormalSums>& sums);
};

/// Safe to use from threads. Keeps what was used last.
class FitCache {
public:
    std::shared_ptr<const RowGeometries> rows(const std::string& key);
    void keepRows(const std::string& key, std::shared_ptr<const RowGeometries> rows);
    std::shared_ptr<const GridSystems> systems(const std::string& key);
    void keepSystems(const std::string& key, std::shared_ptr<const GridSystems> systems);
    /// The texelWeights of samples of equal weight.
    std::shared_ptr<const std::vector<double>> texelWeights(const std::string& key);
    void keepTexelWeights(const std::string& key,
                          std::shared_ptr<const std::vector<double>> weights);

private:
    template <class Value>
    struct Shelf {
        std::map<std::string, std::pair<uint64_t, std::shared_ptr<const Value>>> values;
        std::shared_ptr<const Value> find(const std::string& key, uint64_t now);
        void keep(const std::string& key, std::shared_ptr<const Value> value, uint64_t now,
                  size_t most);
    };

    std::mutex mutex_;
    Shelf<RowGeometries> rows_;
    Shelf<GridSystems> systems_;
    Shelf<std::vector<double>> texelWeights_;
    uint64_t clock_ = 0;
};

}  // namespace fbrdf
