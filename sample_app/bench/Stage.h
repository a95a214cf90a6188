// Stage.h - the scene that every variant draws: a mesh, a view of it, lights.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

struct Stage {
    gl::MeshData mesh;
    gl::View view;
};

/// "triangle": one triangle that covers the picture, with the normals of a shallow bowl, so that
/// every pixel sees other angles. "sphere": a unit sphere of 64 x 32 quads that touches the border.
/// `aspect`: width / height.
Stage makeStage(const std::string& mesh, double aspect);

/// Point lights on the viewer's side, the same for the same count.
std::vector<Light> stageLights(int count);

}  // namespace fbrdf::bench
