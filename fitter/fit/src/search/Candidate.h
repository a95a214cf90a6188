// Candidate.h - one form under trial, and how candidates compare.
#pragma once
#include "Job.h"

#include <vector>

namespace fbrdf {

/// How a candidate stands after a fold.
struct Marks {
    double score = 0;  ///< the held-out error that decides, see scoreOf
    /// Mean logarithm of the score and of the error in the cube-root metric: the first shows how
    /// close most directions are, the second sees highlights.
    double merit = 0;
};

struct Candidate {
    Form form;
    size_t trial = 0;  ///< its row among the trials
    size_t bytes = 0;
    HeldOut held;
    std::vector<Marks> marks;  ///< after each fold

    double score() const { return marks.back().score; }
    /// Errors so small that nothing is left to see: neither more texels nor other warps help.
    bool isFine() const;
};

/// The result's score is at most this much of the least of all trials: what saving bytes may cost.
constexpr double kAllowed = 1.01;

bool byScore(const Candidate& a, const Candidate& b);
double leastScore(const std::vector<Candidate>& candidates);

/// The smallest in bytes, then the best, of the candidates whose score is within kAllowed of the
/// least. Precondition: there is one.
const Candidate& pick(const std::vector<Candidate>& candidates);

/// The relative difference of scores that is within the noise of the samples left out so far.
double slackOf(const HeldOut& held);

}  // namespace fbrdf
