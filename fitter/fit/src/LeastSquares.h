// LeastSquares.h - Gauss-Newton steps that bring a form's log texels to the samples, which pass by
// in blocks.
//
// The state x holds log2 texels, one column a channel. At x every sample gives a residual r = log2
// f - log2 g(x) and a row sum_t share_t b_t, where share_t is what term t contributes to g. One
// term has share 1: the problem is linear and the first step is its solution. A metric phi other
// than log changes weight and residual of the same row: w phi'^2 and (phi(f) - phi(g)) / phi', with
// derivatives by log2 g.
//
// Weights: f^2 / (f^2 + floor^2). A value below the noise floor is censored: known to lie below, it
// pulls only a prediction that lies above.
#pragma once
#include "Feed.h"
#include "Rows.h"
#include "Solver.h"
#include "Traits.h"

#include <fbrdf/fit/Fit.h>

#include <vector>

namespace fbrdf {

/// Unknowns x channels, column (channel) contiguous: log2 texels.
using State = std::vector<double>;

struct StepOptions {
    double smoothness = 1e-3;  ///< relative to the mean diagonal of the data's matrix
    Metric metric = Metric::log;
    int excludedFold = kNoFold;  ///< samples of this fold take no part
    bool robust = false;         ///< Tukey biweight at the current state
    double damping = 0.0;        ///< Levenberg-Marquardt, relative to the diagonal
};

class LeastSquares {
public:
    /// What `feed` reads from must outlive the object.
    LeastSquares(Form form, Feed feed, const DataTraits& traits, uint64_t seed, int threads);

    size_t unknowns() const { return static_cast<size_t>(layout_.unknowns()); }
    const Layout& layout() const { return layout_; }
    const Form& form() const { return form_; }
    /// The same problem on every `stride`-th block of the data.
    LeastSquares thinned(size_t stride) const;
    /// The same data with another form.
    LeastSquares withForm(const Form& form) const;
    size_t blocks() const { return feed_.blocks; }
    LeastSquares(const LeastSquares&) = delete;

    /// The state after one Gauss-Newton step. Throws Error(fit) when the system is singular beyond
    /// repair.
    State step(const State& x, const StepOptions& options) const;
    /// One linear system, several smoothness strengths: the states after a step with each.
    std::vector<State> steps(const State& x, const StepOptions& options,
                             const std::vector<double>& strengths) const;
    /// Weighted mean of squared residuals: what a damped step must lower.
    double cost(const State& x, const StepOptions& options) const;
    /// Weighted mean |log2 f - log2 g| over the samples of one fold; over all with kNoFold.
    double foldError(const State& x, int fold) const;
    /// Every table flat, the form equal to 2^level; of a sum, the terms but the last equal to
    /// 2^low.
    State flatState() const;

private:
    struct Part;
    struct Normal;
    template <class Visit>
    void forEachRow(size_t part, const State& x, const StepOptions& options,
                    const Visit& visit) const;
    template <class Value>
    double weightedMean(const State& x, const StepOptions& options, const Value& value) const;
    Vec3f tukeyScale(const State& x, const StepOptions& options) const;
    Normal accumulate(const State& x, const StepOptions& options, const Vec3f& scale,
                      int firstChannel, int channels) const;
    void addSmoothness(Normal& normal, const State& x, double strength, int firstChannel) const;

    Form form_;
    Feed feed_;
    DataTraits traits_;
    Layout layout_;
    RowMaker rows_;
    std::vector<SmoothnessRow> smoothness_;
    uint64_t seed_;
    int threads_;
};

}  // namespace fbrdf
