// LeastSquares.h - Gauss-Newton steps that bring a form's log texels to the samples, which pass by
// in blocks.
//
// The state x holds log2 texels, one column a channel (one in all with a shared shape). At x every
// sample gives a residual r = log2 f - log2 g(x) and a row sum_t share_t b_t, where share_t is what
// term t contributes to g. One term has share 1: the problem is linear and the first step is its
// solution. A metric phi other than log changes weight and residual of the same row: w phi'^2 and
// (phi(f) - phi(g)) / phi', with derivatives by log2 g.
//
// Weights: f^2 / (f^2 + floor^2). A value below the noise floor is censored: known to lie below, it
// pulls only a prediction that lies above.
//
// Small systems are factored, large ones solved by preconditioned conjugate gradients.
#pragma once
#include "data/Feed.h"
#include "data/Traits.h"
#include "solve/FitCache.h"
#include "solve/NormalSystem.h"
#include "solve/RowStore.h"
#include "solve/SmoothSystem.h"

#include <fbrdf/fit/Fit.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf {

/// Unknowns x columns, column contiguous: log2 texels, and the levels of a shared shape.
using State = std::vector<double>;

struct StepOptions {
    double smoothness = 1e-3;  ///< relative to the mean diagonal of the data's matrix
    Metric metric = Metric::log;
    int excludedFold = kNoFold;  ///< samples of this fold take no part
    bool robust = false;         ///< Tukey biweight at the current state
    /// Residuals f / g - 1 of all values, zeros and negative ones too, in place of logarithms:
    /// right on average under noise, from a state that is near. Only where hasWholeNoise().
    bool unbiased = false;
    double damping = 0.0;  ///< Levenberg-Marquardt, relative to the diagonal
};

enum class SystemSolver { automatic, factored, conjugateGradients };

struct LeastSquaresOptions {
    bool sharedShape = false;  ///< R, G, B have the same texels and a level each
    SystemSolver solver = SystemSolver::automatic;
    /// Of conjugate gradients: residual over right-hand side. They start near (Solve.cpp): a pqp of
    /// 64 x 64 texels has the same errors with 1e-2 as with 1e-3, in a sixth of the iterations.
    double tolerance = 1e-2;
    FitCache* cache = nullptr;  ///< where fits to data on the same grid meet; may be null
    RankSum ranks;              ///< one data set over several processes
};

class LeastSquares {
public:
    /// What `feed` reads from must outlive the object.
    LeastSquares(Form form, Feed feed, const DataTraits& traits, uint64_t seed, int threads,
                 const LeastSquaresOptions& options = {});
    LeastSquares(const LeastSquares&) = delete;

    size_t unknowns() const { return static_cast<size_t>(layout_.unknowns()); }
    size_t columns() const { return layout_.sharedShape() ? 1 : 3; }
    const Layout& layout() const { return layout_; }
    const Form& form() const { return form_; }
    size_t rows() const { return feed_.rows; }
    /// Additive noise is seen on both sides of 0, by so many samples that means are worth it.
    bool hasWholeNoise() const;
    /// Too large to be factored: steps take conjugate gradients, and stepWithBest is not for it.
    bool isLarge() const;
    /// Rows or weights of a step differ from state to state: the problem is not linear.
    bool dependsOnState(const StepOptions& options) const;
    /// The same problem on about `rows` samples spread over the data, without those of a fold.
    LeastSquares thinned(size_t rows, int excludedFold) const;
    /// The same data with another form.
    LeastSquares withForm(const Form& form) const;

    /// The state after one Gauss-Newton step. Throws Error(fit) when the system is singular beyond
    /// repair.
    State step(const State& x, const StepOptions& options) const;
    struct Choice {
        State x;
        double smoothness;
    };
    /// The step with the strength that does best on samples left out, each of `folds` in turn; the
    /// smoothness of `options` does not count. The rows are added up once for all strengths. Of
    /// many samples about 262,144 are left out and compared.
    /// Precondition: folds do not contain options.excludedFold.
    Choice stepWithBest(const State& x, const StepOptions& options,
                        const std::vector<double>& strengths, const std::vector<int>& folds) const;
    /// Weighted mean of squared residuals: what a damped step must lower. A robust one is bounded
    /// as the biweight is (Beaton and Tukey 1974), with the scale of the residuals at `scaleAt`.
    double cost(const State& x, const StepOptions& options, const State& scaleAt) const;
    /// Sum of interpolation weights of every unknown over the samples with a channel above the
    /// noise floor. Of a stream a part of it answers: 262,144 samples.
    std::vector<double> support() const;
    /// Every table flat, the form equal to 2^level; of a sum, the terms but the last equal to
    /// 2^low.
    State flatState() const;

private:
    struct Row;
    struct Texels;
    struct Predicted;
    struct Pass;
    struct NormalRows;
    struct SharedSystems;
    using States = std::vector<State>;

    /// Calls visit(part, block, scratch) for the blocks of this process, the parts at the same
    /// time.
    template <class Visit>
    void forEachBlock(const Visit& visit) const;
    float unbiasedAt(const RowStore::Block& rows, size_t i, int channel, float logG,
                     float& residual) const;
    /// Of rows [first, first + count) of a block.
    void predict(const RowGeometry& rows, size_t first, size_t count, const Texels& texels,
                 Predicted& predicted) const;
    Row rowAt(const RowStore::Block& rows, size_t i, const float* logG, const StepOptions& options,
              const Vec3f& scale) const;
    /// Calls visit(row, fold) for the samples that take part.
    template <class Visit>
    void forEachRow(size_t block, RowStore::Scratch& scratch, const Texels& texels,
                    const StepOptions& options, const Vec3f& scale, const Visit& visit) const;
    std::vector<double> countedSupport() const;
    Vec3f tukeyScale(const State& x, const StepOptions& options) const;
    std::vector<Pass> passes(const StepOptions& options, size_t groups) const;
    struct RowOptions;
    void repeatForChannels(const RowGeometry& geometry, NormalRows& made) const;
    void describeRows(const RowGeometry& geometry, const Pass& pass, NormalRows& made) const;
    void makeNormalRows(const RowStore::Block& block, const RowOptions& with,
                        NormalRows& made) const;
    std::vector<NormalSums> sums(const State& x, const StepOptions& options, const Pass& pass,
                                 const std::vector<int>& folds) const;
    std::vector<SharedSystems> systems(const State& x, const StepOptions& options, const Pass& pass,
                                       const std::vector<int>& folds) const;
    std::string gridKey(const StepOptions& options, const Pass& pass,
                        const std::vector<int>& folds) const;
    std::vector<SharedSystems> allSystems(const State& x, const StepOptions& options,
                                          const std::vector<int>& folds) const;
    void takeStep(State& x, const SharedSystems& system, size_t which, double strength,
                  double damping) const;
    /// How far a texel moves that a step asks to move by so many octaves: a term with a small share
    /// asks for leaps that its share after the leap does not bear out.
    double bounded(double octaves) const;
    void repeatGrey(State& x) const;
    template <class Visit>
    void forEachLeftOut(const std::vector<int>& folds, const Visit& visit) const;
    std::vector<double> foldErrors(const std::vector<States>& states,
                                   const std::vector<int>& folds) const;
    struct GradientProblem;
    State conjugateGradientStep(const State& x, const StepOptions& options) const;

    Form form_;
    Feed feed_;
    DataTraits traits_;
    LeastSquaresOptions options_;
    Layout layout_;
    RowMaker maker_;
    Smoothness smoothness_;
    uint64_t seed_;
    int threads_;
    std::string cacheKey_;  ///< empty: nothing can be shared
    std::unique_ptr<RowStore> store_;
};

}  // namespace fbrdf
