#include <fbrdf/peers/LinearMaps.h>

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

/// T(theta_i, theta_o), flat at log2 = -1 but for one texel at the horizon.
Material spiked(float spike)
{
    Material material;
    GridDomain grid;
    grid.axes = {{16, {}}, {16, {}}};
    material.form.name = "io";
    material.form.tables = {{"T", grid, false}};
    material.form.terms = {{{{0, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}}};
    Table table;
    table.name = "T";
    table.domain = grid;
    table.texels.assign(16 * 16 * 3, -1.0f);
    for (size_t c = 0; c < 3; ++c) table.texels[(16 * 16 - 1) * 3 + c] = spike;
    material.tables = {table};
    material.scales = {Vec3f(0.5f)};
    return material;
}

double errorAtTheTop(const Material& material)
{
    const Vec3d n(0.0, 0.0, 1.0);
    return std::abs(evaluate(material, n, n).x - 0.25);
}

TEST(LinearMaps, KeepTheProduct)
{
    const Material maps = linearMaps(spiked(-1.0f), errorAtTheTop);
    EXPECT_EQ(maps.tables[0].storage, Storage::linear8);
    EXPECT_NEAR(evaluate(maps, Vec3d(0, 0, 1), Vec3d(0, 0, 1)).x, 0.25, 1e-6);
    EXPECT_NO_THROW(validate(maps, "maps"));
}

TEST(LinearMaps, ClipASpikeThatWouldTakeAllSteps)
{
    // 2^12 above the rest: in steps of 1/255 of the spike everything else would be 0.
    EXPECT_LT(errorAtTheTop(linearMaps(spiked(11.0f), errorAtTheTop)), 1e-6);
}

TEST(LinearMaps, AreOfOneTerm)
{
    Material two = spiked(0.0f);
    two.form.terms.push_back(two.form.terms[0]);
    two.scales.push_back(Vec3f(1.0f));
    EXPECT_THROW(linearMaps(two, errorAtTheTop), Error);
}

}  // namespace
}  // namespace fbrdf
