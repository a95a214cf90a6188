// CylinderProfileTest.cpp - what a direction sees of the section of the cylinders.
#include <models/CylinderProfile.h>

#include <fbrdf/brdf/Conventions.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::test {
namespace {

/// Closed forms against closed forms.
constexpr double kTight = 1e-12;

struct Shape {
    double height, spacing;
};
constexpr Shape kShapes[] = {{1.0, 1.0}, {1.0, 1.5},  {0.5, 1.0},  {0.5, 3.0},   {0.1, 1.2},
                             {0.9, 10.}, {-1.0, 1.0}, {-0.5, 1.5}, {-0.1, 1.01}, {-0.9, 4.0}};
constexpr double kGammas[] = {-1.5, -1.2, -0.7, -0.2, 0.0, 0.1, 0.4, 0.8, 1.1, 1.4, 1.55, 1.5707};

TEST(CylinderProfile, HasTheGeometryOfItsParameters)
{
    const CylinderProfile half(1.0, 1.5);
    EXPECT_FALSE(half.isGroove());
    EXPECT_NEAR(half.halfArc(), 0.5 * kPi, kTight);
    EXPECT_NEAR(half.halfWidth(), 1.0, kTight);
    EXPECT_NEAR(half.period(), 3.0, kTight);
    EXPECT_NEAR(half.floorWidth(), 1.0, kTight);
    const CylinderProfile groove(-0.5, 1.0);
    EXPECT_TRUE(groove.isGroove());
    EXPECT_NEAR(groove.halfArc(), kPi / 3.0, kTight);
    EXPECT_NEAR(groove.floorWidth(), 0.0, kTight);
}

/// Length that the visible part of a period shows to the direction: integral of n.w.
double projectedLength(const CylinderProfile& profile, double gamma)
{
    const Interval points = profile.visibleArc(gamma);
    const Interval arc = profile.isGroove() ? points.mirrored() : points;  // angles of normals
    const double onArc =
        arc.length() > 0.0 ? std::sin(arc.upper - gamma) - std::sin(arc.lower - gamma) : 0.0;
    return onArc + profile.visibleFloor(gamma).length() * std::cos(gamma);
}

TEST(CylinderProfile, ShowsExactlyItsPeriodToEveryDirection)
{
    // A surface without overhangs hides and shows so that the shown parts project to its base.
    for (const Shape& shape : kShapes)
        for (const double gamma : kGammas) {
            const CylinderProfile profile(shape.height, shape.spacing);
            EXPECT_NEAR(projectedLength(profile, gamma), profile.period() * std::cos(gamma),
                        kTight * profile.period())
                << shape.height << " " << shape.spacing << " gamma " << gamma;
        }
}

TEST(CylinderProfile, FromAboveShowsEverything)
{
    for (const Shape& shape : kShapes) {
        const CylinderProfile profile(shape.height, shape.spacing);
        EXPECT_NEAR(profile.visibleArc(0.0).length(), 2.0 * profile.halfArc(), kTight);
        EXPECT_NEAR(profile.visibleFloor(0.0).length(), profile.floorWidth(), kTight);
    }
}

TEST(CylinderProfile, IsSymmetric)
{
    for (const Shape& shape : kShapes)
        for (const double gamma : kGammas) {
            const CylinderProfile profile(shape.height, shape.spacing);
            EXPECT_EQ(profile.visibleArc(gamma).lower, -profile.visibleArc(-gamma).upper);
            EXPECT_EQ(profile.visibleFloor(gamma).lower, -profile.visibleFloor(-gamma).upper);
        }
}

/// Height of the profile at y, measured from a cylinder's axis.
double heightAt(const CylinderProfile& profile, double y)
{
    const double x = std::abs(std::remainder(y, profile.period()));
    if (x >= profile.halfWidth()) return 0.0;
    const double height = std::sqrt(1.0 - x * x) - std::cos(profile.halfArc());
    return profile.isGroove() ? -height : height;
}

/// True when nothing stands between the point at y and the direction, by walking along the ray.
bool seesByWalking(const CylinderProfile& profile, double y, double gamma)
{
    const double step = 1e-4, start = heightAt(profile, y);
    for (int k = 1; k < 200000; ++k) {
        const double along = k * step, rise = along * std::cos(gamma);
        if (start + rise > 1.0) return true;
        if (heightAt(profile, y + along * std::sin(gamma)) > start + rise) return false;
    }
    return true;
}

TEST(CylinderProfile, AgreesWithWalkingAlongRays)
{
    // Points within 0.02 of an interval's end are left to the walk's step.
    for (const Shape& shape : kShapes)
        for (const double gamma : {-1.4, -0.9, 0.3, 1.2, 1.5}) {
            const CylinderProfile profile(shape.height, shape.spacing);
            const Interval arc = profile.visibleArc(gamma), floor = profile.visibleFloor(gamma);
            const auto check = [&](double at, const Interval& seen, double y) {
                if (std::min(std::abs(at - seen.lower), std::abs(at - seen.upper)) < 0.02) return;
                EXPECT_EQ(seesByWalking(profile, y, gamma), at > seen.lower && at < seen.upper)
                    << shape.height << " " << shape.spacing << " gamma " << gamma << " y " << y;
            };
            for (int k = 0; k < 25; ++k) {
                const double t = 2.0 * (k + 0.5) / 25.0 - 1.0;
                const double psi = 0.999 * t * profile.halfArc();
                check(psi, arc, std::sin(psi));
                const double y = 0.5 * t * profile.floorWidth();
                if (profile.floorWidth() > 0.05) check(y, floor, y + 0.5 * profile.period());
            }
        }
}

}  // namespace
}  // namespace fbrdf::test
