#include <fbrdf/base/Error.h>
#include <fbrdf/sources/Spectrum.h>
#include <gtest/gtest.h>

#include <limits>

using fbrdf::SpectrumToRgb;
using fbrdf::Vec3d;

namespace {

std::vector<double> wavelengths(double first, double last, double step)
{
    std::vector<double> list;
    for (double nm = first; nm <= last; nm += step) list.push_back(nm);
    return list;
}

Vec3d colourOfLine(double nm, double step)
{
    const std::vector<double> grid = wavelengths(380, 780, step);
    std::vector<double> spectrum(grid.size(), 0.0);
    for (size_t i = 0; i < grid.size(); ++i) spectrum[i] = grid[i] == nm;
    return SpectrumToRgb(grid)(spectrum.data());
}

}  // namespace

TEST(Spectrum, FlatSpectrumIsExactlyWhite)
{
    for (const auto& grid :
         {wavelengths(400, 700, 10), wavelengths(360, 1000, 3.3), wavelengths(380, 780, 5),
          std::vector<double>{532.0}, std::vector<double>{450.0, 532.0, 650.0}}) {
        const std::vector<double> one(grid.size(), 1.0);
        const Vec3d rgb = SpectrumToRgb(grid)(one.data());
        EXPECT_EQ(fbrdf::Vec3f(rgb), fbrdf::Vec3f(1.0f)) << grid.size();
        EXPECT_NEAR(rgb.x + rgb.y + rgb.z, 3.0, 1e-12);
    }
}

TEST(Spectrum, IsLinear)
{
    const auto grid = wavelengths(400, 700, 10);
    const SpectrumToRgb toRgb(grid);
    std::vector<double> a(grid.size()), b(grid.size()), sum(grid.size());
    for (size_t i = 0; i < grid.size(); ++i) {
        a[i] = 0.1 + 0.02 * double(i % 7);
        b[i] = 1.0 / double(i + 1);
        sum[i] = 2.0 * a[i] + b[i];
    }
    const Vec3d difference = toRgb(sum.data()) - (2.0 * toRgb(a.data()) + toRgb(b.data()));
    EXPECT_LT(glm::length(difference), 1e-12);
}

TEST(Spectrum, PureColoursFallWhereTheyShould)
{
    const Vec3d red = colourOfLine(620, 10), green = colourOfLine(530, 10),
                blue = colourOfLine(450, 10);
    EXPECT_TRUE(red.x > 0 && red.x > 5 * std::abs(red.y) && red.x > 5 * std::abs(red.z));
    EXPECT_TRUE(green.y > 0 && green.x < 0);  // outside the gamut: negative red
    EXPECT_TRUE(blue.z > 0 && blue.z > 5 * std::abs(blue.y));
}

// Chromaticities of the spectral locus, CIE 1931 (Wyszecki and Stiles 1982, table I(3.3.1)): a
// wrong digit in the observer's table, in the matrix or in the order of its rows shows here.
// kLocus: the weights of each channel are normalised to 1, which moves white by 0.0024 in blue.
TEST(Spectrum, LinesLieOnTheSpectralLocus)
{
    constexpr double kLocus = 1e-3;
    struct Line {
        double nm, x, y;
    };
    for (const Line line : {Line{450, 0.1566, 0.0177},
                            {480, 0.0913, 0.1327},
                            {500, 0.0082, 0.5384},
                            {520, 0.0743, 0.8338},
                            {550, 0.3016, 0.6923},
                            {600, 0.6270, 0.3725},
                            {650, 0.7260, 0.2740}}) {
        const Vec3d rgb = colourOfLine(line.nm, 1);
        // Linear sRGB to XYZ, IEC 61966-2-1.
        const double x = 0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z;
        const double y = 0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z;
        const double z = 0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z;
        EXPECT_NEAR(x / (x + y + z), line.x, kLocus) << line.nm;
        EXPECT_NEAR(y / (x + y + z), line.y, kLocus) << line.nm;
    }
}

// The illuminant's table: the share of a white surface's luminance below 547.5 nm under D65 is
// 0.42321, summed in numpy from the same CIE tables.
TEST(Spectrum, LuminanceBelow550IsItsShare)
{
    const auto grid = wavelengths(380, 780, 1);
    const SpectrumToRgb toRgb(grid);
    std::vector<double> low(grid.size());
    for (size_t i = 0; i < grid.size(); ++i) low[i] = grid[i] < 547.5 ? 1.0 : 0.0;
    const Vec3d rgb = toRgb(low.data());
    EXPECT_NEAR(0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z, 0.42321, 5e-4);
}

TEST(Spectrum, RefusesWavelengthsThatDoNotAscend)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::vector<double>& bad : {std::vector<double>{},
                                           {500.0, 500.0},
                                           {500.0, 400.0},
                                           {0.0, 400.0},
                                           {-5.0},
                                           {nan},
                                           {400.0, nan}})
        EXPECT_THROW(SpectrumToRgb{bad}, fbrdf::Error);
}
