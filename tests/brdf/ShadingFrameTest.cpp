// ShadingFrameTest.cpp - frames from interpolated normals and tangents.
#include "brdf/Directions.h"

#include <fbrdf/brdf/ShadingFrame.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

template <class T>
void expectOrthonormal(const ShadingFrame<T>& frame, T tolerance)
{
    for (const Vec3<T>& v : {frame.t, frame.s, frame.n})
        ASSERT_NEAR(glm::length(v), T(1), tolerance);
    ASSERT_NEAR(glm::dot(frame.t, frame.n), T(0), tolerance);
    ASSERT_NEAR(glm::length(glm::cross(frame.n, frame.t) - frame.s), T(0), tolerance);
}

TEST(ShadingFrame, IsOrthonormalAndRightHandedWithTheTangentAhead)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const Vec3d normal = 3.0 * pair.wo, tangent = 0.01 * pair.wi;  // interpolated: any length
        const auto frame = shadingFrame(normal, tangent);
        expectOrthonormal(frame, 1e-12);
        expectOrthonormal(shadingFrame(Vec3f(normal), Vec3f(tangent)), 1e-5f);
        ASSERT_LT(test::distance(frame.n, pair.wo), 1e-14);
        ASSERT_NEAR(glm::dot(frame.s, tangent), 0.0, 1e-12);
        if (test::distance(pair.wo, pair.wi) < 0.01) continue;
        ASSERT_GT(glm::dot(frame.t, tangent), 0.0);
    }
}

TEST(ShadingFrame, LocalCoordinatesOfItsOwnAxesAreUnitVectors)
{
    const auto frame = shadingFrame(Vec3d(0.2, 0.3, 0.9), Vec3d(1.0, 0.1, 0.0));
    EXPECT_LT(test::distance(frame.local(frame.t), {1.0, 0.0, 0.0}), 1e-15);
    EXPECT_LT(test::distance(frame.local(frame.s), {0.0, 1.0, 0.0}), 1e-15);
    EXPECT_LT(test::distance(frame.local(frame.n), {0.0, 0.0, 1.0}), 1e-15);
}

TEST(ShadingFrame, UselessTangentsGiveAFrameAllTheSame)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const Vec3d normal = test::pair(n).wi;
        for (const double factor : {0.0, 1.0, -7.0}) {
            expectOrthonormal(shadingFrame(normal, factor * normal), 1e-12);
            const Vec3f single(normal);
            expectOrthonormal(shadingFrame(single, static_cast<float>(factor) * single), 1e-5f);
        }
    }
}

}  // namespace
