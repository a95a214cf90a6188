// FiguresTest.cpp - `fbrdf-viewer figures` as its users run it.
#include "ViewerFixture.h"

#include <fbrdf/base/OutputFile.h>

#include <filesystem>

namespace fbrdf::scene {
namespace {

TEST_F(Viewer, WritesTheFiguresOfThePaperWithTheirErrors)
{
    NEEDS(Backend::egl);
    const ProgramResult result =
        runViewer("figures --size 64x64 --form pqpr -o '" + file("figures") + "'");
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    for (const char* name : {"figure-1a", "figure-1b", "figure-1-reference", "figure-1a-error",
                             "figure-1b-error", "figure-2", "figure-2-reference", "figure-2-error"})
        EXPECT_TRUE(std::filesystem::exists(file("figures/" + std::string(name) + ".png"))) << name;
    const nlohmann::json numbers = readJson(file("figures/figures.json"));
    // The knot is fine: what lies between its vertices is all that figure 1a lacks.
    EXPECT_GT(numbers["figure-1a"]["psnr_linear"], 38.0);
    EXPECT_GT(numbers["figure-1b"]["psnr_linear"], 30.0);
    EXPECT_LT(numbers["figure-1b"]["psnr_linear"], numbers["figure-1a"]["psnr_linear"]);
    EXPECT_GT(numbers["figure-2"]["psnr_linear"], 33.0);
    EXPECT_LT(numbers["figure-2"]["flip"], 0.1);
}

TEST_F(Viewer, FiguresThatCannotBeWrittenLeaveNothing)
{
    expectError(runViewer("figures"), 2, "-o: found none");
    expectError(runViewer("figures -o '" + file("a.png") + "'"), 2, "a folder without a dot");
    expectError(runViewer("figures --size 32x16 -o '" + file("f") + "'"), 2, "--size: found 32x16");
    expectError(runViewer("figures --material lambert -o '" + file("f") + "'"), 2, "figures");
    expectError(runViewer("figures -o '" + file("no/such/folder") + "'"), 5, "no/such/folder");
    EXPECT_FALSE(std::filesystem::exists(file("f")));
}

}  // namespace
}  // namespace fbrdf::scene
