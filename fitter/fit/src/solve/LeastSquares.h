// LeastSquares.h - one least-squares problem: a form, the samples that it is fitted to, and the
// sparse rows that connect them.
//
// A state x is a vector of log2 texels, one column a channel (one column in all with a shared
// shape). At x, sample n has the residual r_n = log2 f_n - log2 g(x)_n and the row sum_t share_t
// b_t, where share_t is the part of g that term t contributes and b_t are the interpolation weights
// of the term's texels (docs/method.md, Eq. 5). A form of one term has share 1: its problem is
// linear, and the first step is its solution.
//
// What is done with the problem has a file each:
//   RowWeights        weighs the residuals of samples: noise, metric, robustness; the cost
//   SystemSums        adds weighted rows up to normal equations
//   SmoothnessChoice  compares strengths of smoothness on samples that are left out
//   Steps             take one Gauss-Newton step, by factored systems or conjugate gradients
//   Descent           repeats steps until the cost stops falling
#pragma once
#include "data/Dataset.h"
#include "data/DataStatistics.h"
#include "solve/FitCache.h"
#include "solve/RowStore.h"
#include "solve/SmoothSystem.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/fit/Fit.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf {

/// Unknowns x columns, column contiguous: log2 texels, and the levels of a shared shape.
using State = std::vector<double>;

enum class SystemSolver { automatic, factored, conjugateGradients };

struct LeastSquaresOptions {
    bool sharedShape = false;  ///< R, G, B have the same texels and a level each
    SystemSolver solver = SystemSolver::automatic;
    SolverOptions limits;             ///< those of linear systems are used here
    FitCache* cache = nullptr;        ///< shared by fits to data on the same grid; may be null
    RankSum ranks;                    ///< one data set over several processes
    const FitWatch* watch = nullptr;  ///< asked for every block of samples; may be null
};

/// Sums over rows are made in this many parts, whatever the number of threads, and added in order:
/// results have the same bits everywhere.
constexpr size_t kParts = 4;

class LeastSquares {
public:
    /// What `dataset` reads from must outlive the object. `statistics` are those of the whole
    /// dataset.
    LeastSquares(Form form, Dataset dataset, const DataStatistics& statistics, uint64_t seed,
                 int threads, const LeastSquaresOptions& options = {});
    LeastSquares(const LeastSquares&) = delete;

    const Form& form() const { return form_; }
    const Layout& layout() const { return layout_; }
    const RowMaker& maker() const { return maker_; }
    const Smoothness& smoothness() const { return smoothness_; }
    const DataStatistics& statistics() const { return statistics_; }
    const RowStore& store() const { return *store_; }
    const LeastSquaresOptions& options() const { return options_; }
    /// Memory that its steps use again.
    Workspace& workspace() const { return *workspace_; }
    uint64_t seed() const { return seed_; }
    int threads() const { return threads_; }
    /// The key of the rows' geometry in the cache; empty where nothing can be shared.
    const std::string& cacheKey() const { return cacheKey_; }

    size_t unknowns() const { return static_cast<size_t>(layout_.unknowns()); }
    size_t columns() const { return layout_.sharedShape() ? 1 : 3; }
    size_t terms() const { return form_.terms.size(); }
    size_t rows() const { return dataset_.rows; }
    bool isInMemory() const { return dataset_.inMemory; }
    /// Additive noise is seen on both sides of 0, by so many samples that means are worth it.
    bool hasWholeNoise() const;

    /// The same problem on about `rows` samples spread over the data, without those of a fold.
    LeastSquares thinned(size_t rows, int excludedFold) const;
    /// The same data with another form.
    LeastSquares withForm(const Form& form) const;
    /// Every table flat and the form equal to 2^level; the terms of a sum but the last equal to
    /// 2^low.
    State flatState() const;

    /// Calls visit(part, block, scratch) for the blocks of this process, the parts at the same
    /// time.
    template <class Visit>
    void forEachBlock(const Visit& visit, size_t parts = kParts) const;

private:
    Form form_;
    Dataset dataset_;
    DataStatistics statistics_;
    LeastSquaresOptions options_;
    Layout layout_;
    RowMaker maker_;
    Smoothness smoothness_;
    uint64_t seed_;
    int threads_;
    std::string cacheKey_;
    std::unique_ptr<RowStore> store_;
    std::unique_ptr<Workspace> workspace_ = std::make_unique<Workspace>();
};

template <class Visit>
void LeastSquares::forEachBlock(const Visit& visit, size_t parts) const
{
    const RankSum& ranks = options_.ranks;
    const size_t first = store_->blocks() * ranks.rank / ranks.count,
                 last = store_->blocks() * (ranks.rank + 1) / ranks.count;
    parallelTasks(parts, threads_, [&](size_t part) {
        RowStore::Scratch scratch;
        const size_t blocks = last - first;
        for (size_t b = blocks * part / parts; b < blocks * (part + 1) / parts; ++b) {
            if (options_.watch) options_.watch->check();
            visit(part, first + b, scratch);
        }
    });
}

}  // namespace fbrdf
