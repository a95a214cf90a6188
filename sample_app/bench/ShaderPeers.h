// ShaderPeers.h - the peers that factored materials are timed against, each as good as we can write
// it: it computes once what does not depend on the light, and nothing that is not needed.
#pragma once
#include "bench/ShaderPeer.h"

namespace fbrdf::bench {

ShaderPeer ggxPeer();             ///< analytic, anisotropic
ShaderPeer merlPeer();            ///< 90 x 90 x 180 table, filtered linearly
ShaderPeer nbrdfPeer();           ///< network of 6-21-21-3 (Network.h)
ShaderPeer bakedNbrdfPeer();      ///< the same, weights as constants
ShaderPeer poulinFournierPeer();  ///< parallel cylinders, by quadrature
ShaderPeer
multipassPeer();  ///< p(wo) q(h) p(wi) with one pass for each light, like an osgFX effect

std::vector<ShaderPeer> shaderPeers();  ///< all of them

}  // namespace fbrdf::bench
