// Candidate.h - one form under trial, and how candidates compare.
#pragma once
#include "search/Restrained.h"

#include <string>
#include <vector>

namespace fbrdf {

struct Candidate {
    Form form;
    size_t trial = 0;       ///< its row among the trials
    bool hasPrior = false;  ///< fitted with a prior
    size_t bytes = 0;
    int lookups = 0;  ///< a light
    HeldOut held;
    std::vector<double> marks;        ///< markOf each part of the samples that were held out
    std::optional<Restrained> whole;  ///< fitted to all data; where that is known before the choice
    /// The marks are those of `whole` on parts of all samples: there are so many that what is held
    /// out would say the same.
    bool isFinal = false;

    /// The mean of the marks; where a fit to all data is known, half of it and the mark of that.
    double mark() const;
};

/// True when the mark of `a` is the smaller.
bool isBetter(const Candidate& a, const Candidate& b);

/// Whether `a` is below `b` by more than a twentieth in one of log_median, cos_rms and cuberoot_rms
/// on all samples, and not above it by more in another. Where trials are fitted to a part of the
/// samples, the errors are those on samples held out.
bool isBetterOnAll(const Candidate& a, const Candidate& b);

/// Parts of what is held out: the folds, or as many parts of the only one.
constexpr size_t kMarkParts = static_cast<size_t>(kFolds);

/// How far a mark is above another, and the standard error of that: of the mean over parts of
/// their differences. Parts are the same samples for both.
struct Lead {
    double mean = 0, error = 0;

    /// The difference could be chance.
    bool isNoise() const { return mean <= error; }
};
Lead leadOf(const Candidate& better, const Candidate& worse);

/// What was chosen, and why in a sentence for people.
struct Choice {
    size_t index = 0;
    std::string reason;
};

/// The cheapest of the candidates that are as good as that of the least mark, with no more terms.
/// Fits to all of many samples (isFinal) take part only where no other is better on all samples.
/// Their marks are above it by no more than the standard error, and none of the others is better on
/// all samples (isBetterOnAll). Where each has a better one, it is the candidate of the least mark.
/// One that leans on a prior is chosen unless the best is surely better: by twice the standard
/// error. Cheaper is: fewer look-ups a light, then fewer terms, then fewer bytes. Precondition:
/// there is one.
Choice choose(const std::vector<Candidate>& candidates);

}  // namespace fbrdf
