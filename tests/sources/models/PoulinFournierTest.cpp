// PoulinFournierTest.cpp - cylinders and grooves against limits and against summing small facets.
#include <models/CylinderProfile.h>

#include "Furnace.h"
#include "Pairs.h"

#include <fbrdf/base/Number.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

/// Highlights at exponents up to 1e4 against 1e5 facets a period.
constexpr double kFacets = 2e-4;
const Vec3d kNormal(0.0, 0.0, 1.0);

/// The definition, summed over facets of equal width in y: mean of f_local (n.wi)(n.wo) / n.z over
/// the points that both directions see, over wi.z wo.z. `local`: the BRDF of one facet.
double sumOverFacets(double height, double spacing, const BrdfFunction& local, const Vec3d& wo,
                     const Vec3d& wi)
{
    const CylinderProfile profile(height, spacing);
    const auto gamma = [](const Vec3d& w) { return std::atan2(w.y, w.z); };
    const Interval arc = intersection(profile.visibleArc(gamma(wi)), profile.visibleArc(gamma(wo)));
    const Interval floor =
        intersection(profile.visibleFloor(gamma(wi)), profile.visibleFloor(gamma(wo)));
    const int count = 100000;
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
        const double psi = profile.halfArc() * (2.0 * (k + 0.5) / count - 1.0);
        if (psi < arc.lower || psi > arc.upper) continue;
        const double tilt = profile.isGroove() ? -psi : psi;
        // The facet's own frame: x stays, n = (0, sin tilt, cos tilt).
        const auto into = [tilt](const Vec3d& w) {
            return Vec3d(w.x, w.y * std::cos(tilt) - w.z * std::sin(tilt),
                         w.y * std::sin(tilt) + w.z * std::cos(tilt));
        };
        const Vec3d o = into(wo), i = into(wi);
        if (o.z > 0.0 && i.z > 0.0) sum += local(o, i).x * o.z * i.z;
    }
    sum *= 2.0 * profile.halfArc() / count;
    sum += floor.length() * local(wo, wi).x * wo.z * wi.z;
    return sum / (profile.period() * wo.z * wi.z);
}

TEST(PoulinFournier, AgreesWithSummingFacets)
{
    struct Case {
        double height, spacing;
        const char *parameters, *local;
    };
    const Case cases[] = {{0.5, 1.25, "kd=0.3,ks=0.4,n=50", "blinn-phong:kd=0.3,ks=0.4,n=50"},
                          {1.0, 1.0, "kd=0.8,ks=0", "blinn-phong:kd=0.8,ks=0"},
                          {0.2, 1.0, "kd=0,ks=1,n=10000", "blinn-phong:kd=0,ks=1,n=10000"},
                          {-0.7, 1.5, "kd=0.1,ks=0.6,n=200", "blinn-phong:kd=0.1,ks=0.6,n=200"},
                          {-1.0, 1.0, "kd=0.5,ks=0.5,n=0", "blinn-phong:kd=0.5,ks=0.5,n=0"}};
    for (const Case& c : cases) {
        const std::string spec = "poulin-fournier:height=" + numberText(c.height) +
                                 ",spacing=" + numberText(c.spacing) + "," + c.parameters;
        const Source source = makeModelSource(spec);
        const BrdfFunction local = makeModelSource(c.local).evaluate;
        for (const auto& pair : spreadPairs(40)) {
            const double expected = sumOverFacets(c.height, c.spacing, local, pair.wo, pair.wi);
            // Where the lobe is nothing but tail, e^-28 of its peak and less, only size matters.
            EXPECT_NEAR(source.evaluate(pair.wo, pair.wi).x, expected, kFacets * expected + 1e-12)
                << spec;
        }
    }
}

TEST(PoulinFournier, WithoutHeightIsItsBlinnPhong)
{
    const Source flat = makeModelSource("poulin-fournier:kd=0.2,ks=0.5,n=30,height=0");
    const Source almost = makeModelSource("poulin-fournier:kd=0.2,ks=0.5,n=30,height=2e-6");
    const Source blinn = makeModelSource("blinn-phong:kd=0.2,ks=0.5,n=30");
    for (const auto& pair : spreadPairs(100)) {
        if (std::min(pair.wo.z, pair.wi.z) < 0.1) continue;
        const double expected = blinn.evaluate(pair.wo, pair.wi).x;
        EXPECT_NEAR(flat.evaluate(pair.wo, pair.wi).x, expected, 1e-12 * expected);
        // Slopes up to 2e-3 at this height.
        EXPECT_NEAR(almost.evaluate(pair.wo, pair.wi).x, expected, 1e-2 * expected);
    }
}

TEST(PoulinFournier, OfFarApartCylindersIsMostlyFloor)
{
    const Source sparse = makeModelSource("poulin-fournier:kd=0.5,ks=0,height=0.5,spacing=100");
    EXPECT_NEAR(sparse.evaluate(kNormal, kNormal).x, 0.5 / kPi, 0.01 * 0.5 / kPi);
}

TEST(PoulinFournier, DiffuseHalfCylindersHaveTheirClosedFormFromAbove)
{
    // height = spacing = 1: period 2, integral of cos^2 psi over (-pi/2, pi/2) is pi/2.
    const Source source = makeModelSource("poulin-fournier:kd=1,ks=0,height=1,spacing=1");
    EXPECT_NEAR(source.evaluate(kNormal, kNormal).x, 0.25 * kPi / kPi, 1e-12);
    // The same for a 60 degree arc: period 2 sin(60), (psi + sin psi cos psi) / 2 on both sides.
    const double arc = kPi / 3.0;
    const double expected = (arc + std::sin(arc) * std::cos(arc)) / (2.0 * std::sin(arc)) / kPi;
    for (const char* height : {"0.5", "-0.5"})
        EXPECT_NEAR(
            makeModelSource(std::string("poulin-fournier:kd=1,ks=0,spacing=1,height=") + height)
                .evaluate(kNormal, kNormal)
                .x,
            expected, 1e-12);
}

TEST(PoulinFournier, LosesOnlyWhatIsScatteredTwice)
{
    // White and without lobe: all light that meets the surface once leaves or hits it again.
    const double shallow =
        largestAlbedo(makeModelSource("poulin-fournier:kd=1,ks=0,height=0.01").evaluate);
    const double deep =
        directionalAlbedo(makeModelSource("poulin-fournier:kd=1,ks=0,height=-1").evaluate, kNormal)
            .x;
    EXPECT_NEAR(shallow, 1.0, 0.02);
    EXPECT_LT(deep, 0.8);
    EXPECT_GT(deep, 0.6);
}

TEST(PoulinFournier, HighlightSpreadsAcrossTheCylindersOnly)
{
    const Source source = makeModelSource("poulin-fournier:kd=0,ks=1,n=1000,height=0.5");
    const double peak = source.evaluate(kNormal, kNormal).x;
    const Vec3d across = directionDegrees(40.0, 90.0), along = directionDegrees(40.0, 0.0);
    EXPECT_GT(source.evaluate(across, kNormal).x, 0.1 * peak);
    EXPECT_LT(source.evaluate(along, kNormal).x, 1e-6 * peak);
}

}  // namespace
}  // namespace fbrdf::test
