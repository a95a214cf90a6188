// Prediction.h - what a state predicts for rows: log2 g of samples, and the share that each term
// contributes to g. Floats, with a lane a channel, as the kernels of RowKernel.h read them.
#pragma once
#include "solve/LeastSquares.h"

namespace fbrdf {

/// A state as rows read it. Texels that are all equal predict the same for every sample, as the
/// weights of a factor sum to 1: such a state has levels alone.
class Texels {
public:
    Texels(const LeastSquares& problem, const State& x);
    bool isFlat() const { return values_.empty(); }
    const float* values() const { return values_.data(); }  ///< unknowns x kLanes
    const float* levels() const { return levels_.data(); }  ///< terms x kLanes

private:
    bool takeFlat(const LeastSquares& problem, const State& x);

    std::vector<float> values_;
    std::vector<float> levels_;  ///< 0 without a shared shape
};

struct Prediction {
    std::vector<float> logG;   ///< rows x kLanes: log2 g
    std::vector<float> share;  ///< rows x terms x kLanes; empty for a form of one term
};

/// Predicts rows [first, first + count) of a block.
void predict(const LeastSquares& problem, const RowGeometry& rows, size_t first, size_t count,
             const Texels& texels, Prediction& predicted);

}  // namespace fbrdf
