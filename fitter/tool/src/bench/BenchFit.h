// BenchFit.h - one source, many representations: each form of ours and each peer fitted to it and
// measured alike.
#pragma once
#include "Errors.h"
#include "Progress.h"

#include <fbrdf/fit/Fit.h>
#include <fbrdf/peers/Peer.h>
#include <fbrdf/sources/OpenSource.h>

#include <string>
#include <vector>

namespace fbrdf::tool {

/// What is fitted: a form within a byte budget, or a peer.
struct Contender {
    std::string label;  ///< as on the command line: "hdio:3900", "ggx"
    bool ours = true;
    std::string name;     ///< of the form or of the peer
    size_t maxBytes = 0;  ///< of a form; 0: its own default size
};

inline bool sameContender(const Contender& a, const Contender& b)
{
    return a.label == b.label && a.ours == b.ours;
}

/// "hdio:3900,io+hdio" and "ggx,svd" (or "all", "none"); throws Error(usage) for unknown names.
std::vector<Contender> contendersFrom(const std::string& forms, const std::string& peers);

struct BenchOptions {
    std::vector<Contender> contenders;
    FitOptions fit;  ///< of our forms: storage, metric, robust, smoothness, seed, threads
    PeerContext peers;
    SourceOptions source;
};

/// One contender on one material.
struct Score {
    Contender contender;
    size_t bytes = 0;
    int lookups = 0;     ///< per light
    double seconds = 0;  ///< of one fit
    ErrorMap errors;
    std::string note;
};

struct MaterialScores {
    std::string source, name;
    std::vector<Score> scores;  ///< of the contenders that have an answer
    std::string error;          ///< why there are none; empty when there are
};

/// Fits all contenders. A source that is a function is judged at the uniform test set and on the
/// standard sphere; one that has samples alone at its samples, each of five folds held out in turn.
/// Throws Error as openSource does.
MaterialScores scoreMaterial(const std::string& source, const BenchOptions& options,
                             Progress& progress);

/// Fits one contender to one source. Returns nothing where it has no answer.
std::optional<PeerFit> fitContender(const Contender& contender, const Source& source,
                                    const BenchOptions& options);

}  // namespace fbrdf::tool
