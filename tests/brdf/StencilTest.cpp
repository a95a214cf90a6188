// StencilTest.cpp - linear filtering as weights: they sum to one, stay inside the table, and
// reproduce linear functions, which wrong weights would not.
#include "brdf/Directions.h"

#include <fbrdf/brdf/Projection.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace fbrdf;

namespace {

constexpr double kTight = 1e-13;
constexpr float kFloat = 4e-6f;  // positions of up to 8, values of up to 60, eps 6e-8 each

Domain grid(const std::vector<int>& sizes)
{
    GridDomain domain;
    for (const int size : sizes) domain.axes.push_back({size, {}});
    return domain;
}

const Domain kDomains[] = {grid({5}),
                           grid({5, 4}),
                           grid({5, 4, 3}),
                           grid({5, 1, 3}),
                           grid({1}),
                           grid({1, 1, 6}),
                           DiscDomain::fitting(6, 0.5)};

template <class T>
Vec3<T> positionIn(const Domain& domain, int n, double margin = 0.0)
{
    const auto size = domainSize(domain);
    const auto p = test::point(n);
    Vec3<T> position(T(0));
    for (size_t d = 0; d < 3; ++d)
        position[static_cast<int>(d)] =
            static_cast<T>((size[d] - 1) * ((1.0 + 2.0 * margin) * p[d] - margin));
    return position;
}

/// The weighted sum of a function of the texels' coordinates.
template <class T>
T filtered(const Domain& domain, const Vec3<T>& position, const std::function<T(Vec3<T>)>& f)
{
    const auto size = domainSize(domain);
    const Stencil<T> stencil = stencilAt(domain, position);
    T sum = T(0);
    for (int k = 0; k < stencil.count; ++k) {
        const int texel = stencil.texel[static_cast<size_t>(k)];
        const Vec3<T> at(static_cast<T>(texel % size[0]), static_cast<T>(texel / size[0] % size[1]),
                         static_cast<T>(texel / size[0] / size[1]));
        sum += stencil.weight[static_cast<size_t>(k)] * f(at);
    }
    return sum;
}

template <class T>
T linear(const Vec3<T>& v)
{
    return T(2) + T(3) * v.x - T(5) * v.y + T(7) * v.z;
}

TEST(Stencil, WeightsSumToOneAndTexelsExist)
{
    for (const Domain& domain : kDomains)
        for (int n = 0; n < 500; ++n) {
            const auto stencil = stencilAt(domain, positionIn<double>(domain, n, 0.2));
            double sum = 0.0;
            for (int k = 0; k < stencil.count; ++k) {
                const auto slot = static_cast<size_t>(k);
                ASSERT_GE(stencil.weight[slot], 0.0);
                ASSERT_LE(stencil.weight[slot], 1.0);
                ASSERT_GE(stencil.texel[slot], 0);
                ASSERT_LT(stencil.texel[slot], texelCount(domain));
                sum += stencil.weight[slot];
            }
            ASSERT_NEAR(sum, 1.0, kTight);
        }
}

TEST(Stencil, HasTwoTexelsForEachAxisThatVaries)
{
    const int counts[] = {2, 4, 8, 4, 1, 2, 4};
    for (size_t k = 0; k < 7; ++k)
        EXPECT_EQ(stencilAt(kDomains[k], Vec3d(0.3)).count, counts[k]) << k;
}

TEST(Stencil, ReproducesLinearFunctions)
{
    for (const Domain& domain : kDomains)
        for (int n = 0; n < 500; ++n) {
            const Vec3d p = positionIn<double>(domain, n);
            ASSERT_NEAR(filtered<double>(domain, p, linear<double>), linear(p), kTight * 60.0);
            const Vec3f q(p);
            ASSERT_NEAR(filtered<float>(domain, q, linear<float>), linear(q), kFloat * 10.0f);
        }
}

// The tester: filtering is linear, so a square must not be reproduced.
TEST(Stencil, DoesNotReproduceSquares)
{
    const auto square = [](Vec3d v) { return v.x * v.x; };
    EXPECT_NEAR(filtered<double>(kDomains[0], Vec3d(1.5, 0.0, 0.0), square), 2.5, kTight);
}

TEST(Stencil, TakesOneTexelAtItsCentre)
{
    const Domain& domain = kDomains[2];
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 5; ++x) {
                const auto stencil = stencilAt(domain, Vec3d(x, y, z));
                double weight = 0.0;
                for (size_t k = 0; k < 8; ++k)
                    if (stencil.texel[k] == x + 5 * (y + 4 * z)) weight += stencil.weight[k];
                EXPECT_EQ(weight, 1.0);
            }
}

TEST(Stencil, PositionsOutsideAreMovedToTheBorder)
{
    const Domain& domain = kDomains[1];
    EXPECT_EQ(filtered<double>(domain, Vec3d(-3.0, 99.0, 5.0), linear<double>),
              linear(Vec3d(0.0, 3.0, 0.0)));
    EXPECT_EQ(filtered<double>(domain, Vec3d(INFINITY, -INFINITY, 0.0), linear<double>),
              linear(Vec3d(4.0, 0.0, 0.0)));
}

// A direction that is not a number must not become an index.
TEST(Stencil, NotANumberReadsAnExistingTexel)
{
    for (const Domain& domain : kDomains) {
        const auto stencil = stencilAt(domain, Vec3f(NAN, NAN, NAN));
        for (int k = 0; k < stencil.count; ++k) {
            EXPECT_GE(stencil.texel[static_cast<size_t>(k)], 0);
            EXPECT_LT(stencil.texel[static_cast<size_t>(k)], texelCount(domain));
        }
    }
}

}  // namespace
