// Peers.h - the peers that factored materials are timed against, each as good as we can write it:
// what does not depend on the light is done once, and nothing is computed that is not needed.
#pragma once
#include "bench/Peer.h"

namespace fbrdf::bench {

Peer ggxPeer();             ///< analytic, anisotropic
Peer merlPeer();            ///< 90 x 90 x 180 table, filtered linearly
Peer nbrdfPeer();           ///< network of 6-21-21-3 (Network.h)
Peer bakedNbrdfPeer();      ///< the same, weights as constants
Peer poulinFournierPeer();  ///< parallel cylinders, by quadrature
Peer multipassPeer();       ///< p(wo) q(h) p(wi) in a pass a light, as an osgFX effect would

std::vector<Peer> peers();  ///< all of them

}  // namespace fbrdf::bench
