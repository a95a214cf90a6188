// FitContext.h - the data of one fit and what is the same for every form tried on it.
#pragma once
#include "data/Dataset.h"
#include "data/DataStatistics.h"
#include "solve/Solve.h"

#include <fbrdf/fit/Clock.h>
#include <fbrdf/fit/Fit.h>

namespace fbrdf {

struct Job {
    const FitOptions& options;
    Feed feed;
    DataTraits traits;
    bool robust = false;
    int folds = 1;  ///< that are held out in turn
    /// Samples that are held out are compared as data/Symmetry.h turns them.
    bool turnsHeldOut = false;
};

/// The samples of a fit; `source` must outlive the feed. Throws Error(fit) when there are none.
Feed readFeed(const Source& source, const FitOptions& options);

/// `options` must outlive the job. Throws Error(fit) naming `source` for too few samples.
Job makeJob(Feed feed, const FitOptions& options, const std::string& source);

/// Samples as sizes of forms count them: one without a trace of noise decides as much as two.
size_t decidingSamples(const Job& job);

/// The job on a part of its samples, or the job itself when `part` is empty.
Job partOf(const Job& job, std::vector<Sample> part);
/// Bytes of the material that the job makes of a form.
size_t bytesOf(const Job& job, const Form& form);

SolveOptions solveOptions(const Job& job);
LeastSquaresOptions problemOptions(const Job& job);

/// A form fitted to all of the data.
struct Fitted {
    Material material;
    double smoothness = 0;
    SolverSummary solver;
    std::optional<SampleErrors> heldOut;  ///< where they are known already
};
Fitted fitForm(const Job& job, const Form& form);

/// The errors that are stated for a fit. For a function they are measured on a fresh set of
/// directions; for measurements, on folds that fits of the same form and smoothness leave out.
SampleErrors heldOutErrors(const Source& source, const Job& job, const Fitted& fitted);

/// At most kProbeSamples of the data, which errors are computed on.
std::vector<Sample> probeOf(const Job& job, const FoldChoice& choice = FoldChoice::all());

/// Samples that took no part in the fits of a form, each of the first folds left out of one.
struct HeldOut {
    int folds = 0;
    double smoothness = 0;  ///< of the last fit
    std::vector<Sample> samples;
    std::vector<Vec3f> fitted;
    std::vector<size_t> foldEnd;  ///< one past the last sample of each fold
    SampleErrors errors;
};
/// Continues until `folds` folds are held out. `smoothness` 0: each of these fits chooses its own.
/// Precondition: folds <= kFolds.
void holdOut(const Job& job, const Form& form, double smoothness, int folds, HeldOut& held);

}  // namespace fbrdf
