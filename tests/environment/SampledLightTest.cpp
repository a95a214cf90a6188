// SampledLightTest.cpp - directions that are drawn, each looked up at its own level, against the
// sum over every texel.
#include <fbrdf/brdf/SampleLattice.h>
#include <fbrdf/environment/EnvironmentTruth.h>
#include <fbrdf/environment/SampledLight.h>
#include <gtest/gtest.h>

#include "Panoramas.h"

#include <cmath>
#include <set>

using namespace fbrdf;

namespace {

TEST(SampleLattice, HasEveryCoordinateOnce)
{
    for (const int count : {1, 2, 7, 64, 610, 4096}) {
        const Vec2<float> lattice(static_cast<float>(count),
                                  static_cast<float>(latticeStep(count)));
        std::set<int> columns, rows;
        for (int i = 0; i < count; ++i) {
            const Vec2<float> point = samplePoint(static_cast<float>(i), lattice);
            EXPECT_GT(point.x, 0.0f);
            EXPECT_LT(point.y, 1.0f);
            columns.insert(static_cast<int>(point.x * lattice.x));
            rows.insert(static_cast<int>(point.y * lattice.x));
        }
        EXPECT_EQ(columns.size(), static_cast<size_t>(count));
        EXPECT_EQ(rows.size(), static_cast<size_t>(count));
    }
}

/// Not the lobes themselves, so that the estimate has a variance.
Vec3d reflectance(const Vec3d& wo, const Vec3d& wi)
{
    if (!(wi.z > 0.0)) return Vec3d(0.0);
    const double c = glm::dot(wi, Vec3d(-wo.x, -wo.y, wo.z));
    return Vec3d(0.3, 0.2, 0.1) / kPi + Vec3d(0.2 * stretchedCosine(c, 0.25) / std::max(0.3, wi.z));
}

LobeTable lobes()
{
    LobeTable table;
    table.lobes = 1;
    table.thetas = 2;
    table.knots.resize(2);
    for (LobeKnot& knot : table.knots) {
        knot.cosine = {0.3f, 0.2f, 0.1f};
        knot.lobes[0] = {Vec3f(0.2f), 4.0f, 0.0f};
    }
    return table;
}

/// Root of mean squares of the difference to the truth, over normals, relative to its mean.
double errorOf(const Panorama& panorama, const CubeImage& cube, int samples)
{
    const EnvironmentTruth truth({panorama});
    double squares = 0.0, mean = 0.0;
    constexpr int kNormals = 24;
    for (int i = 0; i < kNormals; ++i) {
        const double z = 0.95 - 0.85 * i / (kNormals - 1.0), phi = 2.4 * i;
        const Vec3d normal(std::sqrt(1 - z * z) * std::cos(phi),
                           std::sqrt(1 - z * z) * std::sin(phi), z);
        const auto frame = shadingFrame<double>(normal, Vec3d(normal.z, 0.0, -normal.x));
        const Vec3d viewer(0.0, 0.0, 1.0);
        const Vec3d exact = truth.reflected(reflectance, frame, viewer)[0],
                    found = sampledLight(cube, lobes(), reflectance, frame, frame.local(viewer),
                                         samples);
        squares += glm::dot(found - exact, found - exact) / (3.0 * kNormals);
        mean += (exact.x + exact.y + exact.z) / (3.0 * kNormals);
    }
    return std::sqrt(squares) / mean;
}

TEST(SampledLight, ComesNearerToTheSumOverTexelsWithMoreDirections)
{
    // Smooth, with a bright half and a few lamps.
    const Panorama panorama = panoramaOf(64, 32, [](const Vec3d& d) {
        const double lamp = d.x > 0.6 && std::abs(d.y) < 0.2 ? 4.0 : 0.0;
        return Vec3d(1.2 + d.x + lamp, 1.1 + d.y * d.z + lamp, 1.3 + std::sin(3.0 * d.z));
    });
    const CubeImage cube = cubeOfPanorama(panorama, 64);
    const double few = errorOf(panorama, cube, 4), some = errorOf(panorama, cube, 16),
                 many = errorOf(panorama, cube, 64), most = errorOf(panorama, cube, 1024);
    EXPECT_LT(some, 0.6 * few);
    EXPECT_LT(many, 0.6 * some);
    EXPECT_LT(most, many);
    EXPECT_LT(many, 0.02);
    EXPECT_LT(most, 0.005);
}

TEST(SampledLight, OfOneEverywhereIsTheAlbedo)
{
    const CubeImage white{1, {std::vector<Vec3f>(6, Vec3f(1.0f))}};
    const auto frame = shadingFrame<double>(Vec3d(0, 0, 1), Vec3d(1, 0, 0));
    const Vec3d wo(std::sin(0.5), 0.0, std::cos(0.5));
    const Vec3d few = sampledLight(white, lobes(), reflectance, frame, wo, 64),
                many = sampledLight(white, lobes(), reflectance, frame, wo, 4096);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(few[c], many[c], 0.02 * many[c]);
    // The diffuse part is exact; the highlight reflects less than 0.2 / 0.3 of its cosine.
    EXPECT_GT(many.x, 0.3);
    EXPECT_LT(many.x, 0.3 + 0.2 / 0.3);
}

}  // namespace
