#include <fbrdf/fit/SamplePlan.h>

#include "prior/PriorCovariance.h"
#include "solve/Rows.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>
#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/LU>

namespace fbrdf {
namespace {

// A prior without modes: smoothness alone; all unknowns are seen alike.
struct Simple {
    TablePrior prior;
    KnownMaterials known;

    Simple()
    {
        prior.form = known.form = formHdio({8, 4, 4});
        const auto n = static_cast<size_t>(Layout(prior.form).unknowns());
        prior.mean.assign(n, 0.0f);
        known.seen.assign(n * n, 0.0);
        for (size_t i = 0; i < n; ++i) known.seen[i * n + i] = 1.0;
    }
};

// The trace of the covariance that samples at a plan leave.
double traceAfter(const Simple& simple, const SamplePlan& plan)
{
    constexpr double kOctave = 1.442695, kTau = 0.1 * kOctave, kNoise = 0.01 * kOctave * kOctave;
    const PriorMatrix root = smoothnessRoot(simple.prior.form);
    const Layout layout(simple.prior.form);
    const RowMaker maker(simple.prior.form, layout);
    PriorMatrix precision = (kTau * kTau * root.transpose() * root).inverse();
    std::vector<int> unknown(static_cast<size_t>(maker.width()));
    std::vector<float> weight(unknown.size());
    for (const auto& pair : plan) {
        maker.make({Vec3f(pair.wo), Vec3f(pair.wi), {}}, unknown.data(), weight.data());
        PriorVector row = PriorVector::Zero(precision.rows());
        for (size_t k = 0; k < unknown.size(); ++k)
            row(unknown[k]) += static_cast<double>(weight[k]);
        precision += row * row.transpose() / kNoise;
    }
    return precision.inverse().trace();
}

TEST(SamplePlan, EveryPairLowersTheTraceMoreThanOthersWould)
{
    const Simple simple;
    const SamplePlan plan = planSamples(simple.prior, simple.known, PlanSpace::hemisphere, 4);
    ASSERT_EQ(plan.size(), 4u);
    for (size_t k = 0; k < plan.size(); ++k) {
        SamplePlan first(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(k + 1));
        const double chosen = traceAfter(simple, first);
        for (const auto& other : uniformPairs(40, 5)) {
            first.back() = other;
            EXPECT_LE(chosen, traceAfter(simple, first) * 1.001) << k;  // the pool is coarse
        }
    }
}

TEST(SamplePlan, FewerAreAPrefixOfMore)
{
    for (const PlanSpace space : {PlanSpace::hemisphere, PlanSpace::planeOfIncidence}) {
        const SamplePlan all = shippedPlan(space, 2048), few = shippedPlan(space, 16);
        ASSERT_EQ(few.size(), 16u);
        for (size_t i = 0; i < few.size(); ++i) {
            EXPECT_EQ(few[i].wo, all[i].wo);
            EXPECT_EQ(few[i].wi, all[i].wi);
        }
    }
}

TEST(SamplePlan, NoPairComesTwiceOrLiesBelowTheHorizon)
{
    for (const PlanSpace space : {PlanSpace::hemisphere, PlanSpace::planeOfIncidence}) {
        const SamplePlan plan = shippedPlan(space, 2048);
        for (size_t i = 0; i < plan.size(); ++i) {
            EXPECT_GT(plan[i].wo.z, std::sin(kMinElevation) - 1e-3);
            EXPECT_GT(plan[i].wi.z, std::sin(kMinElevation) - 1e-3);
            for (size_t j = 0; j < i; ++j)
                EXPECT_FALSE(plan[i].wo == plan[j].wo && plan[i].wi == plan[j].wi) << i << " " << j;
        }
    }
}

TEST(SamplePlan, InThePlaneOfIncidenceAllIsInOnePlane)
{
    for (const auto& pair : shippedPlan(PlanSpace::planeOfIncidence, 2048))
        EXPECT_NEAR(glm::dot(glm::cross(pair.wi, pair.wo), Vec3d(0.0, 0.0, 1.0)), 0.0, 1e-4);
}

TEST(SamplePlan, TextGivesThePairsBack)
{
    const SamplePlan plan = shippedPlan(PlanSpace::hemisphere, 64);
    EXPECT_EQ(planText(planFromText(planText(plan), "p")), planText(plan));
}

TEST(SamplePlan, OtherTextsAreRefused)
{
    for (const char* text : {"", "a,b,c\n1,2,3\n", "theta_h,theta_d,phi_d\n1,2\n",
                             "theta_h,theta_d,phi_d\n1,2,x\n", "theta_h,theta_d,phi_d\n1,2,181\n",
                             "theta_h,theta_d,phi_d\n-1,2,3\n", "theta_h,theta_d,phi_d\n1,nan,3\n"})
        EXPECT_THROW(planFromText(text, "p"), Error) << text;
}

TEST(SamplePlan, MoreThanThereAreIsAnError)
{
    EXPECT_THROW(shippedPlan(PlanSpace::hemisphere, 0), Error);
    EXPECT_THROW(shippedPlan(PlanSpace::hemisphere, 2049), Error);
    const Simple simple;
    EXPECT_THROW(planSamples(simple.prior, simple.known, PlanSpace::hemisphere, 5001), Error);
}

}  // namespace
}  // namespace fbrdf
