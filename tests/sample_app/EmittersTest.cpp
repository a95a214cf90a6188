// EmittersTest.cpp - lights drawn at random against sums over all directions and over points.
#include "EveryShape.h"

#include <fbrdf/base/SplitMix.h>
#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/truth/Emitters.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fbrdf::truth {
namespace {

using Shape = AreaLight::Shape;
constexpr Shape kShapes[] = {Shape::sphere, Shape::disc, Shape::rectangle, Shape::tube,
                             Shape::polygon};
// Of some 100 means, one is off by that many standard errors once in 20,000 runs; seeds are fixed.
constexpr double kSigmas = 5.0;
constexpr int kDraws = 20000;

/// Even numbers, the same in every run.
struct Numbers {
    uint64_t state = 0;
    double one() { return static_cast<double>(splitMix64(state++) >> 11) * 0x1p-53; }
    Vec2<double> two()
    {
        const double first = one();
        return {first, one()};
    }
};

/// A mean and its standard error.
class Mean {
public:
    void add(double value)
    {
        ++count_;
        sum_ += value;
        squares_ += value * value;
    }
    double value() const { return sum_ / count_; }
    double error() const
    {
        return std::sqrt(std::max(0.0, squares_ / count_ - value() * value()) / count_);
    }

private:
    double count_ = 0.0, sum_ = 0.0, squares_ = 0.0;
};

AreaLight lightOf(Shape shape)
{
    return test::lightsOfEveryShape()[static_cast<size_t>(shape)];
}

/// A point before a light, on the side to which a flat one shines.
Vec3d before(const AreaLight& light)
{
    const bool isRound = light.shape == Shape::sphere || light.shape == Shape::tube;
    return centreOf(light) + 0.6 * (isRound ? Vec3d(0, 0, -1) : normalOf(light));
}

/// In front of all lights, and inside of the sphere and of the tube.
const Vec3d kFront(0.1, 0.3, 0.2), kInSphere(1.1, 1.4, 2.1), kInTube(1.5, 0.3, 2.1);

using Measure = std::function<double(const Vec3d& direction)>;
const Measure kMeasures[] = {[](const Vec3d&) { return 1.0; }, [](const Vec3d& w) { return w.x; },
                             [](const Vec3d& w) { return w.y * w.z; }};

/// The integral of a measure over what is seen of the light, times the mean of its radiance.
Mean byDraws(const AreaEmitter& emitter, const Vec3d& position, const Measure& measure,
             double pdfFactor = 1.0)
{
    Numbers numbers{1000};
    Mean mean;
    for (int i = 0; i < kDraws; ++i) {
        const Emission e = emitter.drawn(position, numbers.two());
        mean.add(e.pdf > 0.0 ? e.radiance.y * measure(e.direction) / (pdfFactor * e.pdf) : 0.0);
    }
    return mean;
}

Vec3d evenDirection(Numbers& numbers)
{
    const Vec2<double> u = numbers.two();
    const double z = 1.0 - 2.0 * u.x, across = std::sqrt(1.0 - z * z), angle = 2.0 * kPi * u.y;
    return {across * std::cos(angle), across * std::sin(angle), z};
}

/// The same from directions that do not know of the light.
Mean byDirections(const AreaEmitter& emitter, const Vec3d& position, const Measure& measure)
{
    Numbers numbers{7};
    Mean mean;
    for (int i = 0; i < kDraws; ++i) {
        const Vec3d w = evenDirection(numbers);
        const Emission e = emitter.along(position, w);
        mean.add(e.pdf > 0.0 ? 4.0 * kPi * e.radiance.y * measure(w) : 0.0);
    }
    return mean;
}

double sigmasBetween(const Mean& a, const Mean& b)
{
    // Of constants, which have no error but that of their sums, nothing is expected but those.
    constexpr double kRounding = 1e-9;
    return std::abs(a.value() - b.value()) / (std::hypot(a.error(), b.error()) + kRounding);
}

TEST(AreaEmitter, DrawsDirectionsWithTheDensityThatItSays)
{
    for (const Shape shape : kShapes)
        for (const bool twoSided : {false, true})
            for (const Vec3d& position : {kFront, before(lightOf(shape)), kInSphere, kInTube}) {
                AreaLight light = lightOf(shape);
                light.twoSided = twoSided;
                light.radius = 4.0f;
                const AreaEmitter emitter(light);
                for (const Measure& measure : kMeasures) {
                    const Mean drawn = byDraws(emitter, position, measure),
                               seen = byDirections(emitter, position, measure);
                    if (drawn.value() == 0.0 && seen.value() == 0.0) continue;  // its dark side
                    EXPECT_LT(sigmasBetween(drawn, seen), kSigmas)
                        << shapeName(shape) << " from z = " << position.z << ": " << drawn.value()
                        << ", " << seen.value();
                }
            }
}

TEST(AreaEmitter, TheTesterSeesADensityThatIsAQuarterTooLarge)
{
    for (const Shape shape : kShapes) {
        const AreaEmitter emitter(lightOf(shape));
        const Vec3d position = before(lightOf(shape));
        EXPECT_GT(sigmasBetween(byDraws(emitter, position, kMeasures[0], 1.25),
                                byDirections(emitter, position, kMeasures[0])),
                  kSigmas)
            << shapeName(shape);
    }
}

// Sums over 6,400 points of a light, where that sum is off by a thousandth.
TEST(AreaEmitter, AddsUpToWhatADiffuseSurfaceReflects)
{
    constexpr double kPoints = 2e-3;
    const ShadingFrame<double> up{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Reflectance white = [](const Vec3d&, const Vec3d&) { return Vec3d(1.0 / kPi); };
    for (const Shape shape : kShapes)
        for (const float radius : {0.0f, 3.0f})
            for (const Vec3d& position : {kFront, before(lightOf(shape)), kInSphere}) {
                AreaLight light = lightOf(shape);
                light.radius = radius;
                const Mean found = byDraws(AreaEmitter(light), position,
                                           [](const Vec3d& w) { return std::max(0.0, w.z) / kPi; });
                const double expected =
                    AreaTruth(light, {6400, 6400}).reflected(white, position, up, {0, 0, 1}).y;
                EXPECT_NEAR(found.value(), expected, kSigmas * found.error() + kPoints)
                    << shapeName(shape) << " from z = " << position.z;
            }
}

TEST(AreaEmitter, SaysHowFarTheLightIs)
{
    AreaLight light = lightOf(Shape::sphere);
    light.position = {0, 0, 3};
    light.size = 1.0f;
    const Vec3d up(0, 0, 1);
    EXPECT_NEAR(AreaEmitter(light).along(Vec3d(0.0), up).distance, 2.0, 1e-12);
    EXPECT_NEAR(AreaEmitter(light).along(Vec3d(0, 0, 3), up).distance, 1.0, 1e-12) << "inside";
    EXPECT_EQ(AreaEmitter(light).along(Vec3d(0, 0, 5), up).pdf, 0.0) << "behind";
    light.shape = Shape::tube;
    light.end = {0, 0, 5};
    EXPECT_NEAR(AreaEmitter(light).along(Vec3d(0.0), up).distance, 2.0, 1e-12);
    EXPECT_NEAR(AreaEmitter(light).along(Vec3d(0, 0, 4), up).distance, 2.0, 1e-12) << "inside";
    light.shape = Shape::disc;
    light.normal = {0, 0, -2};
    EXPECT_NEAR(AreaEmitter(light).along(Vec3d(0.0), up).distance, 3.0, 1e-12);
    EXPECT_EQ(AreaEmitter(light).along(Vec3d(0, 0, 5), -up).pdf, 0.0) << "the dark side";
}

TEST(AreaEmitter, KeepsItsDigitsFarAway)
{
    AreaLight light = lightOf(Shape::sphere);
    light.position = {0, 0, 1e6f};
    light.size = 1.0f;
    const Emission e = AreaEmitter(light).drawn(Vec3d(0.0), {0.5, 0.25});
    EXPECT_NEAR(e.pdf * kPi * 1e-12, 1.0, 1e-9);
    EXPECT_NEAR(std::hypot(e.direction.x, e.direction.y) * 1e6, std::sqrt(0.5), 1e-6);
}

scene::EnvironmentLight environmentOf(int width, int height)
{
    scene::EnvironmentLight light;
    light.panorama.width = width;
    light.panorama.height = height;
    for (int i = 0; i < width * height; ++i)
        light.panorama.texels.emplace_back(0.1f * float(i % 5), i == 11 ? 30.0f : 0.3f,
                                           0.2f * float(i % 3));
    light.panorama.texels[3] = Vec3f(0.0f);
    light.rotation = 0.7;
    light.intensity = 2.0;
    return light;
}

TEST(EnvironmentEmitter, AddsUpToAllTexels)
{
    const scene::EnvironmentLight light = environmentOf(8, 4);
    const EnvironmentEmitter emitter(light);
    const auto bent = [](const Vec3d& w) { return 1.0 + 0.5 * w.x + 0.3 * w.y * w.z; };
    // Texels of 45 degrees are split, so that the measure is summed well within the noise.
    constexpr int kSplits = 32;
    double expected = 0.0;
    for (int y = 0; y < 4 * kSplits; ++y)
        for (int x = 0; x < 8 * kSplits; ++x) {
            const double v = (y + 0.5) / (4 * kSplits);
            const double solidAngle =
                2.0 * kPi * kPi * std::sin(kPi * v) / (32.0 * kSplits * kSplits);
            const Vec3d w = light.fromEnvironment(panoramaDirection((x + 0.5) / (8 * kSplits), v));
            expected += solidAngle * bent(w) * 2.0 *
                        static_cast<double>(light.panorama.texel(x / kSplits, y / kSplits).y);
        }
    Numbers numbers{3};
    Mean mean, wrong;
    for (int i = 0; i < kDraws; ++i) {
        const Emission e = emitter.drawn(numbers.two());
        ASSERT_GT(e.pdf, 0.0);
        mean.add(e.radiance.y * bent(e.direction) / e.pdf);
        wrong.add(e.radiance.y * bent(e.direction) / (1.1 * e.pdf));
    }
    EXPECT_NEAR(mean.value(), expected, kSigmas * mean.error());
    EXPECT_GT(std::abs(wrong.value() - expected), kSigmas * wrong.error()) << "the tester";
}

TEST(EnvironmentEmitter, SaysTheSameOfADirectionHoweverItIsFound)
{
    const scene::EnvironmentLight light = environmentOf(8, 4);
    const EnvironmentEmitter emitter(light);
    Numbers numbers{5};
    for (int i = 0; i < 1000; ++i) {
        const Emission drawn = emitter.drawn(numbers.two()), found = emitter.along(drawn.direction);
        ASSERT_NEAR(drawn.pdf, found.pdf, 1e-12 * drawn.pdf);
        ASSERT_EQ(drawn.radiance, found.radiance);
    }
    double sum = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            sum += texelSolidAngle(light.panorama, y) *
                   emitter
                       .along(light.fromEnvironment(
                           panoramaDirection((x + 0.5) / 8.0, (y + 0.5) / 4.0)))
                       .pdf;
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(EnvironmentEmitter, DrawsNothingInTheDark)
{
    scene::EnvironmentLight light = environmentOf(8, 4);
    for (Vec3f& texel : light.panorama.texels) texel = Vec3f(0.0f);
    const EnvironmentEmitter emitter(light);
    EXPECT_EQ(emitter.drawn({0.3, 0.3}).pdf, 0.0);
    EXPECT_EQ(emitter.along({0.0, 1.0, 0.0}).radiance, Vec3d(0.0));
}

}  // namespace
}  // namespace fbrdf::truth
