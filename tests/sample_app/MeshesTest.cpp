// MeshesTest.cpp - the generated meshes against their closed forms; no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Meshes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace fbrdf::scene {
namespace {

// Coordinates are floats near 1: a few units in the last place.
constexpr float kTight = 1e-6f;

/// Positions as the mesh joins them: poles are many vertices at one place.
using Place = std::tuple<float, float, float>;
Place placeOf(const Mesh& mesh, uint32_t index)
{
    const Vec3f& p = mesh.positions[index];
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};  // -0 and 0 are one place
}

/// How often each directed edge occurs.
std::map<std::pair<Place, Place>, int> directedEdges(const Mesh& mesh)
{
    std::map<std::pair<Place, Place>, int> edges;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k)
            ++edges[{placeOf(mesh, mesh.indices[i + k]),
                     placeOf(mesh, mesh.indices[i + (k + 1) % 3])}];
    return edges;
}

/// Closed and consistently wound: every edge occurs once in each direction.
bool isWatertight(const Mesh& mesh)
{
    const auto edges = directedEdges(mesh);
    for (const auto& [edge, count] : edges) {
        const auto reverse = edges.find({edge.second, edge.first});
        if (count != 1 || reverse == edges.end() || reverse->second != 1) return false;
    }
    return !edges.empty();
}

/// V - E + F of the joined mesh: 2 for a sphere, 0 for a torus or a knot.
int eulerCharacteristic(const Mesh& mesh)
{
    std::set<Place> places;
    for (const uint32_t index : mesh.indices) places.insert(placeOf(mesh, index));
    const int edges = static_cast<int>(directedEdges(mesh).size() / 2);
    return static_cast<int>(places.size()) - edges + static_cast<int>(mesh.indices.size() / 3);
}

/// Volume enclosed: > 0 when triangles are counter-clockwise seen from outside.
double signedVolume(const Mesh& mesh)
{
    double volume = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

/// Smallest cosine between a face's own normal and those of its corners.
double worstFacing(const Mesh& mesh)
{
    double worst = 1.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        const Vec3d face = glm::normalize(glm::cross(b - a, c - a));
        for (size_t k = 0; k < 3; ++k)
            worst = std::min(worst, glm::dot(face, Vec3d(mesh.normals[mesh.indices[i + k]])));
    }
    return worst;
}

void expectUnitFrames(const Mesh& mesh)
{
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, kTight) << "vertex " << i;
        ASSERT_NEAR(glm::length(mesh.tangents[i]), 1.0f, kTight) << "vertex " << i;
        ASSERT_NEAR(glm::dot(mesh.normals[i], mesh.tangents[i]), 0.0f, kTight) << "vertex " << i;
    }
    for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
}

TEST(Watertight, RejectsAHoleAndATurnedTriangle)
{
    Mesh mesh = makeSphere(8, 4);
    std::swap(mesh.indices[0], mesh.indices[1]);
    EXPECT_FALSE(isWatertight(mesh));
    mesh = makeSphere(8, 4);
    mesh.indices.resize(mesh.indices.size() - 3);
    EXPECT_FALSE(isWatertight(mesh));
    EXPECT_FALSE(isWatertight(makePlane(2)));
}

TEST(Sphere, IsUnitWithItsPositionsAsNormals)
{
    const Mesh mesh = makeSphere(32, 16);
    expectUnitFrames(mesh);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_EQ(mesh.positions[i], mesh.normals[i]);
}

TEST(Sphere, IsWatertightAndFacesOutward)
{
    for (const auto& [segments, rings] : {std::pair(3, 2), std::pair(7, 5), std::pair(64, 32)}) {
        const Mesh mesh = makeSphere(segments, rings);
        EXPECT_TRUE(isWatertight(mesh)) << segments << " x " << rings;
        EXPECT_EQ(eulerCharacteristic(mesh), 2);
        EXPECT_GT(signedVolume(mesh), 0.0);
        EXPECT_EQ(mesh.indices.size(), static_cast<size_t>(6 * segments * (rings - 1)));
    }
    // An inscribed sphere loses 1 - O(1/n^2) of 4 pi / 3.
    EXPECT_NEAR(signedVolume(makeSphere()), 4.0 * kPi / 3.0, 2e-3);
    EXPECT_GT(worstFacing(makeSphere()), 0.999);
}

TEST(Sphere, TangentFollowsIncreasingAzimuthAboutY)
{
    const Mesh mesh = makeSphere(32, 16);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3f n = mesh.normals[i], t = mesh.tangents[i];
        const Vec3f expected(n.z, 0.0f, -n.x);  // y cross n
        if (glm::length(expected) < 1e-3f) continue;
        EXPECT_NEAR(glm::dot(t, glm::normalize(expected)), 1.0f, kTight) << "vertex " << i;
    }
}

TEST(Sphere, PolesHaveTheTangentOfTheTriangleThatTheyClose)
{
    const int segments = 16;
    const Mesh mesh = makeSphere(segments, 8);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        if (std::abs(mesh.positions[mesh.indices[i]].y) < 1.0f) continue;
        const Vec3f t = mesh.tangents[mesh.indices[i]];
        for (size_t k = 1; k < 3; ++k)  // half a segment away on either side
            EXPECT_NEAR(glm::dot(t, mesh.tangents[mesh.indices[i + k]]),
                        std::cos(float(kPi) / segments), kTight);
    }
}

TEST(Knot, IsWatertightAndFacesOutward)
{
    const Mesh mesh = makeKnot(128, 24);
    expectUnitFrames(mesh);
    EXPECT_TRUE(isWatertight(mesh));
    EXPECT_EQ(eulerCharacteristic(mesh), 0);
    EXPECT_GT(signedVolume(mesh), 0.0);
    // 64 facets around are 5.6 degrees wide, and the twist of Frenet's frame shears them.
    EXPECT_GT(worstFacing(makeKnot()), std::cos(12.0 * kPi / 180.0));
}

/// Pappus: the volume of a tube that does not touch itself is its section times its length.
TEST(Knot, TubeHasTheVolumeOfItsSectionTimesItsLength)
{
    const int along = 512, around = 64;
    const Mesh mesh = makeKnot(along, around);
    std::vector<Vec3d> centers;
    for (int ring = 0; ring < along; ++ring) {
        Vec3d sum(0.0);
        for (int i = 0; i < around; ++i)
            sum += Vec3d(mesh.positions[static_cast<size_t>(ring * around + i)]);
        centers.push_back(sum / double(around));
    }
    double length = 0.0;
    for (size_t i = 0; i < centers.size(); ++i)
        length += glm::distance(centers[i], centers[(i + 1) % centers.size()]);
    const double radius = glm::distance(Vec3d(mesh.positions[0]), centers[0]);
    EXPECT_NEAR(signedVolume(mesh) / (kPi * radius * radius * length), 1.0, 5e-3);
}

TEST(Knot, TubeNeitherTouchesItselfNorLeavesTheDefaultView)
{
    const int along = 512, around = 64;
    const Mesh mesh = makeKnot(along, around);
    for (const Vec3f& p : mesh.positions) EXPECT_LT(glm::length(p), 1.2f);
    // Points of one ring and of rings a sixth of the way and more along the knot: never nearer
    // than a quarter of the tube's radius.
    for (int a = 0; a < along; a += 8)
        for (int b = a + along / 6; b < a + along - along / 6; b += 8)
            for (int i = 0; i < around; i += 4)
                for (int j = 0; j < around; j += 4)
                    ASSERT_GT(glm::distance(
                                  mesh.positions[static_cast<size_t>(a * around + i)],
                                  mesh.positions[static_cast<size_t>((b % along) * around + j)]),
                              0.05f);
}

TEST(Knot, TangentRunsAlongTheTube)
{
    const int along = 512, around = 64;
    const Mesh mesh = makeKnot(along, around);
    for (int ring = 0; ring < along; ring += 16) {
        // All tangents of a ring agree, and the ring lies in the plane across them.
        const size_t first = static_cast<size_t>(ring * around);
        for (size_t i = 1; i < static_cast<size_t>(around); ++i) {
            EXPECT_NEAR(glm::dot(mesh.tangents[first], mesh.tangents[first + i]), 1.0f, kTight);
            const Vec3f across = mesh.positions[first + i] - mesh.positions[first];
            EXPECT_NEAR(glm::dot(across, mesh.tangents[first]), 0.0f, kTight);
        }
    }
}

TEST(Plane, IsTheSquareAtZeroFacingZ)
{
    for (const int cells : {1, 4}) {
        const Mesh mesh = makePlane(cells);
        expectUnitFrames(mesh);
        EXPECT_EQ(mesh.indices.size(), static_cast<size_t>(6 * cells * cells));
        EXPECT_GT(worstFacing(mesh), 1.0 - 1e-6);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_LE(std::abs(mesh.positions[i].x), 1.0f);
            EXPECT_LE(std::abs(mesh.positions[i].y), 1.0f);
            EXPECT_EQ(mesh.positions[i].z, 0.0f);
            EXPECT_EQ(mesh.tangents[i], Vec3f(1.0f, 0.0f, 0.0f));
        }
        EXPECT_NEAR(boundsOf(mesh).radius, std::sqrt(2.0f), kTight);
    }
}

TEST(Bounds, OfAShiftedMeshFollowIt)
{
    Mesh mesh = makeSphere(16, 8);
    for (Vec3f& p : mesh.positions) p = 2.0f * p + Vec3f(3.0f, -1.0f, 5.0f);
    const Bounds bounds = boundsOf(mesh);
    EXPECT_NEAR(glm::distance(bounds.centre, Vec3f(3.0f, -1.0f, 5.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(bounds.radius, 2.0f, 1e-5f);
    EXPECT_EQ(boundsOf(Mesh()).radius, 0.0f);
}

TEST(MeshFromName, KnowsTheGeneratedOnesAndRefusesAFileThatIsNotThere)
{
    EXPECT_EQ(meshFromName("sphere").positions.size(), makeSphere().positions.size());
    EXPECT_EQ(meshFromName("knot").positions.size(), makeKnot().positions.size());
    EXPECT_EQ(meshFromName("plane").positions.size(), makePlane().positions.size());
    try {
        meshFromName("no/such/mesh.obj");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find("no/such/mesh.obj"), std::string::npos);
    }
}

TEST(CoarseMeshFromName, LooksTheSameWithFarFewerTriangles)
{
    for (const char* name : {"sphere", "knot"}) {
        const Mesh whole = meshFromName(name);
        const std::optional<Mesh> coarse = coarseMeshFromName(name);
        ASSERT_TRUE(coarse);
        EXPECT_LE(6 * coarse->indices.size(), whole.indices.size());
        EXPECT_NEAR(boundsOf(*coarse).radius, boundsOf(whole).radius, 1e-3);
        EXPECT_NEAR(signedVolume(*coarse) / signedVolume(whole), 1.0, 0.02);
    }
    EXPECT_FALSE(coarseMeshFromName("plane"));
    EXPECT_FALSE(coarseMeshFromName("no/such/mesh.obj"));
}

}  // namespace
}  // namespace fbrdf::scene
