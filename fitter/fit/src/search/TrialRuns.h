// TrialRuns.h - fits the forms that a search tries, and keeps a row of each.
#pragma once
#include "search/Candidate.h"
#include "search/Stray.h"

#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

class TrialRuns {
public:
    /// `all`: the data; `part`: the samples that trials are fitted to. All must outlive the object.
    /// FitOptions::seconds are counted from now on.
    TrialRuns(const FitContext& all, const FitContext& part, bool isIsotropic,
              std::vector<Trial>& rows);

    const FitContext& all() const { return all_; }
    const FitContext& part() const { return part_; }
    /// Trials are fitted to all of the data.
    bool isWhole() const { return part_.dataset.rows == all_.dataset.rows; }
    /// Trials are fitted to a part of so many samples that all of them decide every texel many
    /// times over: a fit to all of them errs on them as it would on others.
    bool hasPlenty() const;
    /// Bytes that the result may have.
    size_t budget() const;
    bool isWithin(const Form& form) const { return bytesOf(all_, form) <= budget(); }
    /// No more trials: what is left of the time is for the last fits.
    bool isOver() const;

    /// More than this share of FitOptions::seconds will have gone `ahead` seconds from now.
    bool isLate(double share, double ahead = 0.0) const;

    /// What forms may be fitted with; null: none.
    const std::shared_ptr<const PriorCovariance>& prior() const { return prior_; }

    /// A candidate without trials, and a row for it. Stage "prior": it is fitted with prior().
    Candidate added(const Form& form, const std::string& stage);
    /// Tries candidates, until the time is up; at least one. A form that is far behind after a fold
    /// is not tried further, and not in the result. Where trials are fitted to all of the data,
    /// their fits are kept.
    std::vector<Candidate> tryAll(std::vector<Candidate> candidates);
    /// The variant with the reference's smoothness, if its mark is less by at least `gain`, and by
    /// more than chance would have it. `gain` may be negative.
    std::optional<Candidate> attempt(const Form& variant, const std::string& stage,
                                     const Candidate& reference, double gain);
    /// Fits to all of the data, and marks the fit on it, turned as what is held out. Precondition:
    /// hasPlenty().
    void fitWhole(Candidate& candidate);
    void choose(const Candidate& candidate) { rows_[candidate.trial].chosen = true; }

private:
    /// The context that a candidate is fitted in.
    FitContext contextFor(const FitContext& context, const Candidate& candidate) const;
    /// Holds out folds until `folds` have been, with the threads of `context`, which has the
    /// samples of part().
    void holdOutMore(const FitContext& context, Candidate& candidate, int folds);
    /// All folds, and a fit to all of the data where trials are.
    void complete(const FitContext& context, Candidate& candidate);
    void record(const Candidate& candidate);
    /// Steps on few rows are so short that threads cost more than they save: forms are fitted at
    /// the same time in place of the parts of a form.
    bool isSideBySide() const;
    /// The candidates that the task was done for before the time was up; at least one.
    template <class Task>
    std::vector<Candidate> untilOver(std::vector<Candidate> candidates, const Task& task);

    const FitContext &all_, &part_;
    FitOptions serialOptions_;  ///< those of the context with one thread
    FitContext serial_;         ///< part() with one thread
    std::vector<Trial>& rows_;
    std::optional<Stray> stray_;  ///< where trials are fitted to all of the data
    std::shared_ptr<const PriorCovariance> prior_;
    Clock clock_;
};

}  // namespace fbrdf
