// LobeWeightsTest.cpp - weights against conditions that every minimum meets, and known answers.
#include "LobeWeights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fbrdf;

namespace {

/// The normal equations of random positive functions of a few numbers.
WeightProblem randomProblem(std::mt19937& random, int count)
{
    std::uniform_real_distribution<double> number(0.0, 1.0);
    std::array<std::array<double, 12>, kMostWeights> functions{};
    std::array<double, 12> target{};
    for (auto& function : functions)
        for (double& value : function) value = number(random);
    for (double& value : target) value = number(random) - 0.2;
    WeightProblem problem;
    problem.count = count;
    for (size_t i = 0; i < static_cast<size_t>(count); ++i)
        for (size_t n = 0; n < target.size(); ++n) {
            problem.right[i] += functions[i][n] * target[n];
            for (size_t j = 0; j < static_cast<size_t>(count); ++j)
                problem.gram[i][j] += functions[i][n] * functions[j][n];
        }
    return problem;
}

double sumOf(const Weights& weights)
{
    double sum = 0.0;
    for (const double weight : weights) sum += weight;
    return sum;
}

/// Moves of weight from one lobe to another that lower the objective: none at the minimum.
bool canBeImproved(const WeightProblem& problem, const Weights& weights, double step)
{
    for (size_t i = 0; i < static_cast<size_t>(problem.count); ++i)
        for (size_t j = 0; j < static_cast<size_t>(problem.count); ++j) {
            Weights moved = weights;
            const double part = std::min(step, moved[i]);
            moved[i] -= part;
            moved[j] += part;
            if (objective(problem, moved) < objective(problem, weights) - 1e-10) return true;
        }
    return false;
}

TEST(LobeWeights, OfASumAddUpAndCannotBeImproved)
{
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const WeightProblem problem = randomProblem(random, 2 + i % 4);
        const double sum = 0.1 + 0.01 * i;
        const Weights weights = weightsOfSum(problem, sum);
        EXPECT_NEAR(sumOf(weights), sum, 1e-10);
        for (const double weight : weights) EXPECT_GE(weight, 0.0);
        EXPECT_FALSE(canBeImproved(problem, weights, 1e-3)) << i;
    }
}

TEST(LobeWeights, ImprovementIsSeen)  // the tester itself
{
    std::mt19937 random(3);
    const WeightProblem problem = randomProblem(random, 3);
    Weights even{};
    for (size_t i = 0; i < 3; ++i) even[i] = 0.3;
    EXPECT_TRUE(canBeImproved(problem, even, 1e-3));
}

TEST(LobeWeights, RoughOnesAreNearTheMinimum)
{
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        const WeightProblem problem = randomProblem(random, 2 + i % 3);
        const Weights rough = roughWeights(problem);
        for (const double weight : rough) EXPECT_GE(weight, 0.0);
        // The best of any sum is the minimum without one.
        double least = 0.0;
        for (double sum = 0.0; sum < 3.0; sum += 0.01)
            least = std::min(least, objective(problem, weightsOfSum(problem, sum)));
        EXPECT_LT(objective(problem, rough), least + 0.01 * std::abs(least) + 1e-3) << i;
    }
}

TEST(LobeWeights, OfNothingAreNothing)
{
    std::mt19937 random(7);
    EXPECT_NEAR(sumOf(weightsOfSum(randomProblem(random, 3), 0.0)), 0.0, 1e-12);
}

}  // namespace
