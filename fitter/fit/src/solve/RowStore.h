// RowStore.h - the rows of a dataset, made once and kept where memory allows, else made again in
// every pass. The geometry of rows (which texels, how much of each) does not depend on the values,
// so fits to data on the same grid share it.
#pragma once
#include "data/Dataset.h"
#include "data/DataStatistics.h"
#include "solve/Rows.h"

#include <memory>
#include <vector>

namespace fbrdf {

/// Geometry of one block: `width` entries a row.
struct RowGeometry {
    uint64_t first = 0;  ///< number of the block's first row
    /// Row i has the number first + offsets[i]; empty: first + i. Rows that are kept stand in an
    /// order of their own where samples are scattered.
    std::vector<uint16_t> offsets;
    size_t count = 0;
    std::vector<int> unknown;   ///< count x width
    std::vector<float> weight;  ///< count x width
    std::vector<float> cosine;  ///< cos theta_i, count

    /// DatasetBlock::number of row i.
    uint64_t number(size_t i) const { return first + (offsets.empty() ? i : offsets[i]); }
};

/// Logarithms and weights of the samples of one block (see Observed), a channel at a time in Vec3f.
struct RowValues {
    std::vector<Vec3f> logValue, weight;
    std::vector<unsigned char> censored;  ///< bit c: channel c
    /// f, and the samples' own weights; empty unless the noise is unclipped.
    std::vector<Vec3f> value;
    std::vector<float> sampleWeight;
};

using RowGeometries = std::vector<RowGeometry>;

class RowStore {
public:
    /// `known`: geometry made before for a dataset of the same geometryOf and an equal form, or
    /// null. The references must outlive the store.
    RowStore(const RowMaker& maker, const Dataset& dataset, const DataStatistics& statistics,
             int threads, std::shared_ptr<const RowGeometries> known);

    size_t blocks() const { return dataset_.blocks(); }
    struct Scratch {
        DatasetScratch dataset;
        RowGeometry geometry;
        RowValues values;
    };
    struct Block {
        const RowGeometry& geometry;
        const RowValues& values;
    };
    /// Valid until the next call with the same scratch.
    Block block(size_t index, Scratch& scratch) const;
    /// No value of any channel is at or below the floor and all weigh as much as their sample: the
    /// matrix depends on the geometry alone. For rows that are not kept it is
    /// DataStatistics::sameWeights.
    bool sameWeights() const { return sameWeights_; }
    /// Null where the rows are too many to keep.
    std::shared_ptr<const RowGeometries> geometry() const { return geometry_; }

private:
    void makeGeometry(const DatasetBlock& block, RowGeometry& geometry) const;
    void sortByTexel(RowGeometry& geometry) const;
    /// Returns whether all values weigh as much as their sample.
    bool makeValues(const DatasetBlock& block, const RowGeometry& geometry,
                    RowValues& values) const;

    const RowMaker& maker_;
    const Dataset& dataset_;
    const DataStatistics& statistics_;
    std::shared_ptr<const RowGeometries> geometry_;
    std::vector<RowValues> values_;
    bool sameWeights_;
};

}  // namespace fbrdf
