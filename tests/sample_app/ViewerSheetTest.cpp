// ViewerSheetTest.cpp - the subcommands that make several pictures: sheet and turntable.
#include "ViewerFixture.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/scene/TextFile.h>
#include <support/FileBytes.h>

#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace fbrdf::scene {
namespace {

class ViewerSheet : public Viewer {
protected:
    ViewerSheet()
    {
        writeMaterial(madeMaterial(formHdio({8, 4, 4})), file("other.fbrdf"));
        for (const auto& [name, direction] :
             {std::pair("front", "[0, 0, 1]"), std::pair("side", "[1, 1, 0.5]")})
            writeFile(file(std::string(name) + ".json"),
                      std::string("{\"lights\": [{\"type\": \"directional\", \"direction\": ") +
                          direction + ", \"intensity\": [1, 1, 1]}]}");
    }
    std::string quoted(const std::string& name) const { return "'" + file(name) + "' "; }
    /// Number of images in a file.
    static int imagesIn(const std::string& path)
    {
        const auto input = OIIO::ImageInput::open(path);
        if (!input) throw std::runtime_error(OIIO::geterror());
        int count = 0;
        while (input->seek_subimage(count, 0)) ++count;
        return count;
    }
};

// As Sheet.cpp draws them: pictures 8 pixels apart, strips of 13 + 6 pixels for the labels.
constexpr int kSheetGap = 8, kStrip = 19;

TEST_F(ViewerSheet, ShowsEachMaterialUnderEachLightAsItsOwnPictureDoes)
{
    NEEDS(Backend::egl);
    const std::string options = "--plain --size 96x30 --mesh knot --samples 2 ";
    const ProgramResult result =
        runViewer("sheet " + quoted("made.fbrdf") + quoted("other.fbrdf") + "--under " +
                  quoted("front.json") + "--under " + quoted("side.json") + options + "-o " +
                  quoted("sheet.exr"));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    const Image sheet = readExr(file("sheet.exr"));
    EXPECT_EQ(sheet.width, kSheetGap + 2 * (96 + kSheetGap));
    EXPECT_EQ(sheet.height, kSheetGap + 2 * (30 + kStrip + kSheetGap));
    const char* const materials[] = {"made.fbrdf", "other.fbrdf"};
    const char* const lights[] = {"front.json", "side.json"};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            const Image picture =
                draw("--headless " + options + "--material " + quoted(materials[row]) +
                     "--lights " + quoted(lights[column]));
            const int left = kSheetGap + column * (96 + kSheetGap),
                      top = kSheetGap + row * (30 + kStrip + kSheetGap);
            float largest = 0.0f;
            for (int y = 0; y < 30; ++y)
                for (int x = 0; x < 96; ++x)
                    for (int c = 0; c < 3; ++c)
                        largest = std::max(largest, std::abs(sheet.pixel(left + x, top + y)[c] -
                                                             picture.pixel(x, y)[c]));
            EXPECT_EQ(largest, 0.0f) << row << " " << column;
            int ink = 0;
            for (int y = 30; y < 30 + kStrip; ++y)
                for (int x = 0; x < 96; ++x) ink += sheet.pixel(left + x, top + y)[0] > 0.2f;
            EXPECT_GT(ink, 20) << "a label";
        }
}

TEST_F(ViewerSheet, UnderOneLightFillsASquare)
{
    const ProgramResult result =
        runViewer("sheet " + quoted("made.fbrdf") + quoted("other.fbrdf") + quoted("made.fbrdf") +
                  "--under " + quoted("front.json") +
                  "--plain --technique vertex --size 20x10 -o " + quoted("sheet.exr"));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Image sheet = readExr(file("sheet.exr"));
    EXPECT_EQ(sheet.width, kSheetGap + 2 * (20 + kSheetGap));
    EXPECT_EQ(sheet.height, kSheetGap + 2 * (10 + kStrip + kSheetGap));
}

TEST_F(ViewerSheet, TurntablesAreFoldersAndAnimations)
{
    NEEDS(Backend::egl);
    const std::string options =
        "--plain --mesh plane --size 32x24 --lights " + quoted("front.json");
    const std::string turn = "turntable " + quoted("made.fbrdf") + options + "--frames 4 -o ";
    ASSERT_EQ(runViewer(turn + quoted("turn")).exitCode, 0);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file("turn")), {}), 4);
    ASSERT_EQ(runViewer("--headless " + options + "--material " + quoted("made.fbrdf") + "--out " +
                        quoted("still.png"))
                  .exitCode,
              0);
    const auto frame = [this](const std::string& number) {
        return test::fileBytes(file("turn/frame-" + number + ".png"));
    };
    EXPECT_EQ(frame("000"), test::fileBytes(file("still.png")));
    EXPECT_NE(frame("001"), frame("000")) << "the square is seen from its side";
    for (const char* name : {"turn.gif", "turn.webp"}) {
        ASSERT_EQ(runViewer(turn + quoted(name)).exitCode, 0);
        EXPECT_EQ(imagesIn(file(name)), 4) << name;
    }
}

TEST_F(ViewerSheet, ATurnIsThatOfTheObjectAndItsShadow)
{
    // Half a turn of the square is its back, and its shadow is the same.
    NEEDS(Backend::egl);
    writeFile(file("above.json"),
              "{\"lights\": [{\"type\": \"directional\", \"direction\": [0, 1, -1], "
              "\"intensity\": [3, 3, 3]}]}");
    ASSERT_EQ(runViewer("turntable " + quoted("made.fbrdf") +
                        "--plain --ground --shadows --mesh plane --size 48x40 --camera "
                        "0,4,6,0,0,0,40 --frames 4 --lights " +
                        quoted("above.json") + "-o " + quoted("turn"))
                  .exitCode,
              0);
    const auto row = [this](const std::string& number) {
        const auto png = OIIO::ImageInput::open(file("turn/frame-" + number + ".png"));
        std::vector<uint8_t> codes(48 * 40 * 3);
        png->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, codes.data());
        int dark = 0;  // on the ground, in front of the square
        for (size_t i = 3 * 48 * 28; i < codes.size(); i += 3) dark += codes[i] < 40;
        return dark;
    };
    EXPECT_GT(row("000"), 40);
    EXPECT_NEAR(row("000"), row("002"), 6);
    EXPECT_LT(row("001"), row("000") / 2) << "of its edge";
}

TEST_F(ViewerSheet, RefusesWhatMakesNoSense)
{
    const std::string made = quoted("made.fbrdf");
    writeFile(file("plain"), "a file");
    const std::tuple<std::string, int, std::string> cases[] = {
        {"sheet -o " + quoted("s.png"), 2, "MATERIAL"},
        {"sheet " + made, 2, "-o: found none"},
        {"sheet " + made + "-o " + quoted("s.xyz"), 2, "s.xyz"},
        {"sheet " + made + "--frames 3 -o " + quoted("s.png"), 2, "--frames"},
        {"sheet " + made + "--stats " + quoted("s.json") + "-o " + quoted("s.png"), 2, "--stats"},
        {"sheet " + made + "--size 16384x16 -o " + quoted("s.png"), 2, "pixels, expected up to"},
        {"sheet " + made + "--under none.json --plain -o " + quoted("s.png"), 3, "none.json"},
        {"sheet " + made + "--under nowhere --plain -o " + quoted("s.png"), 3, "nowhere"},
        {"sheet " + quoted("no.fbrdf") + "-o " + quoted("s.png"), 3, "no.fbrdf"},
        {"sheet " + made + "-o /nonexistent/s.png", 5, "/nonexistent/"},
        {"turntable " + made, 2, "-o: found none"},
        {"turntable " + made + made + "-o " + quoted("t.gif"), 2, "found 2 materials"},
        {"turntable " + made + "-o " + quoted("t.png"), 2, "FILE.webp or a folder"},
        {"turntable " + made + "--frames 100000 -o " + quoted("t.gif"), 2, "--frames"},
        {"turntable " + made + "--plain -o /nonexistent/t.gif", 5, "/nonexistent/"},
        {"turntable " + made + "--plain -o /nonexistent/t", 5, "/nonexistent/"},
        {"turntable " + made + "--plain -o " + quoted("plain"), 5, "a folder to fill"},
    };
    const auto before = dir_.names();
    for (const auto& [arguments, code, words] : cases) {
        SCOPED_TRACE(arguments);
        expectError(runViewer(arguments), code, words);
        EXPECT_EQ(dir_.names(), before);
    }
}

TEST_F(ViewerSheet, ATurntableThatFailsLeavesNoFolder)
{
    const auto before = dir_.names();
    expectError(runViewer("turntable " + quoted("made.fbrdf") + "--plain -o " + quoted("turn"),
                          "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"),
                6, "EGL");
    EXPECT_EQ(dir_.names(), before);
}

}  // namespace
}  // namespace fbrdf::scene
