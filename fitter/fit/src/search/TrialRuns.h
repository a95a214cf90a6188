// TrialRuns.h - fits the forms that a search tries, and keeps a row of each.
#pragma once
#include "search/Candidate.h"

#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

class TrialRuns {
public:
    /// `all`: the data; `part`: the samples that trials are fitted to. All must outlive the object.
    TrialRuns(const Job& all, const Job& part, std::vector<Trial>& rows)
        : all_(all), part_(part), rows_(rows)
    {
    }

    const Job& all() const { return all_; }
    const Job& part() const { return part_; }
    /// Bytes that the result may have.
    size_t budget() const;
    bool isWithin(const Form& form) const { return bytesOf(all_, form) <= budget(); }
    /// No more trials before the finals: bounds the time.
    bool isFull() const;

    /// Holds out the first fold. `smoothness` 0: the fold chooses it, for those to come as well.
    Candidate start(const Form& form, const std::string& stage, double smoothness);
    /// Holds out folds until `folds` have been. Precondition: at most part().folds.
    void goOn(Candidate& candidate, int folds);
    /// The variant, unless a fold shows that its merit changes by more than `change` against
    /// `reference`, or that it gives up the score.
    std::optional<Candidate> attempt(const Form& variant, const std::string& stage,
                                     const Candidate& reference, double change);
    /// Fits all data, and measures the errors that will be stated.
    Candidate finish(const Source& source, const Form& form, Fitted& fitted);
    void choose(const Candidate& candidate) { rows_[candidate.trial].chosen = true; }

private:
    Candidate added(const Form& form, const std::string& stage);
    void record(Candidate& candidate, double seconds);

    const Job &all_, &part_;
    std::vector<Trial>& rows_;
};

}  // namespace fbrdf
