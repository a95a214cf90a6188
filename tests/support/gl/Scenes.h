// Scenes.h - materials, meshes, lights and views for GL tests; deterministic.
#pragma once
#include <fbrdf/gl/Renderer.h>

namespace fbrdf::test {

/// Tables of noise: log2 F between -1.5 and 1.5, for linear8 between -4 and 0.
Material noiseMaterial(const Form& form, Storage storage, unsigned seed = 1);

/// The same with noise of a third of an octave and half floats, so that the bound of a sum is near
/// its value.
Material calmMaterial(const Form& form);

/// a + b with the tables of both.
Form sumOf(const Form& a, const Form& b);
/// A single table over (theta_i, theta_o): a diffuse term.
Form formIo();
/// p(wo) q(h) p(wi) + s(h): the 2001 layout with its specular map; linear 8-bit storage.
Material waterlooMaterial();
/// Every kind of factor: a 3D table, odd exponents, cosine axes, an axis of one knot, 1D tables in
/// a texture and in uniforms, one channel.
Material everythingMaterial();

/// Directions other than wi, wo and h, the azimuth phi_d and its halves, and signed tables.
Material directionsMaterial();

/// What the image tests draw.
std::vector<Material> testMaterials();

gl::MeshData sphereMesh(int rings);
/// A torus knot (2, 3): overlaps itself from every side. Tangents run along the tube.
gl::MeshData knotMesh(int segments, int sides);

/// Point lights (every fourth with a radius) and, of five, one spot and one directional; all round.
std::vector<Light> testLights(int count, unsigned seed = 5);

/// A view of the origin from (0, 0, 4).
gl::View perspectiveView();
gl::View orthographicView();

}  // namespace fbrdf::test
