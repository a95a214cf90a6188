// NormalRows.h - the weighted rows of one block, side by side as the kernels of RowKernel.h read
// them.
#pragma once
#include "solve/RowWeights.h"

#include <array>

namespace fbrdf {

/// Channels that one pass over the rows serves: [first, first + channels), a lane each. `matrices`:
/// kLanes, a matrix a channel; 1, one for all channels; or 0, the matrix is known already.
struct ChannelPass {
    size_t first, channels, matrices;
};

/// The group of sums that a sample of each fold adds to.
using FoldGroups = std::array<unsigned char, kFolds>;
/// Group 1 + k for the k-th of `folds`, kNoGroup for the excluded fold, group 0 for the others.
/// Precondition: `folds` do not contain `excluded`.
FoldGroups groupsOf(const std::vector<int>& folds, int excluded);

/// What rows are made of besides the data.
struct RowOptions {
    RowWeights weights;
    Texels texels;
    ChannelPass pass;
    FoldGroups groups;
};

/// The rows of one block: one a sample; with a shared shape three, one a channel. Storage that is
/// used again from block to block.
class NormalRows {
public:
    /// `block` must stay valid as long as rows() is used.
    void make(const LeastSquares& problem, const RowStore::Block& block, const RowOptions& with);
    void clear() { group_.clear(); }
    bool empty() const { return group_.empty(); }

    const KernelRows& rows() const { return rows_; }
    /// Lanes in which the entries of a row differ: kLanes, or 1 where all lanes have the same.
    int entryLanes() const { return entryLanes_; }

private:
    void repeatForChannels(const LeastSquares& problem, const RowGeometry& geometry);
    void weigh(const LeastSquares& problem, const RowStore::Block& block, const RowOptions& with);
    void addLevelsToTerms(const LeastSquares& problem);
    void describe(const LeastSquares& problem, const RowGeometry& geometry,
                  const ChannelPass& pass);

    // With a shared shape a row has the block's texels and a level for each term; else the block's
    // own texels are used, and these are empty.
    std::vector<int> unknown_;
    std::vector<float> weight_;
    std::vector<int> termEnd_;
    std::vector<float> share_, sampleWeight_, residual_;
    std::vector<unsigned char> group_;
    KernelRows rows_{};
    int entryLanes_ = 1;
};

}  // namespace fbrdf
