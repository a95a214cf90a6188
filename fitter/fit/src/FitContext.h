// FitContext.h - the data of one fit and what is the same for every form tried on it.
#pragma once
#include "data/Dataset.h"
#include "data/DataStatistics.h"
#include "prior/PriorFit.h"
#include "solve/Solve.h"

#include <fbrdf/fit/Clock.h>
#include <fbrdf/fit/Fit.h>

namespace fbrdf {

/// Of fewer scattered samples all folds are held out in turn, and fits may lean on a prior: more
/// decide all that it knows.
constexpr size_t kSmallSet = 5000;

struct FitContext {
    const FitOptions& options;
    Dataset dataset;
    DataStatistics statistics;
    bool robust = false;
    int folds = 1;  ///< that are held out in turn
    /// Samples that are held out are compared as data/Symmetry.h turns them.
    bool turnsHeldOut = false;
    /// Where it is not null, forms are fitted with it; they must then be its own.
    std::shared_ptr<const PriorCovariance> prior;
};

/// The samples of a fit; `source` must outlive the dataset. Throws Error(fit) when there are none.
Dataset readDataset(const Source& source, const FitOptions& options);

/// `options` must outlive the context. Throws Error(fit) naming `source` for too few samples.
FitContext makeFitContext(Dataset dataset, const FitOptions& options, const std::string& source);

/// Samples as sizes of forms count them: one without a trace of noise decides as much as two.
size_t decidingSamples(const FitContext& context);

/// The context on a part of its samples, or the context itself when `part` is empty.
FitContext partOf(const FitContext& context, std::vector<Sample> part);
/// Bytes of the material that the context makes of a form.
size_t bytesOf(const FitContext& context, const Form& form);

SolveOptions solveOptions(const FitContext& context);
LeastSquaresOptions problemOptions(const FitContext& context);

/// A form fitted to all of the data.
struct Fitted {
    Material material;
    double smoothness = 0;
    SolverSummary solver;
    std::optional<SampleErrors> heldOut;  ///< where they are known already
    Solution solution;                    ///< of the form; empty where no system was solved
    std::optional<PriorSummary> prior;    ///< of a fit that leans on one
};
/// `start`: the solution for a part of the data, where that is known.
Fitted fitForm(const FitContext& context, const Form& form, const Solution* start = nullptr);
/// A form fitted to all of the data and to `more` beside them, which support no texel.
Fitted fitFormBeside(const FitContext& context, const Form& form, const std::vector<Sample>& more);

/// The errors that are stated for a fit. For a function they are measured on a fresh set of
/// directions; for measurements, on folds that fits of the same form and smoothness leave out.
SampleErrors heldOutErrors(const Source& source, const FitContext& context, const Fitted& fitted);

/// At most FitOptions::measured of the data, which errors are computed on.
std::vector<Sample> probeOf(const FitContext& context,
                            const FoldChoice& choice = FoldChoice::all());

/// Samples that took no part in the fits of a form, each of the first folds left out of one.
struct HeldOut {
    int folds = 0;
    Solution solution;                    ///< of the last fit
    std::optional<PriorWeights> weights;  ///< of the first fit with a prior, and of the others
    std::vector<Sample> samples;
    std::vector<Vec3f> fitted;
    std::vector<size_t> foldEnd;  ///< one past the last sample of each fold
    SampleErrors errors;
};
/// Continues until `folds` folds are held out. `smoothness` 0: each of these fits chooses its own.
/// `start`: see SolveOptions. Precondition: folds <= kFolds.
void holdOut(const FitContext& context, const Form& form, double smoothness, int folds,
             HeldOut& held, const Solution* start = nullptr);

}  // namespace fbrdf
