#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/brdf/LobeContour.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fbrdf {
namespace {

// Sums over grids of directions are as good as the grid is fine.
constexpr double kGrid = 2e-4;

/// The integral of stretched cosines about +z over what `inside` accepts, by a grid in polar
/// coordinates that is dense at the axis, where the lobes are narrow.
template <class Inside>
Vec2<double> byGrid(const Vec2<double>& squaredWidth, Inside inside)
{
    constexpr int kRings = 700, kSteps = 700;
    Vec2<double> sum(0.0);
    for (int i = 0; i < kRings; ++i) {
        const double low = 0.5 * kPi * std::pow(i / double(kRings), 3.0),
                     high = 0.5 * kPi * std::pow((i + 1) / double(kRings), 3.0),
                     theta = 0.5 * (low + high);
        const double solidAngle = (std::cos(low) - std::cos(high)) * 2.0 * kPi / kSteps;
        const Vec2<double> value(stretchedCosine(std::cos(theta), std::sqrt(squaredWidth.x)),
                                 stretchedCosine(std::cos(theta), std::sqrt(squaredWidth.y)));
        int count = 0;
        for (int j = 0; j < kSteps; ++j) {
            const double phi = 2.0 * kPi * (j + 0.5) / kSteps;
            count += inside(Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                  std::cos(theta)));
        }
        sum += value * solidAngle * double(count);
    }
    return sum;
}

Vec2<double> byEdges(const Vec3d& axis, const Vec2<double>& squaredWidth,
                     const std::vector<Vec3d>& corners)
{
    Vec2<double> sum(0.0);
    for (size_t i = 0; i < corners.size(); ++i)
        sum += lobeEdge(axis, squaredWidth, corners[i], corners[(i + 1) % corners.size()]);
    return sum / (2.0 * kPi);
}

TEST(LobeContour, KnowsTheAngleOverItsSine)
{
    constexpr double kFitted = 5e-8;  // the error that the fit states, and rounding
    for (int i = 1; i < 1800; ++i) {
        const double angle = i * 0.1 * kDegree, expected = angle / std::sin(angle);
        EXPECT_NEAR(angleOverSine(std::cos(angle)) / expected, 1.0, kFitted) << angle;
    }
    EXPECT_NEAR(angleOverSine(1.0), 1.0, kFitted);
    EXPECT_TRUE(std::isfinite(angleOverSine(-1.0f)));
}

TEST(LobeContour, MixesWhatLevelsMix)
{
    constexpr double kTight = 1e-12;
    for (const double level : {0.0, 0.3, 2.0, 4.75, 5.5, 6.0, 7.0}) {
        const LevelMixture<double> lobe = levelMixture(level);
        for (const double cosine : {1.0, 0.999, 0.7, 0.1})
            EXPECT_NEAR(lobe.share.x * stretchedCosine(cosine, std::sqrt(lobe.squaredWidth.x)) +
                            lobe.share.y * stretchedCosine(cosine, std::sqrt(lobe.squaredWidth.y)),
                        lobeValue(cosine, level), kTight * lobeValue(1.0, level))
                << level;
    }
}

TEST(LobeContour, AddsUpToOneOverTheHalfSphere)
{
    constexpr double kTight = 1e-7;
    const Vec3d axis = glm::normalize(Vec3d(0.3, -0.5, 0.8));
    const auto axes = axesAbout(axis);
    const std::vector<Vec3d> equator{axes[0], axes[1], -axes[0], -axes[1]};
    const Vec2<double> whole = byEdges(axis, {1.0 / 4096.0, 1.0}, equator);
    EXPECT_NEAR(whole.x, 1.0, kTight);
    EXPECT_NEAR(whole.y, 1.0, kTight);
}

TEST(LobeContour, OfPolygonsIsTheIntegral)
{
    const std::vector<Vec3d> square{
        {0.1, -0.3, 0.6}, {0.8, -0.2, 0.6}, {0.7, 0.5, 0.7}, {0, 0.4, 0.5}};
    const auto inside = [&](const Vec3d& w) {
        for (size_t i = 0; i < square.size(); ++i)
            if (glm::dot(glm::cross(square[i], square[(i + 1) % square.size()]), w) <= 0.0)
                return 0;
        return 1;
    };
    for (const double width : {0.03, 0.2, 0.7}) {
        const Vec2<double> widths(width * width, 1.0);
        const Vec2<double> sum = byEdges(Vec3d(0, 0, 1), widths, square),
                           expected = byGrid(widths, inside);
        EXPECT_NEAR(sum.x, expected.x, kGrid) << width;
        EXPECT_NEAR(sum.y, expected.y, kGrid) << width;
        // The tester sees a width that is wrong by a tenth.
        EXPECT_GT(std::abs(byEdges(Vec3d(0, 0, 1), 1.21 * widths, square).x - expected.x),
                  5 * kGrid);
    }
}

TEST(LobeContour, OfCapsIsTheIntegral)
{
    for (const double radius : {2.0, 15.0, 40.0})
        for (const double angle : {1.0, 10.0, 35.0, 49.0})
            for (const double width : {0.03, 0.4}) {
                const Vec3d centre(std::sin(angle * kDegree), 0.0, std::cos(angle * kDegree));
                const double cosine = std::cos(radius * kDegree);
                const Vec2<double> widths(width * width, 1.0);
                const Vec2<double> found = lobeInCap(widths, centre.z, 1.0 - cosine * cosine);
                const Vec2<double> expected = byGrid(
                    widths, [&](const Vec3d& w) { return glm::dot(w, centre) > cosine ? 1 : 0; });
                EXPECT_NEAR(found.x, expected.x, 5 * kGrid)
                    << radius << " " << angle << " " << width;
                EXPECT_NEAR(found.y, expected.y, 5 * kGrid)
                    << radius << " " << angle << " " << width;
            }
}

TEST(LobeContour, OfSmallCapsIsTheValueTimesTheSolidAngle)
{
    constexpr double kSmall = 1e-4;  // of the value: a cap of a hundredth of the lobe's width
    const double sine = 1e-4, cosine = std::cos(0.02);
    const Vec2<double> widths(1.0 / 4096.0, 1.0 / 1024.0);
    const Vec2<double> found = lobeInCap(widths, cosine, sine * sine);
    EXPECT_NEAR(found.x / (kPi * sine * sine * stretchedCosine(cosine, 1.0 / 64.0)), 1.0, kSmall);
    EXPECT_NEAR(found.y / (kPi * sine * sine * stretchedCosine(cosine, 1.0 / 32.0)), 1.0, kSmall);
}

TEST(LobeContour, IsAsGoodInFloat)
{
    constexpr float kFloat = 2e-5f;  // relative to 1: shares are at most that
    const Vec3d axis = glm::normalize(Vec3d(-0.2, 0.4, 0.7));
    const auto axes = axesAbout(axis);
    for (const double width : {1.0 / 64.0, 0.25, 1.0})
        for (const double size : {0.001, 0.05, 0.6}) {
            std::vector<Vec3d> corners;
            for (int k = 0; k < 5; ++k)
                corners.push_back(axis + 0.01 * axes[0] +
                                  size * std::cos(2.0 * kPi * k / 5) * axes[0] +
                                  size * std::sin(2.0 * kPi * k / 5) * axes[1]);
            Vec2<float> sum(0.0f);
            for (size_t k = 0; k < 5; ++k)
                sum += lobeEdge(Vec3f(axis), Vec2<float>(float(width * width)), Vec3f(corners[k]),
                                Vec3f(corners[(k + 1) % 5]));
            const Vec2<double> exact = byEdges(axis, Vec2<double>(width * width), corners);
            EXPECT_NEAR(sum.x / float(2.0 * kPi), float(exact.x), kFloat) << width << " " << size;
        }
}

}  // namespace
}  // namespace fbrdf
