// RasterTest.cpp - coverage, depth and interpolation against closed forms; no GL (RasterGLTest has
// GL's own coverage).
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Raster.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

/// A picture of width x height where object space is pixels, y up, z in [-1, 1] towards the eye.
gl::View pixelView(int width, int height)
{
    gl::View view;
    view.projection = glm::mat4(2.0f / static_cast<float>(width), 0, 0, 0,   //
                                0, 2.0f / static_cast<float>(height), 0, 0,  //
                                0, 0, -1, 0,                                 //
                                -1, -1, 0, 1);
    return view;
}

Mesh triangles(const std::vector<Vec3f>& corners)
{
    Mesh mesh;
    mesh.positions = corners;
    mesh.normals.assign(corners.size(), {0.0f, 0.0f, 1.0f});
    for (uint32_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(i);
    return mesh;
}

int coveredCount(const Fragments& fragments)
{
    int count = 0;
    for (const Fragment& fragment : fragments.pixels) count += fragment.covered();
    return count;
}

TEST(Raster, FillsExactlyThePixelsWhoseCentresAreInside)
{
    const Mesh mesh = triangles({{2, 1, 0}, {7, 1, 0}, {7, 5, 0}, {2, 1, 0}, {7, 5, 0}, {2, 5, 0}});
    const Fragments f = rasterise({{&mesh}}, pixelView(10, 8), 10, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 10; ++x)  // row 0 is the top: y up from the bottom is 7 - row
            EXPECT_EQ(f.at(x, y).covered(), x >= 2 && x < 7 && 7 - y >= 1 && 7 - y < 5)
                << x << ", " << y;
}

TEST(Raster, PixelsOnSharedEdgesBelongToOneTriangle)
{
    // A fan whose edges all run through pixel centres: each centre inside is seen by one triangle.
    const Vec3f c(8.5f, 8.5f, 0.0f);
    const std::vector<Vec3f> ring{{2.5f, 2.5f, 0},  {8.5f, 2.5f, 0},   {14.5f, 2.5f, 0},
                                  {14.5f, 8.5f, 0}, {14.5f, 14.5f, 0}, {8.5f, 14.5f, 0},
                                  {2.5f, 14.5f, 0}, {2.5f, 8.5f, 0}};
    std::vector<int> hits(17 * 17, 0);
    for (size_t i = 0; i < ring.size(); ++i) {
        const Mesh mesh = triangles({c, ring[i], ring[(i + 1) % ring.size()]});
        const Fragments f = rasterise({{&mesh}}, pixelView(17, 17), 17, 17);
        for (size_t k = 0; k < hits.size(); ++k) hits[k] += f.pixels[k].covered();
    }
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 17; ++x) {
            const int up = 16 - y, hit = hits[static_cast<size_t>(17 * y + x)];
            // Left and bottom edges belong to the square, right and top ones do not.
            EXPECT_EQ(hit, x >= 2 && x < 14 && up >= 2 && up < 14 ? 1 : 0) << x << ", " << up;
        }
}

TEST(Raster, SnapsCornersToSubPixels)
{
    // The left edge is 1/1024 beyond the centres of column 2: snapped, it runs through them.
    const float edge = 2.5f + 1.0f / 1024.0f;
    const Mesh near = triangles({{edge, 0, 0}, {6, 0, 0}, {edge, 8, 0}});
    EXPECT_TRUE(rasterise({{&near}}, pixelView(8, 8), 8, 8).at(2, 6).covered());
    const float far = 2.5f + 1.0f / 256.0f;
    const Mesh beyond = triangles({{far, 0, 0}, {6, 0, 0}, {far, 8, 0}});
    EXPECT_FALSE(rasterise({{&beyond}}, pixelView(8, 8), 8, 8).at(2, 6).covered());
}

TEST(Raster, NearerTrianglesWinWhateverTheirOrderAndSide)
{
    const Mesh back = triangles({{0, 0, -0.5f}, {8, 0, -0.5f}, {0, 8, -0.5f}});
    const Mesh front = triangles({{0, 0, 0.5f}, {0, 8, 0.5f}, {8, 0, 0.5f}});  // clockwise
    for (const auto& instances :
         {std::vector<Instance>{{&back}, {&front}}, std::vector<Instance>{{&front}, {&back}}}) {
        const Fragments f = rasterise(instances, pixelView(8, 8), 8, 8);
        EXPECT_GT(coveredCount(f), 20);
        for (const Fragment& fragment : f.pixels)
            if (fragment.covered()) {
                EXPECT_EQ(instances[static_cast<size_t>(fragment.instance)].mesh, &front);
                EXPECT_NEAR(fragment.depth, -0.5, 1e-6);
            }
    }
}

TEST(Raster, InterpolatesWithPerspective)
{
    // The plane seen from the side: the point seen by a pixel must project to its centre.
    const Mesh mesh = makePlane(1);
    Camera camera;
    camera.eye = {1.5, 0.7, 1.2};
    const int width = 64, height = 48;
    const gl::View view = viewFromCamera(camera, double(width) / height, boundsOf(mesh));
    const Fragments f = rasterise({{&mesh}}, view, width, height);
    EXPECT_GT(coveredCount(f), 300);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!f.at(x, y).covered()) continue;
            const Vec3d p = interpolate<Vec3d>(mesh.positions, mesh, f.at(x, y));
            const glm::dvec4 clip =
                glm::dmat4(view.projection) * (glm::dmat4(view.view) * glm::dvec4(p, 1.0));
            EXPECT_NEAR((clip.x / clip.w + 1.0) * 0.5 * width, x + 0.5, 1e-9);
            EXPECT_NEAR((1.0 - clip.y / clip.w) * 0.5 * height, y + 0.5, 1e-9);
            EXPECT_NEAR(clip.z / clip.w, f.at(x, y).depth, 1e-9);
        }
}

TEST(Raster, CutsTrianglesAtTheNearPlane)
{
    // A floor that reaches from far in front to far behind the eye fills the lower half.
    const float big = 1000.0f;
    const Mesh floor = triangles({{-big, -1, big},
                                  {big, -1, big},
                                  {big, -1, -big},
                                  {-big, -1, big},
                                  {big, -1, -big},
                                  {-big, -1, -big}});
    Camera camera;
    camera.eye = {0.0, 0.0, 0.0};
    camera.centre = {0.0, 0.0, -1.0};
    const gl::View view = viewFromCamera(camera, 1.0, {Vec3f(0.0f), 2.0f * big});
    const Fragments f = rasterise({{&floor}}, view, 32, 32);
    for (int x = 0; x < 32; ++x) {
        EXPECT_FALSE(f.at(x, 3).covered());
        EXPECT_TRUE(f.at(x, 17).covered());
        EXPECT_NEAR(interpolate<Vec3d>(floor.positions, floor, f.at(x, 17)).y, -1.0, 1e-6);
    }
}

TEST(Raster, SurvivesHugeAndDegenerateTriangles)
{
    const float huge = 1e30f;
    const Mesh mesh = triangles({{-huge, -huge, 0},
                                 {huge, -huge, 0},
                                 {0, huge, 0},  //
                                 {1, 1, 0},
                                 {1, 1, 0},
                                 {5, 5, 0},  //
                                 {1, 1, 0},
                                 {3, 3, 0},
                                 {5, 5, 0}});
    EXPECT_EQ(coveredCount(rasterise({{&mesh}}, pixelView(8, 8), 8, 8)), 64);
    EXPECT_EQ(coveredCount(rasterise({}, pixelView(8, 8), 8, 8)), 0);
}

TEST(Raster, MovesInstancesByTheirMatrix)
{
    const Mesh mesh = triangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
    Instance moved{&mesh};
    moved.model[3] = glm::vec4(5, 3, 0, 1);
    const Fragments f = rasterise({{&mesh}, moved}, pixelView(12, 8), 12, 8);
    for (int y = 3; y < 8; ++y)
        for (int x = 5; x < 12; ++x) {
            if (f.at(x - 5, y).covered() && f.at(x - 5, y).instance == 0) {
                EXPECT_EQ(f.at(x, y - 3).instance, 1) << x << ", " << y;
            }
        }
}

}  // namespace
}  // namespace fbrdf::scene
