// CompareProgramTest.cpp - `fbrdf-viewer --headless --compare` as its users run it.
#include "ViewerFixture.h"

#include <fbrdf/base/OutputFile.h>

#include <filesystem>

namespace fbrdf::scene {
namespace {

class Compare : public Viewer {
protected:
    void SetUp() override
    {
        if (!hasBackend(Backend::egl)) GTEST_SKIP() << "no context on egl";
    }
    std::string model() const
    {
        return "--headless --size 40x32 --material ggx:alpha=0.3,f0=0.6,kd=0.2/0.1/0.05 --form "
               "pqpr ";
    }
    static float largest(const Image& image)
    {
        float most = 0.0f;
        for (size_t i = 0; i < image.rgba.size(); ++i)
            if (i % 4 != 3) most = std::max(most, image.rgba[i]);
        return most;
    }
};

TEST_F(Compare, AMaterialWithItselfDiffersNowhere)
{
    for (const char* mode : {"difference", "heat"}) {
        const Image image = draw(drawMade() + "--compare drawn drawn --compare-mode " + mode);
        EXPECT_EQ(largest(image), 0.0f) << mode;
        EXPECT_TRUE(stats_["compare"]["psnr_srgb"].is_null()) << "infinite";
        EXPECT_EQ(stats_["compare"]["flip"], 0.0);
        EXPECT_EQ(stats_["compare"]["delta_e_itp"], 0.0);
        EXPECT_EQ(stats_["compare"]["largest"], 0.0);
        EXPECT_EQ(stats_["compare"]["mode"], mode);
        EXPECT_EQ(stats_["compare"]["pixels"], stats_["covered_pixels"]);
    }
}

TEST_F(Compare, ASplitHasThePixelsOfBothPictures)
{
    // In codes, as the screen and a PNG have them.
    const auto codes = [&](const std::string& arguments) {
        return srgbCodes(draw(arguments), 1.0f, Transfer::srgb);
    };
    const auto a = codes(model() + "--technique reference"),
               b = codes(model() + "--technique vertex"),
               both = codes(model() + "--compare reference vertex --compare-at 0.25");
    ASSERT_EQ(both.size(), a.size());
    for (size_t i = 0; i < both.size(); ++i) ASSERT_EQ(both[i], (i / 3 % 40 < 10 ? a : b)[i]) << i;
    EXPECT_EQ(stats_["compare"]["a"]["technique"], "reference");
    EXPECT_EQ(stats_["compare"]["b"]["technique"], "vertex");
    EXPECT_GT(stats_["compare"]["psnr_srgb"], 30.0);
}

TEST_F(Compare, EverySideIsFittedToTheSameSource)
{
    const char* const sides[] = {"drawn",    "hdio",   "svd3",
                                 "pqp-2001", "vertex", "ggx:alpha=0.3,f0=0.6,kd=0.2/0.1/0.05"};
    double last = 0.0;
    for (const char* side : sides) {
        const ProgramResult result = runViewer(model() + "--compare '" + side +
                                               "' reference --stats '" + file("s.json") + "'");
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const auto compare = readJson(file("s.json"))["compare"];
        EXPECT_EQ(compare["a"]["name"], side);
        const bool isSame = compare["psnr_srgb"].is_null();
        EXPECT_EQ(isSame, side == std::end(sides)[-1]) << side;
        if (!isSame) {
            EXPECT_GT(compare["psnr_srgb"], 20.0) << side;
        }
        if (std::string(side) == "pqp-2001") {
            EXPECT_EQ(compare["a"]["bytes"], 6144);
            EXPECT_LT(compare["psnr_srgb"], last) << "8 linear bits are the worst of all";
        }
        if (!isSame) last = compare["psnr_srgb"];
    }
}

TEST_F(Compare, PeersAreDrawnPerPixel)
{
    const ProgramResult result =
        runViewer(model() + "--compare ggx reference --stats '" + file("s.json") + "'");
    if (result.err.find("without ggx") != std::string::npos) GTEST_SKIP() << "built without Ceres";
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto compare = readJson(file("s.json"))["compare"];
    EXPECT_EQ(compare["a"]["technique"], "reference");
    EXPECT_EQ(compare["a"]["bytes"], 0);
    EXPECT_NE(compare["a"]["note"].get<std::string>().find("alpha 0.3"), std::string::npos);
    EXPECT_GT(compare["psnr_srgb"], 50.0) << "the source is a GGX lobe";
}

TEST_F(Compare, SheetsHaveAColumnForEachSide)
{
    const std::string arguments = "compare '" + file("made.fbrdf") +
                                  "' --plain --size 40x32 --side reference --side drawn --side "
                                  "vertex --out '" +
                                  file("sheet.exr") + "'";
    const ProgramResult result = runViewer(arguments + " --stats '" + file("s.json") + "'");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Image sheet = readExr(file("sheet.exr"));
    EXPECT_EQ(sheet.width, 3 * (40 + 8) + 8);
    const auto numbers = readJson(file("s.json"));
    ASSERT_EQ(numbers.size(), 3u);
    EXPECT_TRUE(numbers[0]["psnr_srgb"].is_null()) << "the first with itself";
    EXPECT_EQ(numbers[2]["a"]["name"], "vertex");
    EXPECT_EQ(numbers[2]["b"]["name"], "reference");
    EXPECT_GT(numbers[1]["psnr_srgb"], 30.0);
    // A material file has no sides that are fitted; the usual ones are those that it has.
    EXPECT_EQ(runViewer("compare '" + file("made.fbrdf") + "' --plain --size 16x16 --out '" +
                        file("sheet.png") + "'")
                  .exitCode,
              0);
    expectError(runViewer(arguments + " --side hdio"), 2, "hdio: found a material file");
    expectError(runViewer(arguments + " --side nonsense"), 2, "--compare: found 'nonsense'");
    expectError(runViewer("compare lambert --side drawn -o '" + file("a.png") + "'"), 2,
                "--side: found one");
    expectError(runViewer("compare lambert lambert -o '" + file("a.png") + "'"), 2,
                "found 2 materials");
    expectError(runViewer("compare lambert"), 2, "-o: found none");
}

TEST_F(Compare, FunctionsUnderAnEnvironmentAreDrawnAtRandom)
{
    const Image image = draw(model() +
                             "--environment overcast --light-count 0 --compare reference drawn "
                             "--samples 32 --compare-mode split");
    EXPECT_EQ(stats_["compare"]["a"]["technique"], "reference");
    EXPECT_EQ(stats_["compare"]["a"]["samples"], 32);
    EXPECT_GT(stats_["path"]["noise"], 0.0);
    EXPECT_LT(stats_["path"]["noise"], 0.1);
    EXPECT_GT(stats_["compare"]["psnr_srgb"], 30.0);
    EXPECT_GT(largest(image), 0.1f);
}

TEST_F(Compare, FilmsOfFlipsAndWipes)
{
    if (runViewer("turntable lambert --frames 1 --size 8x8 --plain -o '" + file("t.gif") + "'")
            .exitCode != 0)
        GTEST_SKIP() << "no module for GIF";
    for (const char* mode : {"flip", "wipe --frames 5"}) {
        const ProgramResult result = runViewer(drawMade() + "--compare drawn reference --out '" +
                                               file("f.gif") + "' --compare-mode " + mode);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_TRUE(std::filesystem::exists(file("f.gif")));
        std::filesystem::remove(file("f.gif"));
    }
    const Image flip = draw(drawMade() + "--compare drawn reference --compare-mode flip");
    EXPECT_EQ(flip.width, 96) << "side by side";
}

TEST_F(ViewerWindow, ComparesAsWithoutAWindow)
{
    NEEDS(Backend::egl);
    for (const char* mode : {"split", "difference", "heat", "flip"}) {
        const std::string scene = "--plain --size 64x48 --light-count 2 --material '" +
                                  file("made.fbrdf") + "' --compare drawn vertex --compare-mode " +
                                  mode;
        const ProgramResult result = runViewer(
            scene + " --frames 2 --out '" + file("w.exr") + "' --stats '" + file("w.json") + "'",
            xvfb_);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const nlohmann::json found = readJson(file("w.json"))["compare"];
        const Image expected = draw("--headless " + scene), window = readExr(file("w.exr"));
        EXPECT_NEAR(found["psnr_srgb"].get<double>(), stats_["compare"]["psnr_srgb"].get<double>(),
                    0.05);
        EXPECT_EQ(found["pixels"], stats_["compare"]["pixels"]);
        ASSERT_EQ(window.rgba.size(), expected.rgba.size());
        // A code more or less, which heat and the gain make 8 of.
        double off = 0.0;
        for (size_t i = 0; i < window.rgba.size(); ++i)
            off = std::max(off, std::abs(double(window.rgba[i]) - double(expected.rgba[i])));
        EXPECT_LE(off, 0.1) << mode;
    }
}

TEST_F(ViewerActions, KeysMoveTheLineAndExchangeTheSides)
{
    const std::string scene = "--plain --light-count 2 --material '" + file("made.fbrdf") + "' ";
    std::string keys = "xdotool key v\nsleep 0.7\nxdotool key";
    for (int i = 0; i < 8; ++i) keys += " bracketright";  // from the middle to three quarters
    // The second side after the reference, then what is under the cursor, and the sides exchanged.
    const ProgramResult result =
        act(scene + "--out '" + file("w.exr") + "' --stats '" + file("w.json") + "'",
            keys +
                "\nsleep 0.7\nxdotool key 2\nsleep 0.7\nxdotool key i Right\nsleep 0.7\n"
                "xdotool key 3\nsleep 0.7\n");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto compare = readJson(file("w.json"))["compare"];
    EXPECT_EQ(compare["a"]["name"], "vertex");
    EXPECT_EQ(compare["b"]["name"], "drawn");
    const std::string headless = "--headless --size 96x64 " + scene + "--compare vertex drawn ";
    const Image window = readExr(file("w.exr")), expected = draw(headless + "--compare-at 0.75");
    const auto apart = [&window](const Image& other) {
        double sum = 0.0;
        for (size_t i = 0; i < window.rgba.size(); ++i)
            sum += std::abs(double(window.rgba[i]) - double(other.rgba[i]));
        return sum / double(window.rgba.size());
    };
    ASSERT_EQ(window.rgba.size(), expected.rgba.size());
    EXPECT_LE(apart(expected), 1e-4);
    // The test can fail: a line in the middle gives another picture.
    EXPECT_GT(apart(draw(headless + "--compare-at 0.5")), 2.0 * apart(expected));
}

TEST_F(ViewerWindow, SaysWhichSideCannotBe)
{
    expectError(runViewer("--plain --size 64x48 --frames 1 --material '" + file("made.fbrdf") +
                              "' --compare drawn hdio",
                          xvfb_),
                2, "--compare: hdio: found a material file");
}

TEST_F(Compare, WhatCannotBeComparedIsOneLine)
{
    const std::pair<const char*, const char*> cases[] = {
        {"--compare drawn", "--compare"},
        {"--compare drawn nonsense", "--compare: found 'nonsense', expected drawn"},
        {"--compare drawn svd99", "--compare: found 'svd99'"},
        {"--compare drawn drawn --compare-mode fade", "--compare-mode: found 'fade'"},
        {"--compare drawn drawn --compare-at 2", "--compare-at"},
        {"--compare drawn drawn --compare-gain 0", "--compare-gain"},
        {"--compare-mode heat", "--compare-mode: found nothing to compare"},
        {"--compare drawn drawn --material lambert", "--compare: found 2 materials"},
        {"--compare hdio drawn", "--compare: hdio: found a material file"},
        {"--compare drawn nbrdf", "--compare: nbrdf: found a material file"},
    };
    for (const auto& [arguments, where] : cases) {
        SCOPED_TRACE(arguments);
        expectError(runViewer(drawMade() + arguments), 2, where);
    }
    expectError(runViewer(model() + "--compare drawn analytic"), 2,
                "analytic: found nothing for 'ggx:");
    expectError(runViewer(model() + "--compare drawn nbrdf", "FBRDF_DATA_DIR=/nonexistent"), 2,
                "nbrdf: found no network of");
    expectError(runViewer(model() + "--compare drawn sgd", "FBRDF_DATA_DIR=/nonexistent"), 2,
                "sgd: found nothing for");
    writeFile(file("bad.csv"), "not a table");
    expectError(runViewer(model() + "--compare drawn '" + file("bad.csv") + "'"), 3, "bad.csv");
}

}  // namespace
}  // namespace fbrdf::scene
