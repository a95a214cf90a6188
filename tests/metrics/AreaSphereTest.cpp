// AreaSphereTest.cpp - the scene of area lights: lobes against points of the lights, and that a
// difference is seen.
#include <fbrdf/metrics/AreaSphere.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

Vec3d lambert(const Vec3d&, const Vec3d& wi)
{
    return wi.z > 0.0 ? Vec3d(0.5 / kPi) : Vec3d(0.0);
}

/// A cosine of some albedo alone.
LobeTable cosineTable(float albedo)
{
    LobeTable table;
    table.lobes = 1;
    table.thetas = 2;
    table.knots.resize(2);
    for (LobeKnot& knot : table.knots) knot.cosine = Vec3f(albedo);
    return table;
}

TEST(AreaSphere, LobesOfALambertianAreItsTruth)
{
    const AreaSphere sphere(comparedAreaLights(), 6, 1);
    const auto truth = sphere.truth(lambert), lit = sphere.lit(cosineTable(0.5f)),
               wrong = sphere.lit(cosineTable(0.52f));
    ASSERT_EQ(truth.size(), sphere.lights().size());
    for (size_t light = 0; light < truth.size(); ++light) {
        const auto errors = sphere.errors(lit[light], truth[light], light),
                   others = sphere.errors(wrong[light], truth[light], light);
        EXPECT_GT(errors.psnr, 55.0) << sphere.lights()[light].name;
        EXPECT_LT(errors.reflected, 2e-3) << sphere.lights()[light].name;
        EXPECT_LT(errors.largest, 5e-3) << sphere.lights()[light].name;
        EXPECT_NEAR(others.reflected, 0.04, 3e-3) << sphere.lights()[light].name;
        EXPECT_LE(errors.rms, errors.largest);
        EXPECT_LT(others.psnr, errors.psnr - 5.0);
    }
}

TEST(AreaSphere, RectanglesShineTowardsIt)
{
    const AreaSphere sphere(comparedAreaLights(), 8, 1);
    const auto lit = sphere.lit(cosineTable(1.0f));
    for (size_t light = 0; light < lit.size(); ++light) {
        double largest = 0.0;
        for (const Vec3d& value : lit[light]) largest = std::max(largest, value.x);
        EXPECT_GT(largest, 0.01) << sphere.lights()[light].name;
    }
}

}  // namespace
