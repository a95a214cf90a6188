// LeastSquares.h - the rows of all samples, and the Gauss-Newton steps that bring a form's log
// texels to them.
//
// The state x holds log2 texels, one column a channel. At x every sample gives a residual r = log2
// f - log2 g(x) and a row sum_t share_t b_t, where share_t is what term t contributes to g. One
// term has share 1: the problem is linear and the first step is its solution. A metric phi other
// than log changes weight and residual of the same row: w phi'^2 and (phi(f) - phi(g)) / phi', with
// derivatives by log2 g.
#pragma once
#include "Rows.h"
#include "Solver.h"

#include <fbrdf/fit/Fit.h>

#include <vector>

namespace fbrdf {

/// What the samples say, per channel.
struct Observations {
    std::vector<Sample> samples;
    std::vector<Vec3f> logValue;  ///< log2 f, or log2 of the noise floor where censored
    std::vector<Vec3f> weight;  ///< f^2 / (f^2 + floor^2) times the sample's own; 0 where unusable
    std::vector<uint8_t> censored;  ///< bit c: channel c is known only to lie below the floor
    std::vector<uint8_t> fold;      ///< 0 .. kFolds - 1
    Vec3f floor{0.0f};
    size_t used = 0, belowFloor = 0;
};

constexpr int kFolds = 5;
constexpr int kNoFold = -1;

/// Throws Error(fit) when no channel of any sample is above the floor.
Observations observe(std::vector<Sample> samples, const Vec3f& floor, uint64_t seed);

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
    LeastSquares(const Form& form, const Observations& observations, int threads);

    size_t unknowns() const { return static_cast<size_t>(layout_.unknowns()); }
    const Layout& layout() const { return layout_; }
    const Form& form() const { return form_; }

    /// The state after one Gauss-Newton step. Throws Error(fit) when the system is singular beyond
    /// repair.
    State step(const State& x, const StepOptions& options) const;
    /// One linear system, several smoothness strengths: the states after a step with each.
    std::vector<State> steps(const State& x, const StepOptions& options,
                             const std::vector<double>& strengths) const;
    /// Weighted mean of squared residuals plus smoothness, what a damped step must lower.
    double cost(const State& x, const StepOptions& options) const;
    /// Weighted mean |log2 f - log2 g| of the samples of one fold (or all but with kNoFold).
    double foldError(const State& x, int fold) const;
    /// A flat start: every texel such that the form equals the median of f.
    State flatState() const;

private:
    struct Working;
    struct Normal;
    Working workingAt(const State& x, const StepOptions& options) const;
    Normal accumulate(const Working& working, int firstChannel, int channels) const;
    void addSmoothness(Normal& normal, const State& x, double strength, int firstChannel) const;
    void applyTukey(Working& working) const;

    const Form& form_;
    const Observations& observations_;
    Layout layout_;
    std::vector<RowSet> rows_;  ///< one a term
    std::vector<SmoothnessRow> smoothness_;
    int threads_;
};

}  // namespace fbrdf
