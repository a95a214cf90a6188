// FitOrder.h - what is to be fitted to a source, and what came of it: a form of the fitter, or one
// of the peers that it is compared with.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/sources/OpenSource.h>

#include <memory>
#include <string>

namespace fbrdf::fitting {

/// What is to be fitted.
struct FitOrder {
    std::string source;  ///< as openSource takes it
    SourceOptions sourceOptions;
    FitOptions fit;
    int lobes = 2;     ///< lobes that the material gets (lobeOptions, LobeFit.h); 0: none
    std::string peer;  ///< one of peers() (Peer.h), fitted instead of a form; empty: none
    /// A source that is a function, or a material, is opened and not fitted.
    bool functionIsEnough = false;
    std::shared_ptr<const Source> opened;  ///< the source, where it has been opened already
};

struct FitReply {
    int number = 0;  ///< of the order, see FitWorker::order
    /// Null where it failed, and `error` has the sentence that the tool prints, or was stopped; and
    /// where all there is is a function.
    std::shared_ptr<const Material> material;
    BrdfFunction brdf;                     ///< of a peer, and of a function that was not fitted
    LobeTable lobes;                       ///< of a function that is no material
    std::string note;                      ///< its parameters, or what was made: one line
    std::shared_ptr<const Source> source;  ///< that it was fitted to
    std::string error;
    bool isStopped = false;
    FitSummary summary;
    double seconds = 0.0;  ///< from the beginning of the fit to its end; reading included
};

/// Fits what is ordered to its source, which the reply keeps. Throws what fitMaterial and the peers
/// throw, and Error(usage) where a peer has no answer for the source.
FitReply fitted(const FitOrder& order, std::shared_ptr<const Source> source);

}  // namespace fbrdf::fitting
