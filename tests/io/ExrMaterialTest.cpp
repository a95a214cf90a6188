// ExrMaterialTest.cpp - the .fbrdf file as a format: what goes in comes out, the same bytes every
// time. Hostile input is in HostileExrTest.cpp, other tools in OtherToolsTest.cpp.
#include "io/TestMaterials.h"
#include "support/ExpectError.h"
#include "support/FileBytes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

using namespace fbrdf;
using fbrdf::test::expectError;
using fbrdf::test::TemporaryDir;

namespace {

TEST(ExrMaterial, RoundTripsEveryFormAndStorageBitForBit)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    for (const Form& form : test::testForms())
        for (const Storage storage : test::kStorages) {
            const Material material = test::testMaterial(form, storage);
            writeMaterial(material, path);
            EXPECT_TRUE(isMaterialFile(path));
            EXPECT_EQ(test::firstDifference(readMaterial(path), material), "")
                << form.name << " " << storageName(storage);
        }
}

TEST(ExrMaterial, RoundTripsLobesBitForBit)
{
    const TemporaryDir folder;
    Material material = test::testMaterial(formPqp(8, 0.5), Storage::log8);
    for (const LobeAxes axes : {LobeAxes::tilted, LobeAxes::bent})
        for (const char* name : {"m.fbrdf", "m.json"}) {
            material.lobes = test::testLobes(axes);
            writeMaterial(material, folder.file(name));
            EXPECT_EQ(test::firstDifference(readMaterial(folder.file(name)), material), "") << name;
            material.lobes = {};
            EXPECT_EQ(test::firstDifference(readMaterial(folder.file(name)), material), "lobes");
        }
}

TEST(ExrMaterial, ComparisonSeesASingleBit)  // the tester itself
{
    const Material a = test::testMaterial(formPqp(9, 0.5), Storage::float32);
    Material b = a;
    b.tables[1].texels[7] = std::nextafter(b.tables[1].texels[7], 100.0f);
    EXPECT_EQ(test::firstDifference(a, b), "texels of table 1");
    b = a;
    b.form.terms[0].factors[0].argument = Direction::h;
    EXPECT_EQ(test::firstDifference(a, b), "form");
}

TEST(ExrMaterial, RoundTripsExtremeNumbers)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    Material material = test::testMaterial(formPqp(8, 0.5), Storage::float32);
    using Limits = std::numeric_limits<float>;
    const float extremes[] = {Limits::max(), Limits::lowest(), Limits::denorm_min(), -0.0f,
                              65504.0f};
    std::copy(std::begin(extremes), std::end(extremes), material.tables[0].texels.begin());
    material.scales[0] = {Limits::max(), Limits::denorm_min(), 0.0f};
    material.errors["infinite"] = std::numeric_limits<double>::infinity();
    writeMaterial(material, path);
    EXPECT_EQ(test::firstDifference(readMaterial(path), material), "");

    material = test::testMaterial(formPqp(8, 0.5), Storage::half);
    const float halves[] = {65504.0f, -65504.0f, std::ldexp(1.0f, -24), -0.0f};
    std::copy(std::begin(halves), std::end(halves), material.tables[0].texels.begin());
    writeMaterial(material, path);
    EXPECT_EQ(test::firstDifference(readMaterial(path), material), "");
}

// A table of nearly equal texels once left log8 steps finer than those of float.
TEST(ExrMaterial, RoundTripsLog8OfNearlyConstantTables)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    Material material = test::testMaterial(formHdio({7, 4, 6}), Storage::float32);
    for (const float spread : {0.0f, 1e-6f, 1e-4f, 1e-2f}) {
        for (Table& table : material.tables) {
            table.storage = Storage::float32;
            for (size_t i = 0; i < table.texels.size(); ++i)
                table.texels[i] = -2.65f + spread * std::sin(static_cast<float>(i));
            table = quantized(table, Storage::log8);
        }
        writeMaterial(material, path);
        EXPECT_EQ(test::firstDifference(readMaterial(path), material), "") << spread;
    }
}

TEST(ExrMaterial, RoundTripsThroughBytes)
{
    const TemporaryDir folder;
    for (const Form& form : test::testForms()) {
        const Material material = test::testMaterial(form, Storage::log8);
        const std::string bytes = materialFileBytes(material);
        EXPECT_EQ(test::firstDifference(materialFromFileBytes(bytes, "bytes"), material), "")
            << form.name;
        writeMaterial(material, folder.file("m.fbrdf"));
        EXPECT_EQ(bytes, test::fileBytes(folder.file("m.fbrdf")));
    }
}

TEST(ExrMaterial, NoPrefixOfItsBytesReads)
{
    const std::string bytes =
        materialFileBytes(test::testMaterial(test::testForms()[0], Storage::log8));
    for (size_t size = 0; size < bytes.size(); size += 1 + size / 50)
        expectError(ErrorKind::input, "in a scene",
                    [&] { materialFromFileBytes(bytes.substr(0, size), "in a scene"); });
}

TEST(ExrMaterial, SameMaterialGivesTheSameBytes)
{
    const TemporaryDir folder;
    const Material material = test::testMaterial(formPqpr(8, 0.5, 5), Storage::log8);
    writeMaterial(material, folder.file("a.fbrdf"));
    writeMaterial(material, folder.file("b.fbrdf"));
    const std::string bytes = test::fileBytes(folder.file("a.fbrdf"));
    EXPECT_EQ(bytes, test::fileBytes(folder.file("b.fbrdf")));
    // Two runs within a second would agree anyway: no time may be in there.
    EXPECT_EQ(bytes.find("capDate"), std::string::npos);
    EXPECT_EQ(bytes.find(folder.file("")), std::string::npos) << "the file names its folder";
}

// tests/io/data: what fbrdf wrote through OpenImageIO 2.4, before it used OpenEXR's core library.
// A file each of testForms() in turn, of the storage in its name and filled by testMaterial(), and
// one of a single table, which is a file without parts.
TEST(ExrMaterial, ReadsWhatTheFirstVersionWrote)
{
    const char* names[] = {"pqp", "pqpr", "hdio", "sum", "volume", "unnamed", "directions"};
    const std::vector<Form> forms = test::testForms();
    const std::string folder = "tests/io/data/";
    for (size_t f = 0; f < forms.size(); ++f) {
        const Storage storage = test::kStorages[f % std::size(test::kStorages)];
        const std::string path = folder + names[f] + "-" + storageName(storage) + ".fbrdf";
        const Material material = readMaterial(path);
        EXPECT_EQ(test::firstDifference(material, test::testMaterial(forms[f], storage)), "")
            << path;
        EXPECT_EQ(material.tables[1].unsupported.empty(), f != 2) << path;
    }
    const Form single{"s", {{"s", DiscDomain::fitting(6, 0.5)}}, {{{{0, Direction::h}}}}};
    EXPECT_EQ(test::firstDifference(readMaterial(folder + "single-log8.fbrdf"),
                                    test::testMaterial(single, Storage::log8)),
              "");
}

TEST(ExrMaterial, IsRecognisedByContentNotByName)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf"), renamed = folder.file("picture.txt");
    const Material material = test::testMaterial(formPqp(8, 0.5), Storage::log8);
    writeMaterial(material, path);
    std::filesystem::rename(path, renamed);
    EXPECT_TRUE(isMaterialFile(renamed));
    EXPECT_EQ(test::firstDifference(readMaterial(renamed), material), "");
    test::putFile(folder.file("empty.fbrdf"), "");
    test::putFile(folder.file("noise.fbrdf"), "\x76\x2f\x31\x01 not a material");
    EXPECT_FALSE(isMaterialFile(folder.file("empty.fbrdf")));
    EXPECT_FALSE(isMaterialFile(folder.file("noise.fbrdf")));
    EXPECT_FALSE(isMaterialFile(folder.file("absent.fbrdf")));
    EXPECT_FALSE(readIfMaterial(folder.file("noise.fbrdf")));
    EXPECT_FALSE(readIfMaterial(folder.file("absent.fbrdf")));
    EXPECT_FALSE(readIfMaterial(folder.file("")));
    EXPECT_EQ(test::firstDifference(readIfMaterial(renamed).value(), material), "");
    EXPECT_FALSE(isMaterialFile(folder.file("")));
    for (const char* name : {"empty.fbrdf", "noise.fbrdf", "absent.fbrdf", ""})
        expectError(ErrorKind::input, folder.file(name), [&] { readMaterial(folder.file(name)); });
}

TEST(ExrMaterial, RefusesWhatItsStorageCannotHold)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    for (const Storage storage : {Storage::log8, Storage::half, Storage::linear8}) {
        Material material = test::testMaterial(formPqp(8, 0.5), storage);
        material.tables[1].texels[3] += 1e-4f;
        expectError(ErrorKind::usage, "quantize the table first",
                    [&] { writeMaterial(material, path); });
    }
    Material material = test::testMaterial(formPqp(8, 0.5), Storage::half);
    material.notes[std::string(201, 'k')] = "";
    expectError(ErrorKind::usage, "at most 200 bytes", [&] { writeMaterial(material, path); });
    material.notes = {{"cut", std::string("a\0b", 3)}};
    expectError(ErrorKind::usage, "fbrdf:note:cut: found a text with a zero byte",
                [&] { writeMaterial(material, path); });
    material = test::testMaterial(formPqp(8, 0.5), Storage::float32);
    material.tables[1].texels[3] = NAN;
    expectError(ErrorKind::input, "not finite", [&] { writeMaterial(material, path); });
    expectError(ErrorKind::usage, "expected .fbrdf, .txt or .json", [&] {
        writeMaterial(test::testMaterial(formPqp(8, 0.5), Storage::half), folder.file("m.exr"));
    });
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
