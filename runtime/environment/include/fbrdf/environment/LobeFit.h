// LobeFit.h - from a BRDF to the lobes that stand for it under an environment.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/brdf/Material.h>
#include <fbrdf/environment/Reflectance.h>

namespace fbrdf {

struct LobeFitOptions {
    int lobes = 2;    ///< at most so many tilted lobes, 1 to 3; fewer where more bring nothing
    int normals = 3;  ///< of anisotropic materials: bent normals, 1, 3, 5 or 7
    int thetas = 24;  ///< knots over theta_o
    int threads = 0;  ///< 0: one a core
};

/// What K of `--environment-lobes` stands for, 1 to 3: so many tilted lobes, or 1, 3 or 7 bent
/// normals. Draws have the same numbers (withFewerLobes).
LobeFitOptions lobeOptions(int lobes);

/// Fits lobes to a BRDF, for every view direction; calls f from several threads. Throws
/// Error(usage) for options out of range, Error(fit) for an f that is not finite.
LobeTable fitLobes(const Reflectance& f, bool isotropic, const LobeFitOptions& options = {});

/// The same for a material as it is stored.
LobeTable fitLobes(const Material& material, const LobeFitOptions& options = {});

}  // namespace fbrdf
