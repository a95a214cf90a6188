// AnisotropyTest.cpp - x is along the tangent, in every model that knows one.
#include "Pairs.h"

#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

/// Rounding of a quarter turn and of products in another order.
constexpr double kRounding = 1e-9;

Vec3d quarterTurn(const Vec3d& w)
{
    return {-w.y, w.x, w.z};
}

TEST(Anisotropy, TurningTheSurfaceIsExchangingTheParameters)
{
    const std::pair<const char*, const char*> twins[] = {
        {"ggx:alpha_x=0.1,alpha_y=0.4,kd=0.1", "ggx:alpha_x=0.4,alpha_y=0.1,kd=0.1"},
        {"beckmann:alpha_x=0.1,alpha_y=0.4", "beckmann:alpha_x=0.4,alpha_y=0.1"},
        {"ward:alpha_x=0.05,alpha_y=0.16", "ward:alpha_x=0.16,alpha_y=0.05"},
        {"ashikhmin-shirley:nu=10,nv=500", "ashikhmin-shirley:nu=500,nv=10"},
        {"lafortune:cx=-1,cy=-0.8", "lafortune:cx=-0.8,cy=-1"}};
    for (const auto& [spec, exchanged] : twins) {
        const Source a = makeModelSource(spec), b = makeModelSource(exchanged);
        EXPECT_FALSE(a.isotropic) << spec;
        for (const auto& pair : spreadPairs(500)) {
            const double expected = a.evaluate(pair.wo, pair.wi).x;
            EXPECT_NEAR(b.evaluate(quarterTurn(pair.wo), quarterTurn(pair.wi)).x, expected,
                        kRounding * expected)
                << spec;
        }
    }
}

/// f with both directions tilted by `degrees` along x over the same along y.
double ratioOfTilts(const std::string& spec, double degrees)
{
    const Source source = makeModelSource(spec);
    const Vec3d x = directionDegrees(degrees, 0.0), y = directionDegrees(degrees, 90.0);
    return source.evaluate(x, x).x / source.evaluate(y, y).x;
}

TEST(Anisotropy, HighlightIsWideAlongTheLargerRoughnessOrFallOff)
{
    EXPECT_LT(ratioOfTilts("ggx:alpha_x=0.1,alpha_y=0.4", 15.0), 0.5);
    EXPECT_LT(ratioOfTilts("beckmann:alpha_x=0.1,alpha_y=0.4", 15.0), 0.5);
    EXPECT_LT(ratioOfTilts("ward-rolled-brass", 15.0), 0.5);
    EXPECT_GT(ratioOfTilts("ashikhmin-shirley:nu=10,nv=500,kd=0", 15.0), 2.0);
    // Burley 2012: the highlight is stretched along the tangent.
    EXPECT_GT(ratioOfTilts("disney:anisotropic=1,metallic=1,roughness=0.4", 15.0), 2.0);
    // Cylinders along the tangent have normals across it.
    EXPECT_LT(ratioOfTilts("poulin-fournier:kd=0,n=200", 15.0), 0.5);
}

TEST(Anisotropy, IsKnownFromTheParameters)
{
    for (const char* spec :
         {"ggx", "ggx:alpha=0.3", "ggx:alpha_x=0.2,alpha_y=0.2", "beckmann", "ward",
          "ward-white-ceramic-tile", "ashikhmin-shirley:nu=7,nv=7", "lafortune", "disney",
          "poulin-fournier:height=0", "phong", "sgd", "abc", "he-torrance", "plastic"})
        EXPECT_TRUE(makeModelSource(spec).isotropic) << spec;
    for (const char* spec :
         {"ggx:alpha_x=0.2", "beckmann:alpha_y=0.2", "ward-rolled-brass", "ashikhmin-shirley:nu=7",
          "lafortune:cx=-1/-1/-0.9", "disney:anisotropic=0.1", "poulin-fournier",
          "poulin-fournier:height=-0.5"})
        EXPECT_FALSE(makeModelSource(spec).isotropic) << spec;
}

}  // namespace
}  // namespace fbrdf::test
