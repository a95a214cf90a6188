// Stage.h - what every variant draws: a mesh, a view of it, lights.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

struct Stage {
    gl::MeshData mesh;
    gl::View view;
};

/// "triangle": one that covers the picture, its normals spread as those of a shallow bowl, so that
/// every pixel sees other angles. "sphere": unit, of 64 x 32 quads, touching the border. `aspect`:
/// width / height.
Stage makeStage(const std::string& mesh, double aspect);

/// Point lights on the viewer's side, the same for the same count.
std::vector<Light> stageLights(int count);

}  // namespace fbrdf::bench
