#include <fbrdf/base/Assert.h>
#include <fbrdf/scene/Meshes.h>
#include <fbrdf/scene/ObjFile.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

// Bounding radius 1.19, so that the default camera sees all of it. The strands stay 0.46 apart and
// the curvature in [0.5, 2.7], so the tube neither touches nor folds itself and Frenet's frame is
// defined everywhere.
constexpr double kKnotScale = 0.33, kKnotDepth = 1.3, kTubeRadius = 0.20;

void addVertex(Mesh& mesh, const Vec3d& position, const Vec3d& normal, const Vec3d& tangent)
{
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.tangents.emplace_back(tangent);
}

void addTriangle(Mesh& mesh, int a, int b, int c)
{
    for (const int index : {a, b, c}) mesh.indices.push_back(static_cast<uint32_t>(index));
}

void addQuad(Mesh& mesh, int a, int b, int c, int d)
{
    addTriangle(mesh, a, b, c);
    addTriangle(mesh, a, c, d);
}

/// Along increasing azimuth about +y, where azimuth turns z into x.
Vec3d azimuthTangent(double azimuth)
{
    return {std::cos(azimuth), 0.0, -std::sin(azimuth)};
}

void addSphereVertex(Mesh& mesh, double polar, double azimuth)
{
    const double sine = std::sin(polar);
    const Vec3d normal(sine * std::sin(azimuth), std::cos(polar), sine * std::cos(azimuth));
    addVertex(mesh, normal, normal, azimuthTangent(azimuth));
}

/// One vertex a segment, at the middle of the triangle that it closes.
void addPole(Mesh& mesh, double y, int segments)
{
    for (int s = 0; s < segments; ++s)
        addVertex(mesh, {0.0, y, 0.0}, {0.0, y, 0.0},
                  azimuthTangent(2.0 * kPi * (s + 0.5) / segments));
}

/// The centre line of the knot and its first two derivatives in the parameter u, period 2 pi.
struct Curve {
    Vec3d position, first, second;
};

/// (sin u + 2 sin 2u, cos u - 2 cos 2u, -sin 3u), the usual trefoil, a little deeper.
Curve trefoil(double u)
{
    const double c1 = std::cos(u), s1 = std::sin(u);
    const double c2 = std::cos(2.0 * u), s2 = std::sin(2.0 * u);
    const double c3 = kKnotDepth * std::cos(3.0 * u), s3 = kKnotDepth * std::sin(3.0 * u);
    return {kKnotScale * Vec3d(s1 + 2.0 * s2, c1 - 2.0 * c2, -s3),
            kKnotScale * Vec3d(c1 + 4.0 * c2, -s1 + 4.0 * s2, -3.0 * c3),
            kKnotScale * Vec3d(-s1 - 8.0 * s2, -c1 + 8.0 * c2, 9.0 * s3)};
}

/// A ring of the tube. Frenet's frame turns about the curve as u grows, which moves points within
/// the ring but leaves the normal of the tube radial.
void addRing(Mesh& mesh, double u, int around)
{
    const Curve curve = trefoil(u);
    const Vec3d tangent = glm::normalize(curve.first);
    const Vec3d binormal = glm::normalize(glm::cross(curve.first, curve.second));
    const Vec3d principal = glm::cross(binormal, tangent);
    for (int i = 0; i < around; ++i) {
        const double v = 2.0 * kPi * i / around;
        const Vec3d normal = std::cos(v) * principal + std::sin(v) * binormal;
        addVertex(mesh, curve.position + kTubeRadius * normal, normal, tangent);
    }
}

}  // namespace

Mesh makeSphere(int segments, int rings)
{
    FBRDF_ASSERT(segments, >=, 3);
    FBRDF_ASSERT(rings, >=, 2);
    Mesh mesh;
    addPole(mesh, 1.0, segments);
    for (int r = 1; r < rings; ++r)
        for (int s = 0; s < segments; ++s)
            addSphereVertex(mesh, kPi * r / rings, 2.0 * kPi * s / segments);
    addPole(mesh, -1.0, segments);
    const auto at = [segments](int row, int s) { return row * segments + s % segments; };
    for (int s = 0; s < segments; ++s) {
        addTriangle(mesh, at(0, s), at(1, s), at(1, s + 1));
        for (int r = 1; r + 1 < rings; ++r)
            addQuad(mesh, at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1));
        addTriangle(mesh, at(rings, s), at(rings - 1, s + 1), at(rings - 1, s));
    }
    return mesh;
}

Mesh makeKnot(int along, int around)
{
    FBRDF_ASSERT(along, >=, 3);
    FBRDF_ASSERT(around, >=, 3);
    Mesh mesh;
    for (int ring = 0; ring < along; ++ring) addRing(mesh, 2.0 * kPi * ring / along, around);
    const auto at = [along, around](int ring, int i) {
        return (ring % along) * around + i % around;
    };
    for (int ring = 0; ring < along; ++ring)
        for (int i = 0; i < around; ++i)
            addQuad(mesh, at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
    return mesh;
}

Mesh makePlane(int cells)
{
    FBRDF_ASSERT(cells, >=, 1);
    Mesh mesh;
    const auto place = [cells](int i) { return -1.0 + 2.0 * i / cells; };
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i)
            addVertex(mesh, {place(i), place(j), 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0});
    const auto at = [cells](int i, int j) { return j * (cells + 1) + i; };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
}

Mesh meshFromName(const std::string& name)
{
    if (name == "sphere") return makeSphere();
    if (name == "knot") return makeKnot();
    if (name == "plane") return makePlane();
    return readObj(name);
}

std::optional<Mesh> coarseMeshFromName(const std::string& name)
{
    if (name == "sphere") return makeSphere(96, 48);
    if (name == "knot") return makeKnot(160, 32);
    return std::nullopt;
}

Bounds boundsOf(const Mesh& mesh)
{
    if (mesh.positions.empty()) return {};
    Vec3f low = mesh.positions.front(), high = low;
    for (const Vec3f& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    Bounds bounds{0.5f * (low + high), 0.0f};
    for (const Vec3f& p : mesh.positions)
        bounds.radius = std::max(bounds.radius, glm::distance(p, bounds.centre));
    return bounds;
}

}  // namespace fbrdf::scene
