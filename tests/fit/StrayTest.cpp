// StrayTest.cpp - what a fit invents between and beyond its samples, and how it is kept from that.
#include "Known.h"
#include "search/Restrained.h"
#include "search/SeenErrors.h"
#include "search/Stray.h"

#include <fbrdf/fit/Fit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace fbrdf {
namespace {

constexpr int kThreads = 2;

Source grey()
{
    return test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
}

Material fittedTo(const Source& source)
{
    FitOptions options;
    options.form = "hdio";
    options.heldOut = false;
    return fitMaterial(source, options).material;
}

TEST(Stray, AHueIsThatOfNoNeighbour)
{
    const Stray stray(test::scattered(grey(), 1500, 2).samples, Vec3f(0.0f), true, kThreads);
    Material material = fittedTo(grey());
    EXPECT_LT(stray.of(material, kThreads).hue, 1e-3);
    EXPECT_LT(stray.of(material, kThreads).brightness, 1e-3);
    EXPECT_TRUE(stray.restraints(material, kThreads).empty());
    // A quarter of the texels of one factor loses its blue: yellow bands.
    Table& table = material.tables[0];
    for (size_t i = 0; i < table.texels.size(); i += 12) table.texels[i + 2] -= 2.0f;
    EXPECT_GT(stray.of(material, kThreads).hue, 0.1);
    const auto restraints = stray.restraints(material, kThreads);
    EXPECT_GT(restraints.size(), 500u);
    for (const Sample& s : restraints) EXPECT_NEAR(std::log(s.f.z / s.f.x), 0.0f, 0.2f);
}

TEST(Stray, BrighterThanAllNeighboursIsInventedDarkerIsNot)
{
    const Stray stray(test::scattered(grey(), 1500, 2).samples, Vec3f(0.0f), true, kThreads);
    Material material = fittedTo(grey());
    const Vec3f scale = material.scales[0];
    material.scales[0] = scale * 0.1f;
    EXPECT_LT(stray.of(material, kThreads).brightness, 1e-3);
    material.scales[0] = scale * 10.0f;
    EXPECT_NEAR(stray.of(material, kThreads).brightness, std::log(10.0) - 1.1, 0.3);
    EXPECT_LT(stray.of(material, kThreads).hue, 1e-3);
    const auto restraints = stray.restraints(material, kThreads);
    EXPECT_GT(restraints.size(), 3500u);  // of 4,096 pairs
    for (const Sample& s : restraints) {
        EXPECT_LT(s.f.x, evaluate(material, s.wo, s.wi).x);
        EXPECT_EQ(s.f.x, s.f.z);
    }
}

TEST(Stray, AChannelBelowTheFloorMayBeAnythingBelow)
{
    Material material = fittedTo(grey());
    auto samples = test::scattered(grey(), 1500, 2).samples;
    for (Sample& s : samples) s.f.z = 0.0f;
    const Stray stray(samples, Vec3f(0, 0, 1e-3f), true, kThreads);
    EXPECT_GT(stray.of(material, kThreads).hue, 0.5);  // grey, where blue was not seen
    for (const Sample& s : stray.restraints(material, kThreads)) EXPECT_LT(s.f.z, s.f.x * 0.5f);
    material.scales[0].z *= 1e-4f;
    EXPECT_LT(stray.of(material, kThreads).hue, 1e-3);
}

/// Scans that end at 75 degrees, as goniometers make them, with 20 % of noise.
std::vector<Sample> scans(const Source& source)
{
    constexpr double kPi = 3.14159265358979323846;
    const auto direction = [](double theta, double phi) {
        theta *= kPi / 180, phi *= kPi / 180;
        return Vec3f(Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                           std::cos(theta)));
    };
    std::mt19937 random(1);
    std::vector<Sample> samples;
    for (const double light : {10.0, 40.0, 70.0})
        for (double view = 0; view <= 75; view += 5)
            for (double azimuth = 0; azimuth <= 180; azimuth += 30) {
                const Vec3f wi = direction(light, 0), wo = direction(view, azimuth);
                const float noise = 1.0f + 0.4f * (float(random() % 1000) / 1000.0f - 0.5f);
                samples.push_back({wo, wi, Vec3f(source.evaluate(wo, wi)) * noise});
            }
    return samples;
}

TEST(Restrained, ASumInventsLessAndStaysNearItsSamples)
{
    Source source = test::sourceOf(test::Ggx{0.8, 0.8, 0.04, 0.3});
    source.samples = scans(source);
    source.evaluate = nullptr;
    FitOptions options;
    const FitContext context = makeFitContext(readDataset(source, options), options, source.name);
    const Stray stray(source.samples, context.statistics.floor, true, kThreads);
    // As many texels as samples: free between them.
    for (const auto& [name, size] : {std::pair{"io+hdio", 24}, std::pair{"gg+hdpio", 48}}) {
        const Form form = makeForm(name, size);
        const double before = stray.of(fitForm(context, form).material, kThreads).brightness;
        EXPECT_GT(before, 0.1) << name;
        const Restrained restrained = fitRestrained(context, form, stray);
        EXPECT_LT(restrained.stray.brightness, 0.3 * before) << name;
        EXPECT_LT(restrained.all.logMedian, 0.1) << name;  // of noise between 0 and 0.22
    }
}

TEST(Restrained, WhatInventsNothingStaysAsItIs)
{
    Source source = grey();
    source.samples = test::scattered(source, 3000, 2).samples;
    source.evaluate = nullptr;
    FitOptions options;
    const FitContext context = makeFitContext(readDataset(source, options), options, source.name);
    const Stray stray(source.samples, context.statistics.floor, true, kThreads);
    const Form form = makeForm("hdio", 16);
    EXPECT_EQ(fitRestrained(context, form, stray).fitted.material.tables[0].texels,
              fitForm(context, form).material.tables[0].texels);
}

}  // namespace
}  // namespace fbrdf
