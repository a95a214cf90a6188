// BentFit.h - lobes about bent normals, for anisotropic materials: the shape of a highlight at
// every azimuth follows from the normals, so that neither levels nor tilts have to be found for
// each lobe.
#pragma once
#include <fbrdf/environment/LobeFit.h>

namespace fbrdf {

/// options.normals lobes on 12 x 7 knots; the reflectance counts as the mean over reflections at
/// both axes of the frame. Throws as fitLobes.
LobeTable fitBentLobes(const Reflectance& f, const LobeFitOptions& options);

}  // namespace fbrdf
