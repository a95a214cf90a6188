// ExpectedValues.h - models against numbers from the same formulas written down a second time.
#pragma once
#include "Pairs.h"

#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

namespace fbrdf::test {

/// The other implementations' numbers are given with 12 digits.
constexpr double kTwelveDigits = 1e-10;

/// The pairs at which they were computed: near the mirror direction, at grazing, and crossed.
inline const DirectionPair<double> kExpectedAt[3] = {
    {directionDegrees(40.0, 170.0), directionDegrees(30.0, 0.0)},
    {directionDegrees(70.0, 215.0), directionDegrees(65.0, 20.0)},
    {directionDegrees(80.0, 80.0), directionDegrees(10.0, 90.0)}};

inline void expectValues(const std::string& spec, const Vec3d (&expected)[3])
{
    const Source source = makeModelSource(spec);
    for (int k = 0; k < 3; ++k) {
        const Vec3d f = source.evaluate(kExpectedAt[k].wo, kExpectedAt[k].wi);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(f[c], expected[k][c], kTwelveDigits * expected[k][c])
                << spec << " pair " << k << " channel " << c;
    }
}

}  // namespace fbrdf::test
