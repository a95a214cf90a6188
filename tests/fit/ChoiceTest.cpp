// ChoiceTest.cpp - what `auto` compares: the errors that are seen, what is invented, and costs.
#include "Known.h"
#include "search/Candidate.h"
#include "search/SeenErrors.h"

#include <fbrdf/fit/Fit.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

std::vector<Sample> plastic(size_t count)
{
    return test::scattered(test::sourceOf(test::Ggx{0.1, 0.1, 0.04, 0.3}), count, 3).samples;
}

std::vector<Vec3f> valuesOf(const std::vector<Sample>& samples)
{
    std::vector<Vec3f> values;
    for (const Sample& s : samples) values.push_back(s.f);
    return values;
}

Candidate candidate(const std::string& form, std::vector<double> marks)
{
    Candidate c;
    c.form = makeForm(form, 8);
    c.bytes = 1000;
    c.lookups = lookupsPerLight(c.form);
    c.marks = std::move(marks);
    return c;
}

SampleErrors equalErrors()
{
    SampleErrors errors;
    errors.logMedian = errors.cosRms = errors.cubeRootRms = 0.1;
    return errors;
}

TEST(SeenErrors, AHighlightThatIsWrongInOneChannelIsSeen)
{
    const auto samples = plastic(2000);
    auto values = valuesOf(samples);
    EXPECT_EQ(seenErrors(samples, values, Vec3f(0.0f)).peak, 0.0);
    for (size_t i = 0; i < samples.size(); ++i)
        if (samples[i].f.x > 1.0f) values[i].x *= 0.4f;
    const SeenErrors errors = seenErrors(samples, values, Vec3f(0.0f));
    EXPECT_EQ(errors.body, 0.0);  // the median does not see it
    EXPECT_GT(errors.peak, 0.5);
    // The same loss in all channels has no hue.
    for (size_t i = 0; i < samples.size(); ++i) values[i] = Vec3f(values[i].x);
    EXPECT_LT(seenErrors(samples, values, Vec3f(0.0f)).peak, errors.peak + 0.3);
}

TEST(SeenErrors, AMarkGrowsWithEachError)
{
    const double least = markOf(SeenErrors{0.1, 0.1, 0.1});
    EXPECT_GT(markOf(SeenErrors{0.2, 0.1, 0.1}), least);
    EXPECT_GT(markOf(SeenErrors{0.1, 0.2, 0.1}), least);
    EXPECT_GT(markOf(SeenErrors{0.1, 0.1, 0.2}), least);
    EXPECT_EQ(markOf(SeenErrors{0.0, 0.0, 0.0}), std::log(1e-3));
}

TEST(Choice, NoiseDecidesNothing)
{
    // hdio is better by 1 % in the mean, and worse in two parts of five: hdg has fewer look-ups.
    const std::vector<Candidate> candidates{candidate("hdio", {0.99, 0.98, 1.00, 1.01, 0.97}),
                                            candidate("hdg", {1.01, 0.96, 1.02, 0.99, 1.02})};
    const Choice choice = choose(candidates);
    EXPECT_EQ(choice.index, 1u);
    EXPECT_NE(choice.reason.find("cheaper"), std::string::npos) << choice.reason;
}

TEST(Choice, ASureLeadWinsWhateverItCosts)
{
    const std::vector<Candidate> candidates{candidate("hdg", {1.01, 0.96, 1.02, 0.99, 1.02}),
                                            candidate("hdio", {0.91, 0.86, 0.92, 0.90, 0.93})};
    const Choice choice = choose(candidates);
    EXPECT_EQ(choice.index, 1u);
    EXPECT_NE(choice.reason.find("hdg"), std::string::npos) << choice.reason;
}

TEST(Choice, OneErrorOnAllSamplesIsNotGivenAwayForCheapness)
{
    std::vector<Candidate> candidates{candidate("hdio", {0.99, 0.98, 1.00, 1.01, 0.97}),
                                      candidate("hdg", {1.01, 0.96, 1.02, 0.99, 1.02})};
    for (Candidate& c : candidates) {
        c.whole.emplace();
        c.whole->all = equalErrors();
    }
    candidates[1].whole->all.cosRms = 0.13;
    EXPECT_EQ(choose(candidates).index, 0u);
    candidates[1].whole->all.logMedian = 0.05;  // more than made up for
    EXPECT_EQ(choose(candidates).index, 1u);
}

TEST(Choice, OfEqualsTheOneIsTakenThatIsBetterOnAllSamples)
{
    // hdio, which costs more, is as good as hdg but for chance, and a third nearer to all
    // highlights.
    std::vector<Candidate> candidates{candidate("hdg", {0.99, 0.96, 1.00, 0.99, 0.97}),
                                      candidate("hdio", {0.98, 0.98, 0.99, 1.01, 0.98})};
    for (Candidate& c : candidates) {
        c.whole.emplace();
        c.whole->all = equalErrors();
    }
    EXPECT_EQ(choose(candidates).index, 0u);
    candidates[0].whole->all.cosRms = 0.13;
    const Choice choice = choose(candidates);
    EXPECT_EQ(choice.index, 1u);
    EXPECT_NE(choice.reason.find("better on all"), std::string::npos) << choice.reason;
    for (double& mark : candidates[1].marks) mark += 0.1;  // surely worse: it suits the noise
    EXPECT_EQ(choose(candidates).index, 0u);
}

TEST(Choice, WhereTrialsHaveAPartOfTheSamplesTheErrorsHeldOutDecide)
{
    std::vector<Candidate> candidates{candidate("hdio", {0.99, 0.98, 1.00, 1.01, 0.97}),
                                      candidate("hdg", {1.01, 0.96, 1.02, 0.99, 1.02})};
    for (Candidate& c : candidates) c.held.errors = equalErrors();
    EXPECT_EQ(choose(candidates).index, 1u);
    candidates[1].held.errors.cosRms = 0.13;
    EXPECT_EQ(choose(candidates).index, 0u);
}

TEST(Choice, FitsToAllOfManySamplesAreBeatenByWhatIsBetterOnThem)
{
    // The marks, which pictures have a part in, are surely lower for hdg.
    std::vector<Candidate> candidates{candidate("hdio", {0.99, 0.98, 1.00, 1.01, 0.97}),
                                      candidate("hdg", {0.89, 0.88, 0.90, 0.91, 0.87})};
    for (Candidate& c : candidates) {
        c.whole.emplace();
        c.whole->all = equalErrors();
        c.isFinal = true;
    }
    EXPECT_EQ(choose(candidates).index, 1u);
    candidates[1].whole->all.cosRms = 0.13;
    const Choice choice = choose(candidates);
    EXPECT_EQ(choice.index, 0u);
    EXPECT_NE(choice.reason.find("better on all samples than hdg"), std::string::npos)
        << choice.reason;
    candidates[0].whole->all.logMedian = 0.15;  // each is better in one error
    EXPECT_EQ(choose(candidates).index, 1u);
}

TEST(SeenErrors, APictureIsAFourthError)
{
    EXPECT_LT(withPicture(-4.0, 0.5), withPicture(-4.0, 2.0));
    EXPECT_LT(withPicture(-4.5, 1.0), withPicture(-4.0, 1.0));
    EXPECT_EQ(withPicture(std::log(1e-3), 0.0), std::log(1e-3));
}

TEST(Choice, WhatIsInventedIsAFault)
{
    std::vector<Candidate> candidates{candidate("hdio", {0.8, 0.8, 0.8, 0.8, 0.8}),
                                      candidate("hdpio", {1.0, 1.0, 1.0, 1.0, 1.0})};
    for (Candidate& c : candidates) {
        c.whole.emplace();
        c.whole->allMark = c.marks[0];
    }
    EXPECT_EQ(choose(candidates).index, 0u);
    candidates[0].whole->inventedHue = 0.2;
    EXPECT_EQ(choose(candidates).index, 1u);
}

}  // namespace
}  // namespace fbrdf
