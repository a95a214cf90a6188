// FilesTest.cpp - outputs appear whole or not at all.
#include "Files.h"

#include "io/TestMaterials.h"
#include "support/ExpectError.h"
#include "support/FileBytes.h"
#include "support/FileSizeLimit.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace fbrdf;
using fbrdf::test::expectError;
using fbrdf::test::FileSizeLimit;
using fbrdf::test::TemporaryDir;

namespace {

Material small()
{
    return test::testMaterial(formPqp(8, 1.0), Storage::float32);
}

TEST(Files, FullDiskLeavesNothingAndKeepsTheOldFile)
{
    for (const char* name : {"m.fbrdf", "m.json", "m.txt"}) {
        const TemporaryDir folder;
        const std::string path = folder.file(name);
        writeMaterial(small(), path);
        const std::string before = test::fileBytes(path);
        const std::vector<std::string> names = folder.names();
        for (const rlim_t limit : std::initializer_list<rlim_t>{0, 1, 50, 100, 150}) {
            const FileSizeLimit full(limit);
            expectError(ErrorKind::output, folder.file(""), [&] { writeMaterial(small(), path); });
        }
        EXPECT_EQ(folder.names(), names);
        EXPECT_EQ(test::fileBytes(path), before);
    }
}

// The last bytes of an EXR file are written on closing, which OpenEXR does not check.
TEST(Files, EveryMissingByteOfAnExrFileIsNoticed)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    writeMaterial(small(), path);
    const size_t size = test::fileBytes(path).size();
    std::filesystem::remove(path);
    for (size_t missing = 1; missing < size; missing += 1 + missing / 2) {
        const FileSizeLimit full(size - missing);
        expectError(ErrorKind::output, path, [&] { writeMaterial(small(), path); });
        EXPECT_TRUE(folder.names().empty()) << missing;
    }
}

TEST(Files, UnwritableTargetsSayWhy)
{
    const TemporaryDir folder;
    std::filesystem::create_directory(folder.file("folder.fbrdf"));
    expectError(ErrorKind::output, "No such file or directory",
                [&] { writeMaterial(small(), folder.file("absent/m.fbrdf")); });
    expectError(ErrorKind::output, "found a folder",
                [&] { writeMaterial(small(), folder.file("folder.fbrdf")); });
    EXPECT_EQ(folder.names(), std::vector<std::string>{"folder.fbrdf"});
}

TEST(Files, ALinkIsFollowedAndStays)
{
    const TemporaryDir folder;
    test::putFile(folder.file("real.fbrdf"), "old");
    std::filesystem::create_symlink("real.fbrdf", folder.file("link.fbrdf"));
    writeMaterial(small(), folder.file("link.fbrdf"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.fbrdf")));
    EXPECT_EQ(test::firstDifference(readMaterial(folder.file("real.fbrdf")), small()), "");
}

TEST(Files, ReadingRefusesWhatIsNoFile)
{
    const TemporaryDir folder;
    expectError(ErrorKind::input, "found no such file", [&] { readFile(folder.file("absent")); });
    expectError(ErrorKind::input, "found a folder or a device", [&] { readFile("/dev/zero"); });
    expectError(ErrorKind::input, "found a folder or a device", [&] { readFile(folder.file("")); });
    // A sparse file of a terabyte takes no space; reading it would take all memory.
    test::putFile(folder.file("huge"), "");
    std::filesystem::resize_file(folder.file("huge"), uintmax_t(1) << 40);
    expectError(ErrorKind::input, "expected at most", [&] { readFile(folder.file("huge")); });
    EXPECT_EQ(readBeginning(folder.file("huge"), 5).size(), 5u);
    EXPECT_EQ(readBeginning(folder.file("absent"), 5), "");
}

}  // namespace
