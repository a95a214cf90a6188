// FormatPageTest.cpp - docs/format.md is enough: files that are written from it read as materials
// of known values, and a reader that follows it agrees with ours on every form and storage.
#include "io/FormatPage.h"
#include "io/TestMaterials.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fbrdf;
using fbrdf::test::TemporaryDir;

namespace {

// Ours computes 1 - cos without cancellation, the page says it plainly: near the pole the square
// root of the difference loses half of double's digits, and 2^20 or so amplifies what is lost.
constexpr double kRelative = 1e-5;

Vec3d someDirection(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double z = 0.02 + 0.97 * unit(random), phi = 2.0 * kPi * unit(random);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

void expectSameAsPage(const std::string& path, const Material& material, const Vec3d& wo,
                      const Vec3d& wi)
{
    const Vec3d ours = evaluate<double>(material, wo, wi);
    const page::Triple theirs = page::evaluateFile(path, {wo.x, wo.y, wo.z}, {wi.x, wi.y, wi.z});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(theirs[static_cast<size_t>(c)], ours[c], kRelative * std::abs(ours[c]) + 1e-30)
            << material.form.name << " " << storageName(material.tables[0].storage);
}

TEST(FormatPage, AFileWrittenFromItReads)
{
    const TemporaryDir folder;
    const std::string path = folder.file("page.fbrdf");
    page::writeThreeTables(path);
    EXPECT_TRUE(isMaterialFile(path));
    const Material material = readMaterial(path);
    EXPECT_EQ(material.name, "by the page");
    EXPECT_EQ(material.notes.at("source"), "docs/format.md");
    EXPECT_EQ(material.tables[2].unsupported, (std::vector<bool>{false, false, true}));
    // Along the normal: 2^2 2^1 (1, 2, 3) + (0, 0, 1) 2^2.
    const Vec3d n(0.0, 0.0, 1.0), along = evaluate<double>(material, n, n);
    EXPECT_NEAR(along.x, 8.0, 1e-12);
    EXPECT_NEAR(along.y, 16.0, 1e-12);
    EXPECT_NEAR(along.z, 28.0, 1e-12);
    // wo = wi at 60 degrees along x: theta_i 60 degrees gives 2^1; h falls at x = sin / (1 + cos) =
    // 1 / sqrt(3) of the disc, where log2 b = 1 - 2 x; u = sqrt(1/2), position sqrt(2), gives
    // log2 c = 4 - (sqrt(2) - 1).
    const Vec3d tilted(std::sqrt(0.75), 0.0, 0.5), f = evaluate<double>(material, tilted, tilted);
    const double product = 2.0 * std::exp2(1.0 - 2.0 / std::sqrt(3.0));
    EXPECT_NEAR(f.x, product, 1e-12);
    EXPECT_NEAR(f.y, 2.0 * product, 1e-12);
    EXPECT_NEAR(f.z, 3.0 * product + std::exp2(5.0 - std::sqrt(2.0)), 1e-11);
    expectSameAsPage(path, material, tilted, n);
}

TEST(FormatPage, ItsExampleReads)
{
    const TemporaryDir folder;
    const std::string path = folder.file("grey.fbrdf");
    page::writeGrey(path);
    const Vec3d f = evaluate<double>(readMaterial(path), {0.6, 0.0, 0.8}, {0.0, 0.0, 1.0});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], 0.5 / kPi, 1e-8);
}

TEST(FormatPage, AReaderWrittenFromItAgreesOnEveryFormAndStorage)
{
    const TemporaryDir folder;
    const std::string path = folder.file("ours.fbrdf");
    std::mt19937 random(3);
    for (const Form& form : test::testForms())
        for (const Storage storage : test::kStorages) {
            const Material material = test::testMaterial(form, storage);
            writeMaterial(material, path);
            for (int i = 0; i < 4; ++i)
                expectSameAsPage(path, material, someDirection(random), someDirection(random));
        }
}

TEST(FormatPage, AReaderWrittenFromItReadsOldFiles)
{
    std::mt19937 random(5);
    for (const char* name : {"pqp-log8", "sum-linear8", "single-log8"}) {
        const std::string path = std::string("tests/io/data/") + name + ".fbrdf";
        expectSameAsPage(path, readMaterial(path), someDirection(random), someDirection(random));
    }
}

}  // namespace
