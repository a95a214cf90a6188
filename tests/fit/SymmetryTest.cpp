// SymmetryTest.cpp - what is asserted of a source is true wherever errors are measured. No GL.
#include "data/Symmetry.h"

#include "Known.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

// A Lambertian surface with a glint in a patch of half vectors: 1 in 1,700 of the uniform pairs.
Source patched(bool turns)
{
    Source source;
    source.evaluate = [turns](const Vec3d& wo, const Vec3d& wi) {
        const HalfDifference angles = halfDifferenceFromPair({wo, wi});
        const bool inRing = angles.theta_h > 0.50 && angles.theta_h < 0.52;
        const bool inPatch = inRing && (!turns || std::abs(angles.phi_h - 1.0) < 0.1);
        return Vec3d(inPatch ? 0.4 : 0.3);
    };
    return source;
}

TEST(Symmetry, ASmallAnisotropicPatchIsFound)
{
    EXPECT_FALSE(isIsotropicSource(patched(true)));
}

TEST(Symmetry, ARingIsIsotropic)
{
    EXPECT_TRUE(isIsotropicSource(patched(false)));
}

}  // namespace
}  // namespace fbrdf
