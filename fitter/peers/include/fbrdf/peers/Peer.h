// Peer.h - other compact BRDF representations, each fitted to (or published for) the same source,
// so that one table can compare them with ours.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// What a peer made of a source.
struct PeerFit {
    BrdfFunction brdf;   ///< f(wo, wi) in 1/sr; safe to call from threads
    size_t bytes = 0;    ///< what a renderer keeps of it: tables and parameters
    int lookups = 0;     ///< texture look-ups per light
    double seconds = 0;  ///< of the fit; 0 for published parameters
    std::string note;    ///< its parameters, or what was made: one line
    /// The same as a renderer of factored materials draws it; null for peers that are no factors.
    std::shared_ptr<const Material> material = nullptr;
};

struct PeerContext {
    std::string dataDir;  ///< folder with merl_fits and npf_merl: published parameters
    int threads = 0;      ///< 0: one a core
    uint64_t seed = 1;    ///< of the samples taken from functions
    FitWatch watch;       ///< looked at between steps
};

struct Peer {
    std::string name;   ///< "ggx", "svd"
    std::string title;  ///< "GGX + Lambert, least squares"
    std::string paper;  ///< author, year, title; what is ours about it
    std::string needs;  ///< of a source, for people: "a material of MERL"
    /// Nothing where the peer has no answer for this source: no published parameters of that name,
    /// no function to resample, not the model. Throws Error as fitMaterial and openSource do,
    /// FitStopped where the watch of the context is stopped.
    std::optional<PeerFit> (*fit)(const Source& source, const PeerContext& context);
};

/// The folder of FBRDF_DATA_DIR, else ../shared/data: where published parameters are looked for.
std::string publishedDataDir();

/// All peers, in the order of the table. Without Ceres the GGX fits are not among them.
const std::vector<Peer>& peers();
/// Which peers this build is without, and why; empty when it has all.
std::string peersLeftOut();
/// Throws Error(usage) for an unknown name.
const Peer& findPeer(const std::string& name);

/// Samples that a peer is fitted to: `count` of the source's uniform pairs where it is a function,
/// else its own samples, thinned to about `count`.
std::vector<Sample> peerSamples(const Source& source, size_t count, const PeerContext& context);

}  // namespace fbrdf
