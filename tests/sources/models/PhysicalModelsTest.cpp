// PhysicalModelsTest.cpp - He-Torrance and Disney against limits, and against the published
// formulas written a second time, in Python, as plainly as they stand in the papers.
#include "ExpectedValues.h"
#include "Pairs.h"

#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

// In Python: G of Eq. 76 from its s and p vectors, z0 of Eq. 81 by bisection, 60000 terms of
// Eq. 78.
TEST(HeTorrance, AgreesWithAnotherImplementation)
{
    expectValues("he-torrance:f0=0.9,sigma=0.3,tau=3",
                 {{2.11861855267, 2.11127290844, 2.10239455573},
                  {1.09129393265, 1.10427797885, 1.12322670712},
                  {2.82566088159e-07, 1.43440740954e-07, 5.12795193432e-08}});
    expectValues("he-torrance:f0=0.5,sigma=0.1,tau=1",
                 {{1.16103533279, 1.20382508924, 1.22470798216},
                  {0.541875042483, 0.577755637644, 0.595254218771},
                  {0.000132658442182, 7.47635203279e-05, 2.88119784879e-05}});
    expectValues("he-torrance:f0=0.7,sigma=0.5,tau=1",
                 {{0.0806238435909, 0.0803999916922, 0.0801352830264},
                  {0.172522964609, 0.170246981254, 0.167625724084},
                  {0.117174001287, 0.11802952384, 0.119061565118}});
}

TEST(HeTorrance, AgreesWithAnotherImplementationWhereItSkipsTerms)
{
    expectValues("he-torrance:f0=0.9,sigma=2,tau=8",
                 {{0.42228416675, 0.422218294903, 0.422139483404},
                  {1.15619667555, 1.15597705061, 1.15571276603},
                  {0.0210601092487, 0.0210162403548, 0.02096360643}});
    expectValues("he-torrance:f0=0.9,sigma=0.8,tau=4",
                 {{0.646054960129, 0.645453562649, 0.644736337987},
                  {1.65009044273, 1.65126888887, 1.65253435335},
                  {0.00338326141769, 0.00326231408479, 0.00311672499172}});
}

TEST(HeTorrance, OfLargeRoughnessIsBeckmannMicrofacets)
{
    // Away from grazing nothing is in shadow, so alpha = 2 sigma / tau; the rest falls as 1 / g.
    const Source he = makeModelSource("he-torrance:f0=0.6,sigma=5,tau=50");
    const Source beckmann = makeModelSource("beckmann:f0=0.6,alpha=0.2");
    for (const auto& pair : spreadPairs(2000)) {
        const Vec3d h = glm::normalize(pair.wo + pair.wi);
        if (std::min(pair.wo.z, pair.wi.z) < 0.7 || h.z < 0.95) continue;
        const double expected = beckmann.evaluate(pair.wo, pair.wi).x;
        EXPECT_NEAR(he.evaluate(pair.wo, pair.wi).x, expected, 0.01 * expected);
    }
}

TEST(HeTorrance, OfASmoothSurfaceIsTheFirstTermOfItsSeries)
{
    // g << 1: D = (k tau / 4)^2 g e^(-b), at normal incidence b = 0 and f = F 4 D / pi.
    const double wavenumber = 2.0 * kPi / 0.611;
    const double g = std::pow(wavenumber * 0.001 * 2.0, 2.0);
    const double d = std::pow(wavenumber * 2.0 / 4.0, 2.0) * g;
    const Vec3d normal(0.0, 0.0, 1.0);
    const double f =
        makeModelSource("he-torrance:f0=0.5,sigma=0.001,tau=2").evaluate(normal, normal).x;
    EXPECT_NEAR(f, 0.5 * 4.0 * d / kPi, g * f);
}

TEST(HeTorrance, LongerWavesSeeASmootherSurface)
{
    // More of them goes into the spike, which is left out, and less into the mirror direction of
    // the lobe.
    const Source source = makeModelSource("he-torrance:sigma=0.05,tau=2");
    const Vec3d f = source.evaluate(directionDegrees(30.0, 0.0), directionDegrees(30.0, 180.0));
    EXPECT_LT(f.x, f.y);
    EXPECT_LT(f.y, f.z);
}

// In Python: the formulas of Burley 2012 with mix() and without regrouping.
TEST(Disney, AgreesWithAnotherImplementation)
{
    expectValues(
        "disney:baseColor=0.8/0.4/0.2,subsurface=0.3,metallic=0.2,specular=0.6,specularTint=0.5,"
        "roughness=0.4,anisotropic=0.7,sheen=0.5,sheenTint=0.4,clearcoat=0.9,clearcoatGloss=0.3",
        {{0.577322615702, 0.312219339062, 0.179667700742},
         {0.321817382502, 0.188419567742, 0.121720660361},
         {0.204640777906, 0.102951411057, 0.0521067276321}});
}

TEST(Disney, WithoutHighlightsIsLambertianAtNormalIncidence)
{
    const Vec3d normal(0.0, 0.0, 1.0);
    const Vec3d f =
        makeModelSource("disney:baseColor=0.5/0.2/0.1,specular=0").evaluate(normal, normal);
    EXPECT_NEAR(f.x, 0.5 / kPi, 1e-15);
    EXPECT_NEAR(f.z, 0.1 / kPi, 1e-15);
}

TEST(Disney, MetalHasItsColourInTheHighlightAlone)
{
    // roughness 0.5: alpha = 0.25, alpha_g = 0.75^2, each masking / cosine is 1 / (1 + 1).
    const Vec3d normal(0.0, 0.0, 1.0);
    const Vec3d f = makeModelSource("disney:baseColor=0.9/0.6/0.3,metallic=1,roughness=0.5")
                        .evaluate(normal, normal);
    const double lobe = 1.0 / (kPi * 0.25 * 0.25) / 4.0;
    EXPECT_NEAR(f.x, 0.9 * lobe, 1e-12);
    EXPECT_NEAR(f.y, 0.6 * lobe, 1e-12);
    EXPECT_NEAR(f.z, 0.3 * lobe, 1e-12);
}

TEST(Disney, BlackHasNoHueToTintWith)
{
    const Vec3d f = makeModelSource("disney:baseColor=0,specularTint=1,sheen=1,sheenTint=1")
                        .evaluate(directionDegrees(50.0, 0.0), directionDegrees(60.0, 180.0));
    EXPECT_GT(f.x, 0.0);
    EXPECT_EQ(f.x, f.z);
}

}  // namespace
}  // namespace fbrdf::test
