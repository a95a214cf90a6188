// TiltTest.cpp - a tilt that is known is found, and none where there is none. No GL.
#include "Tilt.h"

#include "Known.h"

#include <fbrdf/fit/Disturb.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

constexpr double kDegree = kPi / 180.0;

// Views about the mirror direction and over the hemisphere, of light at three incidences, as a
// goniometer takes them.
std::vector<Sample> scan(const test::Ggx& surface, const Tilt& tilt, double mostAzimuth)
{
    std::vector<Sample> samples;
    for (const double incidence : {15.0, 35.0, 60.0})
        for (double theta = 0.0; theta < 80.0; theta += std::abs(theta - incidence) < 6 ? 0.5 : 4)
            for (double phi = -mostAzimuth; phi <= mostAzimuth;
                 phi += std::abs(phi) < 8.0 ? 1.0 : 6.0) {
                const double a = incidence * kDegree, b = theta * kDegree, p = kPi + phi * kDegree;
                Sample s{};
                s.weight = 1.0f;
                s.wi = Vec3f(Vec3d(std::sin(a), 0.0, std::cos(a)));
                s.wo =
                    Vec3f(Vec3d(std::sin(b) * std::cos(p), std::sin(b) * std::sin(p), std::cos(b)));
                const Sample own = straightened(s, tilt);
                if (own.wo.z <= 0.02f || own.wi.z <= 0.02f) continue;
                s.f = Vec3f(surface(Vec3d(own.wo), Vec3d(own.wi)));
                samples.push_back(s);
            }
    return samples;
}

std::optional<Tilt> found(const std::vector<Sample>& samples)
{
    return tiltOf(samples, statisticsOf(samples, false, "scan"), {});
}

const test::Ggx kGlossy{0.03, 0.03, 0.05, 0.4};

// Light comes from one azimuth. Along it a tilt moves highlights as shadowing does, which the form
// can follow: it takes a part of the tilt, and no more.
TEST(Tilt, IsFoundAcrossThePlaneOfIncidence)
{
    constexpr double kNear = 0.1 * kDegree;  // a tenth of the half width of the highlight
    for (const Tilt& tilt : {Tilt{0.0, 0.5 * kDegree}, Tilt{-0.3 * kDegree, -0.6 * kDegree},
                             Tilt{0.2 * kDegree, 1.0 * kDegree}}) {
        const auto tiltFound = found(withNoise(scan(kGlossy, tilt, 180.0), {0.05, 0, 0, 0, 1}, 3));
        ASSERT_TRUE(tiltFound.has_value()) << tilt.x << " " << tilt.y;
        EXPECT_NEAR(tiltFound->y, tilt.y, kNear);
        EXPECT_GT(tiltFound->x, std::min(0.0, tilt.x) - kNear);
        EXPECT_LT(tiltFound->x, std::max(0.0, tilt.x) + kNear);
    }
}

TEST(Tilt, IsNotFoundWhereThereIsNone)
{
    EXPECT_FALSE(found(scan(kGlossy, {}, 180.0)).has_value());
    EXPECT_FALSE(
        found(withNoise(scan(kGlossy, {}, 180.0), {0.1, 0.002, 0.0, 0.003, 8.0}, 3)).has_value());
    const test::Ggx rough{0.5, 0.5, 0.05, 0.4};  // half a degree is less than the noise
    const auto tilted = scan(rough, {0.0, 0.5 * kDegree}, 180.0);
    EXPECT_FALSE(found(withNoise(tilted, {0.05, 0.0, 0.0, 0.0, 1.0}, 3)).has_value());
}

TEST(Tilt, IsNotLookedForInThePlaneOfIncidenceAlone)
{
    EXPECT_FALSE(found(scan(kGlossy, {0.5 * kDegree, 0.0}, 0.0)).has_value());
}

TEST(Tilt, StraighteningTakesTheTiltedNormalToTheNormal)
{
    constexpr float kTight = 1e-6f;
    const Tilt tilt{0.02, -0.03};
    const Vec3f normal(0.02f, -0.03f, std::sqrt(1.0f - 0.0013f)), other(0.3f, 0.4f, 0.866025f);
    const Sample s = straightened(Sample{normal, other, Vec3f(1.0f), 1.0f}, tilt);
    EXPECT_NEAR(s.wo.x, 0.0f, kTight);
    EXPECT_NEAR(s.wo.y, 0.0f, kTight);
    EXPECT_NEAR(s.wo.z, 1.0f, kTight);
    EXPECT_NEAR(glm::dot(s.wo, s.wi), glm::dot(normal, glm::normalize(other)), kTight);
    const Sample low{Vec3f(-0.999f, 0.0f, 0.04f), other, Vec3f(1.0f), 1.0f};
    EXPECT_TRUE(straightened(std::vector<Sample>{low}, {0.06, 0.0}).empty());
    EXPECT_TRUE(straightened(std::vector<Sample>{low}, {-0.06, 0.0}).empty());
    EXPECT_EQ(straightened(std::vector<Sample>{low}, {-0.02, 0.0}).size(), 1u);
}

}  // namespace
}  // namespace fbrdf
