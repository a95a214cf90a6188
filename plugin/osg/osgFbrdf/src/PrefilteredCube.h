// PrefilteredCube.h - panoramas convolved with the lobes of materials, as the texels of all levels
// of a cube (fbrdf/environment/Prefilter.h).
#pragma once
#include <fbrdf/environment/CubeImage.h>

namespace osg {
class State;
}

namespace osgFbrdf {

/// Lets the runtime's renderer draw it in a context of OpenSceneGraph that is current. Its state
/// stays as it is, but for the 2D texture of the active unit. Where a CPU samples textures it is
/// made of smaller faces. Throws fbrdf::Error(gl) where the context cannot.
fbrdf::CubeImage drawnCube(osg::State& state, const fbrdf::Panorama& panorama, int faceSize);

/// Made of smaller faces on one core of the CPU, as the others belong to the host, which is
/// drawing.
fbrdf::CubeImage computedCube(const fbrdf::Panorama& panorama, int faceSize);

}  // namespace osgFbrdf
