#include "Unsampled.h"

#include "Known.h"
#include "solve/LeastSquares.h"
#include "TexelWeights.h"

#include <fbrdf/fit/Fit.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

// Samples of a red surface with green noise, under light from below 50 degrees alone.
Source redUpTo50Degrees()
{
    Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}), 4000, 2);
    std::vector<Sample> kept;
    for (Sample s : source.samples) {
        if (s.wi.z < 0.64f || s.wo.z < 0.64f) continue;
        const auto k = static_cast<float>(splitMix64(kept.size()) % 1000) / 1000.0f;
        s.f = {s.f.x, s.f.y * (0.1f + 0.02f * k), s.f.z * 0.1f};
        kept.push_back(s);
    }
    source.samples = std::move(kept);
    return source;
}

TEST(Unsampled, TheHueGoesOnBeyondTheSamples)
{
    FitOptions options;
    options.form = "hdio";
    options.heldOut = false;
    options.smoothness = 1e-4;
    const Material material = fitMaterial(redUpTo50Degrees(), options).material;
    const Table& table = material.tables[1];
    const int side = domainSize(table.domain)[0], last = side * side - 1;
    EXPECT_TRUE(table.unsupported[0] || table.unsupported[static_cast<size_t>(last)]);
    constexpr double kNoise = 0.2;  // the edge texels of two tables, each off by a tenth
    for (const double degrees : {60.0, 70.0, 80.0, 85.0}) {
        const double theta = degrees * kPi / 180.0;
        const Vec3d wi(std::sin(theta), 0.0, std::cos(theta)), wo(-wi.x, 0.0, wi.z);
        const Vec3d f = evaluate(material, wo, wi);
        EXPECT_NEAR(std::log(f.y / f.x), std::log(0.11), kNoise) << degrees;
        EXPECT_NEAR(std::log(f.z / f.x), std::log(0.1), kNoise) << degrees;
    }
}

TEST(Unsampled, SupportedTexelsStayAsTheyAre)
{
    const Material wave = test::waveMaterial(makeForm("hdio", 8));
    const Source source = redUpTo50Degrees();
    const LeastSquares problem(wave.form, datasetInMemory(source.samples), {}, 1, 1);
    State x(problem.columns() * problem.unknowns());
    for (size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i));
    const std::vector<double> weights = texelWeights(problem);
    State next = x;
    extendHue(problem.form(), problem.layout(), weights, next);
    size_t changed = 0;
    for (size_t u = 0; u < problem.unknowns(); ++u) {
        const size_t n = problem.unknowns();
        const double brightness = x[u] + x[n + u] + x[2 * n + u];
        EXPECT_NEAR(next[u] + next[n + u] + next[2 * n + u], brightness, 1e-12) << u;
        if (next[u] != x[u]) ++changed;
        if (weights[u] > kLeastTexelWeight) {
            EXPECT_EQ(next[u], x[u]) << u;
        }
    }
    EXPECT_GT(changed, 0u);
}

}  // namespace
}  // namespace fbrdf
