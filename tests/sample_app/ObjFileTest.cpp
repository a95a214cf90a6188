// ObjFileTest.cpp - OBJ text to mesh: what is read, what is made up, and what is refused; no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/plan/Triangulate.h>
#include <fbrdf/scene/ObjFile.h>
#include <fbrdf/scene/TextFile.h>
#include <fbrdf/scene/VertexFrames.h>
#include <gtest/gtest.h>
#include <support/DataDir.h>

#include <cmath>
#include <filesystem>
#include <random>

namespace fbrdf::scene {
namespace {

constexpr float kTight = 1e-6f;

/// A tetrahedron with everything: normals, texture coordinates, tangents, comments.
const char* const kEverything = R"(# a comment
mtllib none.mtl
o thing
v 0 0 0
v 1 0 0
v 0 1 0   # trailing
v 0 0 1
vt 0 0
vt 1 0
vt 0 1 0
vn 0 0 -2
vn 0 -1 0
vn -1 0 0
r 1 0 1
r 1 0 0
r 0 1 0
g side
usemtl red
s off
f 1/1/1 3/3/1 2/2/1
f 1//2 2//2 4//2
f -4/-3/-1 -1/-1/-1 -2/-2/-1
)";

std::string errorOf(const std::string& text)
{
    try {
        parseObj(text, "x.obj");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.what();
    }
    return {};
}

double areaOf(const Mesh& mesh)
{
    double area = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

void expectValid(const Mesh& mesh)
{
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, kTight);
        ASSERT_NEAR(glm::length(mesh.tangents[i]), 1.0f, kTight);
        ASSERT_NEAR(glm::dot(mesh.normals[i], mesh.tangents[i]), 0.0f, kTight);
    }
}

TEST(Obj, ReadsPositionsNormalsTangentsAndRelativeIndices)
{
    const Mesh mesh = parseObj(kEverything, "x.obj");
    expectValid(mesh);
    ASSERT_EQ(mesh.positions.size(), 9u);
    ASSERT_EQ(mesh.indices.size(), 9u);
    EXPECT_EQ(mesh.positions[1], Vec3f(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(mesh.normals[0], Vec3f(0.0f, 0.0f, -1.0f));
    EXPECT_EQ(mesh.tangents[0], Vec3f(1.0f, 0.0f, 0.0f)) << "made orthogonal to the normal";
    EXPECT_EQ(mesh.positions[7], Vec3f(0.0f, 0.0f, 1.0f)) << "-1 is the last position";
    EXPECT_EQ(mesh.normals[8], Vec3f(-1.0f, 0.0f, 0.0f));
}

TEST(Obj, SharesVerticesOfEqualCornersOnly)
{
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_EQ(parseObj(square + "f 1 2 3\nf 1 3 4\n", "x").positions.size(), 4u);
    const std::string split = "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n";
    EXPECT_EQ(parseObj(square + split, "x").positions.size(), 6u);
}

TEST(Obj, CutsPolygonsOfAnyShape)
{
    // An arrow head: a fan from its first corner would cover the notch too.
    const Mesh arrow = parseObj("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n", "x");
    EXPECT_EQ(arrow.indices.size(), 6u);
    EXPECT_NEAR(areaOf(arrow), 1.0, 1e-9);
    const Mesh late = parseObj("v 1 1 0\nv 0 0 0\nv 2 1 0\nv 0 2 0\nf 2 3 4 1\n", "x");
    EXPECT_NEAR(areaOf(late), 1.0, 1e-9);
}

TEST(Obj, ContinuedLinesAndWindowsLineEndsAreRead)
{
    const Mesh mesh = parseObj("v 0 0 0\r\nv 1 0 \\\n 0\nv 0 1 0\r\nf 1 \\\n2 3\r\n", "x");
    EXPECT_EQ(mesh.indices.size(), 3u);
}

TEST(Obj, MakesSmoothNormalsAcrossSeams)
{
    // Two faces of a roof along x: the ridge's normal points up although texture coordinates split
    // its vertices.
    const Mesh mesh = parseObj(
        "v 0 0 1\nv 1 0 1\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 0 0 -1\nvt 0 0\nvt 1 1\n"
        "f 1/1 2/1 3/1 4/1\nf 4/2 3/2 5/2 6/2\n",
        "x");
    expectValid(mesh);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].y == 1.0f) {
            EXPECT_NEAR(mesh.normals[i].y, 1.0f, kTight);
        }
}

TEST(Obj, MakesTangentsAlongGrowingU)
{
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const Mesh turned =
        parseObj(corners + "vt 0 0\nvt 0 -1\nvt 1 -1\nvt 1 0\nf 1/1 2/2 3/3 4/4\n", "x");
    expectValid(turned);
    for (const Vec3f& t : turned.tangents) EXPECT_NEAR(t.y, 1.0f, kTight);
    const Mesh mirrored =
        parseObj(corners + "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n", "x");
    for (const Vec3f& t : mirrored.tangents) EXPECT_NEAR(t.x, -1.0f, kTight);
}

TEST(Obj, WithoutCoordinatesTangentsFollowTheAzimuth)
{
    const Mesh mesh = parseObj("v 0 0 2\nv 1 0 2\nv 1 1 2\nf 1 2 3\n", "x");
    expectValid(mesh);
    for (const Vec3f& t : mesh.tangents) EXPECT_NEAR(t.x, 1.0f, kTight);
}

TEST(Obj, RepairsNormalsOfNoLengthAndFacesOfNoArea)
{
    const Mesh flat = parseObj("v 0 0 0\nv 0 1 0\nv 1 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\n", "x");
    expectValid(flat);
    EXPECT_NEAR(flat.normals[0].z, -1.0f, kTight);
    expectValid(parseObj("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "x"));
    expectValid(parseObj("v 0 0 0\nf 1 1 1\n", "x"));
}

TEST(Obj, NamesTheLineOfAnError)
{
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::pair<const char*, const char*> cases[] = {
        {"v 1 2\n", "x.obj:4: found the end of the line, expected a finite number for a position"},
        {"v 1 2 three\n", "x.obj:4: found 'three'"},
        {"v 1 2 nan\n", "x.obj:4: found 'nan'"},
        {"v 1 2 1e99\n", "x.obj:4: found '1e99'"},
        {"vn 1 0 inf\n", "x.obj:4: found 'inf', expected a finite number for a normal"},
        {"vt\n", "x.obj:4: found the end of the line, expected a finite number for a texture"},
        {"f 1 2\n", "x.obj:4: found a face of 2 corners, expected 3 to"},
        {"f 1 2 4\n", "x.obj:4: found '4', expected a position among the 3 so far"},
        {"f 1 2 0\n", "x.obj:4: found '0'"},
        {"f 1 2 -4\n", "x.obj:4: found '-4'"},
        {"f 1 2 99999999999\n", "x.obj:4: found '99999999999', expected the index"},
        {"f 1 2 x\n", "x.obj:4: found 'x', expected the index of a position"},
        {"f 1/1 2/1 3/1\n", "x.obj:4: found '1', expected a texture coordinate among the 0"},
        {"f 1//1 2//1 3//1\n", "x.obj:4: found '1', expected a normal among the 0"},
        {"r 1 0 0\nf 1 2 3\n", "x.obj: found 1 tangents (r lines), expected 3, one for each v"},
        {"", "x.obj: found no face, expected a Wavefront OBJ mesh"},
    };
    for (const auto& [tail, expected] : cases)
        EXPECT_EQ(errorOf(head + tail).substr(0, std::string(expected).size()), expected);
}

TEST(Obj, EveryPrefixIsReadOrRefusedByName)
{
    const std::string text = kEverything;
    int read = 0;
    for (size_t size = 0; size <= text.size(); ++size) try {
            expectValid(parseObj(text.substr(0, size), "x.obj"));
            ++read;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_EQ(std::string(error.what()).substr(0, 5), "x.obj");
        }
    EXPECT_GT(read, 0);
}

TEST(Obj, NoisyTextNeverCrashes)
{
    std::mt19937 engine(1);
    for (int round = 0; round < 3000; ++round) {
        std::string text = kEverything;
        for (int k = 0; k < 4; ++k)
            text[engine() % text.size()] = static_cast<char>(engine() % 256);
        try {
            expectValid(parseObj(text, "x.obj"));
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
        }
    }
}

TEST(Obj, RefusesAFaceOfTooManyCornersInsteadOfTakingHours)
{
    std::string text = "v 0 0 0\nf";
    for (int i = 0; i < 5000; ++i) text += " 1";
    EXPECT_NE(errorOf(text).find("5000 corners"), std::string::npos);
}

TEST(Obj, AFolderIsNoFile)
{
    try {
        readObj(std::filesystem::temp_directory_path().string());
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("found a folder"), std::string::npos);
    }
}

TEST(Obj, ReadsTheWaterlooKnotWithItsTangents)
{
    FBRDF_NEEDS_DATA("meshes/knot25.obj");
    const std::string path = test::dataPath("meshes/knot25.obj");
    const Mesh mesh = readObj(path);
    expectValid(mesh);
    EXPECT_EQ(mesh.indices.size(), 3u * 1250u);
    // Line 5 of the file: r -0.000000 0.894427 0.447214 belongs to the normal (-1, 0, 0).
    bool found = false;
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (glm::distance(mesh.positions[i], Vec3f(1.3f, 0.0f, 0.0f)) < kTight) {
            found = true;
            EXPECT_NEAR(glm::dot(mesh.tangents[i], Vec3f(0.0f, 0.894427f, 0.447214f)), 1.0f, 1e-5f);
        }
    EXPECT_TRUE(found);
    // Outward: normals agree with the winding of the faces.
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3f a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                    c = mesh.positions[mesh.indices[i + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), mesh.normals[mesh.indices[i]]), 0.0f);
    }
}

TEST(Triangulate, KeepsAreaAndOrientationOfStars)
{
    // Stars with 5 to 40 points have as many notches; their area is n r R sin(pi / n).
    for (int points = 5; points <= 40; points += 5) {
        std::vector<Vec3d> corners;
        for (int i = 0; i < 2 * points; ++i) {
            const double radius = i % 2 ? 0.4 : 1.0, angle = kPi * i / points;
            corners.emplace_back(radius * std::cos(angle), 0.3, -radius * std::sin(angle));
        }
        double area = 0.0;
        for (const auto& [a, b, c] : triangulate(corners)) {
            const Vec3d &pa = corners[static_cast<size_t>(a)],
                        &pb = corners[static_cast<size_t>(b)],
                        &pc = corners[static_cast<size_t>(c)];
            const double y = 0.5 * glm::cross(pb - pa, pc - pa).y;
            EXPECT_GT(y, 0.0);
            area += y;
        }
        EXPECT_NEAR(area, points * 0.4 * std::sin(kPi / points), 1e-9);
    }
}

TEST(Triangulate, EndsOnPolygonsWithoutEars)
{
    const std::vector<Vec3d> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(triangulate(line).size(), 3u);
    const std::vector<Vec3d> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(triangulate(bow).size(), 2u);
}

TEST(SmoothNormals, OfACubeCornerPointAlongItsDiagonal)
{
    // Angle weights make the three faces count alike although one is cut into two triangles there.
    const std::vector<Vec3f> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                               {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    const std::vector<uint32_t> indices{0, 4, 1, 0, 2, 4, 0, 3, 2, 0, 1, 3};
    const Vec3f normal = smoothNormals(p, indices)[0];
    EXPECT_NEAR(glm::dot(normal, glm::normalize(Vec3f(-1.0f))), 1.0f, kTight);
}

}  // namespace
}  // namespace fbrdf::scene
