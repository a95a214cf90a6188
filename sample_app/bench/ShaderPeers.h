// ShaderPeers.h - the peers that factored materials are timed against, each as good as we can write
// it: it computes once what does not depend on the light, and nothing that is not needed.
#pragma once
#include "bench/ShaderPeer.h"

namespace fbrdf::bench {

Peer ggxPeer();             ///< analytic, anisotropic
Peer merlPeer();            ///< 90 x 90 x 180 table, filtered linearly
Peer nbrdfPeer();           ///< network of 6-21-21-3 (Network.h)
Peer bakedNbrdfPeer();      ///< the same, weights as constants
Peer poulinFournierPeer();  ///< parallel cylinders, by quadrature
Peer multipassPeer();       ///< p(wo) q(h) p(wi) with one pass for each light, like an osgFX effect

std::vector<Peer> peers();  ///< all of them

}  // namespace fbrdf::bench
