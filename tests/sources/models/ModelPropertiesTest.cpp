// ModelPropertiesTest.cpp - what every analytic model must satisfy, over its whole parameter range.
#include "Furnace.h"
#include "Pairs.h"
#include "Parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

namespace fbrdf::test {
namespace {

/// Rounding in h.z of a highlight 1e-4 wide, where f changes by 1e8 eps, and of elevations of 0.6
/// degrees.
constexpr double kRounding = 1e-6;
/// Angles of rotation are as good as sin and cos; the same highlights magnify them.
constexpr double kRotation = 1e-5;

class EveryModel : public testing::TestWithParam<std::string> {
protected:
    const Model& model() const { return *findModel(GetParam()); }
    static Source sourceOf(const Model& model, const ModelValues& values)
    {
        return makeModelSource(specOf(model, values));
    }
};

bool isFiniteAndPositive(const Vec3d& f)
{
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(f[c]) || f[c] < 0.0) return false;
    return true;
}

/// |a - b| <= relative max(a, b), per channel.
testing::AssertionResult agree(const Vec3d& a, const Vec3d& b, double relative)
{
    for (int c = 0; c < 3; ++c)
        if (!(std::abs(a[c] - b[c]) <= relative * std::max(a[c], b[c]) + 1e-300))
            return testing::AssertionFailure()
                   << "channel " << c << ": " << a[c] << " and " << b[c];
    return testing::AssertionSuccess();
}

std::string textOf(const DirectionPair<double>& pair)
{
    char text[200];
    std::snprintf(text, sizeof text, "wo %.17g %.17g %.17g wi %.17g %.17g %.17g", pair.wo.x,
                  pair.wo.y, pair.wo.z, pair.wi.x, pair.wi.y, pair.wi.z);
    return text;
}

/// A parameter set without extremes, in which highlights are wide enough to compare two roundings.
std::vector<ModelValues> moderateSets(const Model& model, int count)
{
    std::vector<ModelValues> sets = {defaultValues(model)};
    std::mt19937 random(7);
    while (static_cast<int>(sets.size()) < count) {
        ModelValues values = randomValues(model, random);
        bool moderate = true;
        for (const char* name : {"alpha", "alpha_x", "alpha_y"})
            if (values.count(name)) moderate = moderate && values[name].x > 0.005;
        for (const char* name : {"n", "nu", "nv", "B"})
            if (values.count(name)) moderate = moderate && values[name].x < 1e5;
        if (moderate) sets.push_back(values);
    }
    return sets;
}

TEST_P(EveryModel, IsFiniteAndNotNegativeForAllParametersAndDirections)
{
    std::vector<DirectionPair<double>> pairs = awkwardPairs();
    for (const auto& pair : spreadPairs(60)) pairs.push_back(pair);
    for (const ModelValues& values : valueSets(model(), 150)) {
        const Source source = sourceOf(model(), values);
        for (const auto& pair : pairs)
            ASSERT_TRUE(isFiniteAndPositive(source.evaluate(pair.wo, pair.wi)) &&
                        isFiniteAndPositive(source.evaluate(pair.wi, pair.wo)))
                << source.name << "\n"
                << textOf(pair);
    }
}

TEST_P(EveryModel, ReflectsNothingBelowTheHorizon)
{
    const Source source = makeModelSource(GetParam());
    const Vec3d above = directionDegrees(30.0, 10.0), horizon(1.0, 0.0, 0.0);
    for (const Vec3d& below : {horizon, -above, directionDegrees(91.0, 40.0)}) {
        EXPECT_EQ(source.evaluate(above, below), Vec3d(0.0));
        EXPECT_EQ(source.evaluate(below, above), Vec3d(0.0));
        EXPECT_EQ(source.evaluate(below, below), Vec3d(0.0));
    }
    EXPECT_GT(source.evaluate(above, above).x, 0.0);
}

TEST_P(EveryModel, IsReciprocal)
{
    for (const ModelValues& values : moderateSets(model(), 12)) {
        const Source source = sourceOf(model(), values);
        for (const auto& pair : spreadPairs(500))
            ASSERT_TRUE(agree(source.evaluate(pair.wo, pair.wi), source.evaluate(pair.wi, pair.wo),
                              kRounding))
                << source.name << "\n"
                << textOf(pair);
    }
}

Vec3d rotated(const Vec3d& w, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

/// The same without the parameters that distinguish the tangent.
ModelValues withoutDirection(ModelValues values)
{
    const std::pair<const char*, const char*> twins[] = {
        {"alpha_x", "alpha_y"}, {"nu", "nv"}, {"cx", "cy"}};
    for (const auto& [along, across] : twins)
        if (values.count(along)) values[across] = values[along];
    for (const char* name : {"anisotropic", "height"})
        if (values.count(name)) values[name] = Vec3d(0.0);
    return values;
}

TEST_P(EveryModel, IsUnchangedByRotationWhenIsotropic)
{
    for (const ModelValues& values : moderateSets(model(), 12)) {
        const Source source = sourceOf(model(), withoutDirection(values));
        ASSERT_TRUE(source.isotropic) << source.name;
        for (const auto& pair : spreadPairs(200))
            ASSERT_TRUE(agree(source.evaluate(pair.wo, pair.wi),
                              source.evaluate(rotated(pair.wo, 1.1), rotated(pair.wi, 1.1)),
                              kRotation))
                << source.name << "\n"
                << textOf(pair);
    }
}

TEST_P(EveryModel, ChangesWithRotationWhenAnisotropic)
{
    for (const ModelValues& values : moderateSets(model(), 12)) {
        const Source source = sourceOf(model(), values);
        if (source.isotropic) continue;
        double largest = 0.0;
        for (const auto& pair : spreadPairs(200)) {
            const Vec3d f = source.evaluate(pair.wo, pair.wi);
            const Vec3d turned = source.evaluate(rotated(pair.wo, 1.1), rotated(pair.wi, 1.1));
            largest = std::max(largest, glm::length(f - turned) / glm::length(f + turned));
        }
        EXPECT_GT(largest, 1e-3) << source.name;
    }
}

TEST_P(EveryModel, HasTheTwoMirrorSymmetriesOfItsTangentFrame)
{
    const Vec3d x(-1.0, 1.0, 1.0), y(1.0, -1.0, 1.0);
    for (const ModelValues& values : moderateSets(model(), 6)) {
        const Source source = sourceOf(model(), values);
        for (const auto& pair : spreadPairs(200)) {
            const Vec3d f = source.evaluate(pair.wo, pair.wi);
            for (const Vec3d& mirror : {x, y})
                ASSERT_TRUE(
                    agree(f, source.evaluate(pair.wo * mirror, pair.wi * mirror), kRounding))
                    << source.name << "\n"
                    << textOf(pair);
        }
    }
}

/// Sets for which the model promises to conserve: the promise is often kd + ks <= 1, which random
/// sets seldom keep, so diffuse parts are also scaled down.
std::vector<ModelValues> conservingSets(const Model& model)
{
    std::vector<ModelValues> sets;
    for (ModelValues values : moderateSets(model, 8)) {
        // Within what the quadrature resolves, and, for he-torrance, what it can afford.
        if (values.count("sigma")) values["sigma"] = Vec3d(std::min(values["sigma"].x, 1.0));
        if (values.count("n")) values["n"] = Vec3d(std::min(values["n"].x, 2000.0));
        if (!model.energy.holds(values) && values.count("ks"))
            values["kd"] = Vec3d(1.0) - values["ks"];
        if (!model.energy.holds(values) && values.count("kd")) values["kd"] = Vec3d(0.0);
        if (values.count("f0")) values["f0"] = Vec3d(1.0);
        if (model.energy.holds(values)) sets.push_back(values);
    }
    return sets;
}

TEST_P(EveryModel, ConservesEnergyWhereItPromisesTo)
{
    const std::vector<ModelValues> sets = conservingSets(model());
    EXPECT_EQ(sets.empty(), model().energy.condition.empty());
    for (const ModelValues& values : sets) {
        const Source source = sourceOf(model(), values);
        EXPECT_TRUE(conserves(source.evaluate))
            << source.name << " reflects " << largestAlbedo(source.evaluate);
    }
}

TEST_P(EveryModel, GivesTheSameFromSeveralThreads)
{
    const Source source = makeModelSource(GetParam());
    const auto pairs = spreadPairs(300);
    std::vector<Vec3d> expected;
    for (const auto& pair : pairs) expected.push_back(source.evaluate(pair.wo, pair.wi));
    std::atomic<int> different{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (size_t k = 0; k < pairs.size(); ++k)
                different += source.evaluate(pairs[k].wo, pairs[k].wi) == expected[k] ? 0 : 1;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(different, 0);
}

TEST_P(EveryModel, HasASoundParameterTable)
{
    std::set<std::string> names;
    for (const ModelParameter& parameter : model().parameters) {
        EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
        EXPECT_LT(parameter.lower, parameter.upper) << parameter.name;
        EXPECT_GE(parameter.initial, parameter.lower) << parameter.name;
        EXPECT_LE(parameter.initial, parameter.upper) << parameter.name;
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
        EXPECT_EQ(parameter.kind == ModelParameter::Kind::shorthand, !parameter.sets.empty());
        for (const std::string& target : parameter.sets)
            EXPECT_TRUE(defaultValues(model()).count(target)) << target;
    }
    EXPECT_FALSE(model().title.empty());
    EXPECT_NE(model().paper.find_first_of("0123456789"), std::string::npos) << "no year";
}

std::vector<std::string> modelNames()
{
    std::vector<std::string> names;
    for (const Model& model : models()) names.push_back(model.name);
    return names;
}

/// Names of tests have no '-'.
std::string testNameOf(const testing::TestParamInfo<std::string>& parameter)
{
    std::string name = parameter.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(modelNames()), testNameOf);

}  // namespace
}  // namespace fbrdf::test
