#include <fbrdf/environment/Prefilter.h>

#include <gtest/gtest.h>

#include "environment/Panoramas.h"

#include <cmath>

namespace fbrdf {
namespace {

/// Integral of a lobe from its axis to an angle, by the midpoint rule.
double energyWithin(double angle, int level)
{
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double g = angle * (i + 0.5) / kSteps;
        sum += lobeValue(std::cos(g), level) * std::sin(g);
    }
    return sum * 2.0 * kPi * angle / kSteps;
}

TEST(LobeCells, EnergyOfALobeHasAClosedForm)
{
    constexpr double kMidpoint = 1e-5;
    for (int level = 0; level <= kCosineLevel; ++level)
        for (const double t : {0.1, 0.5, 1.0, 3.0, 8.0}) {
            const double found = energyWithin(std::atan(lobeWidth(level) * t), level);
            EXPECT_NEAR(found, t * t / (1.0 + t * t), kMidpoint) << level << " " << t;
            EXPECT_GT(std::abs(found - 1.0 + std::exp(-t * t)), kMidpoint);  // a wrong form is seen
        }
}

TEST(LobeCells, CoverTheHalfSphereAndTheLobe)
{
    constexpr double kRounding = 1e-6;  // a hundred floats
    for (int level = 0; level <= kCosineLevel; ++level) {
        const auto cells = lobeCells(level);
        EXPECT_LE(cells.size(), static_cast<size_t>(kMostCells));
        double weight = 0.0, solidAngle = 0.0;
        for (const LobeCell& cell : cells) {
            EXPECT_GT(cell.weight, 0.0f);
            EXPECT_GT(cell.direction.z, 0.0f);
            EXPECT_NEAR(glm::length(cell.direction), 1.0f, kRounding);
            weight += double(cell.weight);
            solidAngle += double(cell.solidAngle);
        }
        EXPECT_NEAR(weight, 1.0, kRounding) << level;
        EXPECT_NEAR(solidAngle, 2.0 * kPi, 2.0 * kPi * kRounding) << level;
    }
}

/// Of a smooth function of the angle, the mean over the lobe, by the midpoint rule over the energy
/// e: t^2 = e / (1 - e).
template <class Function>
double meanOverLobe(const Function& function, int level)
{
    constexpr int kSteps = 2000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double e = (i + 0.5) / kSteps;
        sum += function(std::atan(lobeWidth(level) * std::sqrt(e / (1.0 - e))));
    }
    return sum / kSteps;
}

TEST(LobeCells, HaveAboutTheEnergyOfTheLobe)
{
    // Weights make up for the blur of a look-up, so energy is nearer to the axis by some percent.
    constexpr double kBlur = 0.03;
    for (int level = 0; level <= kCosineLevel; ++level)
        for (const double scale : {1.0, 2.0, 4.0}) {
            const auto bump = [&](double angle) {
                const double t = std::tan(angle) / lobeWidth(level) / scale;
                return std::exp(-t * t);
            };
            const double expected = meanOverLobe(bump, level);
            double found = 0.0;
            for (const LobeCell& cell : lobeCells(level))
                found += double(cell.weight) * bump(std::acos(double(cell.direction.z)));
            EXPECT_NEAR(found, expected, kBlur) << level << " " << scale;
            EXPECT_GT(std::abs(1.2 * found - expected), kBlur);  // a fifth too much is seen
        }
}

TEST(LobeCells, LookAlongTheAxisOnTheWhole)
{
    constexpr double kRounding = 1e-6;
    for (int level = 0; level <= kCosineLevel; ++level) {
        Vec3d moment(0.0);
        for (const LobeCell& cell : lobeCells(level))
            moment += double(cell.weight) * Vec3d(cell.direction);
        EXPECT_NEAR(moment.x, 0.0, kRounding) << level;
        EXPECT_NEAR(moment.y, 0.0, kRounding) << level;
    }
    // The mean of cos over the cosine lobe is 2/3.
    double mean = 0.0;
    for (const LobeCell& cell : lobeCells(kCosineLevel))
        mean += double(cell.weight) * double(cell.direction.z);
    EXPECT_NEAR(mean, 2.0 / 3.0, 0.01);
}

TEST(LobeFrame, IsRightHandedAndOrthonormal)
{
    constexpr double kRounding = 1e-13;
    std::mt19937 random(1);
    std::vector<Vec3d> axes = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1, 0, -0.0}};
    for (int i = 0; i < 1000; ++i) axes.push_back(randomDirection(random));
    for (const Vec3d& axis : axes) {
        const LobeFrame frame = lobeFrame(axis);
        EXPECT_NEAR(glm::length(frame.x), 1.0, kRounding);
        EXPECT_NEAR(glm::dot(frame.x, axis), 0.0, kRounding);
        EXPECT_NEAR(glm::distance(glm::cross(axis, frame.x), frame.y), 0.0, kRounding);
    }
}

TEST(LevelOfCell, IsThatOfTexelsAsLarge)
{
    constexpr double kMidpoint = 0.001;  // the solid angle of a texel from its centre alone
    for (const int size : {16, 64})
        for (int face = 0; face < 6; ++face) {
            for (const auto& [x, y] : {std::pair(0, 0), {size / 2, size / 2}, {3, size - 1}}) {
                const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
                const double texel = 4.0 / size / size * std::pow(1.0 + s * s + t * t, -1.5);
                const Vec3d direction = cubeTexelDirection(face, x, y, size);
                EXPECT_NEAR(levelOfCell(texel, direction, size), 0.0, kMidpoint);
                EXPECT_NEAR(levelOfCell(16.0 * texel, direction, size), 2.0, kMidpoint);
                EXPECT_NEAR(levelOfCell(texel, direction, 2 * size), 1.0, kMidpoint);
            }
        }
}

}  // namespace
}  // namespace fbrdf
