// CompareViewTest.cpp - what keys do to a comparison, and where its line is.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/CompareView.h>
#include <gtest/gtest.h>

namespace fbrdf::scene {
namespace {

TEST(CompareModes, HaveNamesThatReadBack)
{
    for (int i = 0; i < kCompareModeCount; ++i) {
        const auto mode = static_cast<CompareMode>(i);
        EXPECT_EQ(compareModeFromName(compareModeName(mode)), mode);
        EXPECT_NE(compareModeNames().find(compareModeName(mode)), std::string::npos);
    }
    try {
        compareModeFromName("side");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

TEST(CompareKeys, GoThroughAllModesAndOff)
{
    CompareView compare;
    for (int i = 0; i < kCompareModeCount; ++i) {
        EXPECT_TRUE(applyCompareKey(compare, 'v'));
        EXPECT_TRUE(compare.on);
        EXPECT_EQ(compare.mode, static_cast<CompareMode>(i));
    }
    applyCompareKey(compare, 'v');
    EXPECT_FALSE(compare.on);
    EXPECT_FALSE(applyCompareKey(compare, 'z'));
}

TEST(CompareKeys, ChooseSidesAndStayWithinLimits)
{
    CompareView compare;
    compare.sideCount = 3;
    applyCompareKey(compare, '2');
    EXPECT_EQ(compare.b, 2);
    applyCompareKey(compare, '2');
    applyCompareKey(compare, '1');
    EXPECT_EQ(compare.b, 0);
    EXPECT_EQ(compare.a, 1);
    applyCompareKey(compare, '3');
    EXPECT_EQ(compare.a, 0);
    EXPECT_EQ(compare.b, 1);
    for (int i = 0; i < 100; ++i) applyCompareKey(compare, ']');
    EXPECT_EQ(compare.at, 1.0f);
    for (int i = 0; i < 100; ++i) applyCompareKey(compare, '[');
    EXPECT_EQ(compare.at, 0.0f);
    for (int i = 0; i < 100; ++i) applyCompareKey(compare, '>');
    EXPECT_EQ(compare.terms, kMostCompareTerms);
    for (int i = 0; i < 100; ++i) applyCompareKey(compare, '<');
    EXPECT_EQ(compare.terms, 1);
    for (int i = 0; i < 20; ++i) {
        applyCompareKey(compare, 'd');
        EXPECT_GE(compare.gain, kLeastGain);
        EXPECT_LE(compare.gain, kMostGain);
    }
}

TEST(CompareView, TheLineOfAWipeGoesToAndFroAndStandsWhereItIsHeld)
{
    CompareView compare;
    compare.at = 0.25f;
    EXPECT_EQ(compare.lineAt(1.7), 0.25f) << "a split stays where it was put";
    compare.mode = CompareMode::wipe;
    EXPECT_NEAR(compare.lineAt(0.0), 0.0f, 1e-6f);
    EXPECT_NEAR(compare.lineAt(0.5 * kWipeSeconds), 1.0f, 1e-6f);
    EXPECT_NEAR(compare.lineAt(kWipeSeconds), 0.0f, 1e-6f);
    applyCompareKey(compare, 'p');
    EXPECT_EQ(compare.lineAt(1.7), 0.25f);
}

TEST(CompareView, AFlipTakesTurnsUntilItIsHeld)
{
    CompareView compare;
    compare.on = true;
    compare.mode = CompareMode::flip;
    EXPECT_FALSE(compare.flipsToB(0.5 * kFlipSeconds));
    EXPECT_TRUE(compare.flipsToB(1.5 * kFlipSeconds));
    EXPECT_FALSE(compare.flipsToB(2.5 * kFlipSeconds));
    const CompareView before = compare;
    applyCompareKey(compare, '3');
    EXPECT_EQ(compare.a, before.a) << "3 shows the other one, and exchanges nothing";
    EXPECT_TRUE(compare.flipsToB(0.0) && compare.flipsToB(kFlipSeconds));
    applyCompareKey(compare, '3');
    EXPECT_FALSE(compare.flipsToB(0.0) || compare.flipsToB(1.5 * kFlipSeconds));
}

}  // namespace
}  // namespace fbrdf::scene
