// ViewerProgramTest.cpp - fbrdf-viewer as its users run it: pictures, stats, exit codes and
// error lines. It needs EGL; without it the tests that draw are skipped.
#include "ViewerFixture.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/scene/TextFile.h>

#include <OpenImageIO/imageio.h>

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf::scene {
namespace {

TEST_F(Viewer, HelpNamesEveryOption)
{
    const ProgramResult result = runViewer("--help");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    for (const char* option :
         {"--headless", "--backend",    "--material",   "--mesh",    "--lights",   "--light-count",
          "--seed",     "--technique",  "--look-up",    "--precise", "--device",   "list-devices",
          "--camera",   "--size",       "--exposure",   "--out",     "--stats",    "--frames",
          "--samples",  "--bounces",    "--ground",     "--shadows", "--tone-map", "--full",
          "--plain",    "--background", "--environment"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST_F(Viewer, UsageErrorsExitWith2)
{
    const std::pair<const char*, const char*> cases[] = {
        {"--nonsense", "--nonsense"},
        {"stray", "stray"},
        {"--technique fast", "--technique: found 'fast'"},
        {"--look-up dual", "look-up: found 'dual'"},
        {"--headless --backend metal", "metal"},
        {"--backend egl", "--headless"},
        {"--headless --device gpu", "--device: found 'gpu'"},
        {"--headless --device -1", "--device"},
        {"--headless --device 999", "found device 999"},
        {"--device 0", "--headless"},
        {"--headless --backend osmesa --device 0", "--device"},
        {"--size 10", "--size: found '10'"},
        {"--size 0x10", "--size: found '0x10'"},
        {"--size 10x10x10", "--size"},
        {"--size 99999x2", "--size"},
        {"--camera 0,0,4", "--camera: found 3"},
        {"--exposure 0", "--exposure"},
        {"--exposure x", "--exposure"},
        {"--frames 0", "--frames"},
        {"--headless --technique path --samples 0", "--samples"},
        {"--headless --technique path --samples many", "--samples"},
        {"--headless --technique path --samples 9999999", "--samples"},
        {"--headless --technique path --bounces -1", "--bounces"},
        {"--headless --environment-lobes 2", "--environment-lobes: found no environment"},
        {"--headless --background environment", "--background: found environment without"},
        {"--headless --full --plain", "--plain"},
        {"--headless --samples 0", "--samples"},
        {"--headless --technique reference --bounces 2", "--bounces: found it with"},
        {"--light-count -1", "--light-count"},
        {"--light-count 2 --lights x.json", "--light"},
        {"--out picture.xyz", "--out: found 'picture.xyz'"},
        {"--headless --material no-such-model:alpha=1", "no-such-model"},
        {"--headless --material ggx:alpha=7", "found alpha=7"},
        {"--headless --material lambert --form nothing", "found 'nothing'"},
    };
    for (const auto& [arguments, where] : cases) {
        SCOPED_TRACE(arguments);
        expectError(runViewer(arguments), 2, where);
    }
}

TEST_F(Viewer, DrawsWithADeviceThatItLists)
{
    NEEDS(Backend::egl);
    const ProgramResult list = runViewer("list-devices");
    EXPECT_EQ(list.exitCode, 0) << list.err;
    EXPECT_EQ(runViewer("--device list").out, list.out);
    if (list.out.rfind("0  ", 0) != 0) GTEST_SKIP() << "EGL lists no devices";
    draw(drawMade() + "--device 0");
    EXPECT_EQ(list.out.substr(3, list.out.find('\n') - 3), stats_["gl_renderer"]);
}

TEST_F(Viewer, SaysWhatFiltersTheMaps)
{
    NEEDS(Backend::egl);
    const Image hardware = draw(drawMade());
    EXPECT_EQ(stats_["filter"], "hardware");
    const Image shader = draw(drawMade() + "--precise");
    EXPECT_EQ(stats_["filter"], "shader");
    EXPECT_LT(stats_["error_bound"]["relative"], 1e-4);
    EXPECT_LE(compare(shader, hardware).worst, 1e-2);  // a GPU's own filter may be as coarse
}

TEST_F(Viewer, InputErrorsExitWith3AndLeaveNoPicture)
{
    writeFile(file("empty.fbrdf"), "");
    writeFile(file("garbage.fbrdf"), std::string("\x76\x2f\x31\x01\xff\xfe garbage", 15));
    const std::string whole = readText(file("made.fbrdf"), "a material");
    writeFile(file("cut.fbrdf"), whole.substr(0, whole.size() / 2));
    writeFile(file("empty.obj"), "");
    writeFile(file("bad.obj"), "v 0 0 0\nf 1 2 3\n");
    writeFile(file("bad.json"), "{\"lights\": [{\"type\": \"point\"}]}");
    const std::pair<std::string, std::string> cases[] = {
        {"--material '" + file("empty.fbrdf") + "'", "empty.fbrdf"},
        {"--material '" + file("garbage.fbrdf") + "'", "garbage.fbrdf"},
        {"--material '" + file("cut.fbrdf") + "'", "cut.fbrdf"},
        {"--material '" + file("none.fbrdf") + "'", "none.fbrdf"},
        {drawMade() + "--mesh '" + file("none.obj") + "'", "none.obj: found no such file"},
        {drawMade() + "--mesh '" + file("empty.obj") + "'", "empty.obj: found no face"},
        {drawMade() + "--mesh '" + file("bad.obj") + "'", "bad.obj:2: found '2'"},
        {drawMade() + "--mesh cube", "cube: found no such file"},
        {drawMade() + "--lights '" + file("bad.json") + "'", "bad.json: lights[0]"},
        {drawMade() + "--lights '" + file("none.json") + "'", "none.json: found no such file"},
    };
    for (const auto& [arguments, where] : cases) {
        SCOPED_TRACE(arguments);
        expectError(
            runViewer("--headless " + arguments.substr(arguments.find("--headless") == 0 ? 10 : 0) +
                      " --out '" + file("p.png") + "'"),
            3, where);
    }
    const auto names = dir_.names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "p.png"), 0);
}

TEST_F(Viewer, SourcesThatCannotBeFittedAreRefusedAsByTheTool)
{
    const auto rows = [](const char* row, int count) {
        std::string text = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,value\n";
        for (int i = 0; i < count; ++i) text += row;
        return text;
    };
    struct Case {
        const char* name;
        std::string content;
        int code;
        const char* words;
    };
    const Case cases[] = {
        {"empty.csv", "", 3, "empty"},
        {"garbage.binary", std::string("\xff\0\x01\x80\xfe\x7f\r\n\xf0\x9f", 10), 3,
         "garbage.binary"},
        {"cut.csv", rows("0,0,1,0.6,0,0.8,1\n", 20) + "0,0", 3, "cut.csv:22"},
        {"nan.csv", rows("0,0,1,0.6,0,0.8,nan\n", 20), 3, "20 not finite"},
        {"zero.csv", rows("0,0,1,0.6,0,0.8,0\n", 20), 4, "20, of which 0 have a value above"},
        {"one.csv", rows("0,0,1,0.6,0,0.8,1\n", 1), 4, "found 1, of which 1"},
        {"below.csv", rows("0,0,-1,0.6,0,0.8,1\n", 20), 3, "20 below the horizon"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        writeFile(file(c.name), c.content);
        expectError(
            runViewer("--headless --material '" + file(c.name) + "' --out '" + file("p.png") + "'"),
            c.code, c.words);
        EXPECT_FALSE(std::filesystem::exists(file("p.png")));
    }
}

TEST_F(Viewer, OutputErrorsExitWith5)
{
    for (const char* option : {"--out '/nonexistent/p.exr'", "--out '/nonexistent/p.png'",
                               "--stats '/nonexistent/s.json'"}) {
        SCOPED_TRACE(option);
        expectError(runViewer(drawMade() + "--technique reference " + option), 5, "/nonexistent/");
    }
}

TEST_F(Viewer, WhatIsNoFileIsRefusedAndStays)
{
    ASSERT_EQ(::mkfifo(file("pipe.png").c_str(), 0666), 0);
    std::filesystem::create_symlink("/dev/null", file("link.png"));
    const std::string draw = drawMade() + "--technique reference ";
    expectError(runViewer(draw + "--stats '" + file("pipe.png") + "'"), 5, "found a pipe");
    expectError(runViewer(draw + "--out '" + file("pipe.png") + "'"), 5, "found a pipe");
    expectError(runViewer(draw + "--out '" + file("link.png") + "'"), 5, "found a device");
    expectError(runViewer(draw + "--stats /dev/null"), 5, "/dev/null: found a device");
    expectError(runViewer(draw + "--stats /dev/stdout"), 5, "/dev/stdout: found a stream");
    EXPECT_TRUE(std::filesystem::is_fifo(file("pipe.png")));
    EXPECT_TRUE(std::filesystem::is_symlink(file("link.png")));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Viewer, LinksAreFollowed)
{
    for (const char* name : {"p.png", "s.json"})
        std::filesystem::create_symlink(std::string("real.") + name, file(name));
    const ProgramResult run = runViewer(drawMade() + "--technique reference --out '" +
                                        file("p.png") + "' --stats '" + file("s.json") + "'");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (const char* name : {"p.png", "s.json"}) {
        EXPECT_TRUE(std::filesystem::is_symlink(file(name)));
        EXPECT_TRUE(std::filesystem::is_regular_file(file(std::string("real.") + name)));
    }
}

TEST_F(Viewer, NoUsableGlExitsWith6)
{
    expectError(runViewer(drawMade() + "--backend egl --out '" + file("p.png") + "'",
                          "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"),
                6, "EGL");
    expectError(runViewer("--material '" + file("made.fbrdf") + "' --frames 1",
                          "env -u DISPLAY -u WAYLAND_DISPLAY"),
                6, "--headless");
    EXPECT_EQ(dir_.names(), std::vector<std::string>{"made.fbrdf"});
}

TEST_F(Viewer, AnOlderGlExitsWith6)
{
    for (const Backend backend : {Backend::egl, Backend::osmesa}) {
        if (!hasBackend(backend)) continue;
        expectError(runViewer(drawMade() + "--backend " + backendName(backend) + " --out '" +
                                  file("p.png") + "'",
                              "MESA_GL_VERSION_OVERRIDE=2.0 MESA_GLSL_VERSION_OVERRIDE=110"),
                    6, "found no OpenGL 3.3");
        EXPECT_EQ(dir_.names(), std::vector<std::string>{"made.fbrdf"});
    }
}

TEST_F(Viewer, CpuTechniquesNeedNoGl)
{
    for (const std::string technique : {"reference", "vertex", "path"}) {
        const ProgramResult result = runViewer(
            drawMade() + "--technique " + technique + (technique == "path" ? " --bounces 0" : "") +
                " --out '" + file("p.exr") + "' --stats '" + file("s.json") + "'",
            "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent");
        EXPECT_EQ(result.exitCode, 0) << result.err;
        const auto stats = readJson(file("s.json"));
        EXPECT_EQ(stats["backend"], "cpu");
        EXPECT_EQ(stats["technique"], technique);
        EXPECT_TRUE(stats["gl_renderer"].is_null());
        EXPECT_GT(stats["covered_pixels"], 48 * 48 / 3);
    }
}

TEST_F(Viewer, PathsOfLightGiveTheReferenceWhereNothingIsInTheWay)
{
    const std::string scene = drawMade() + "--light-count 3 ";
    const Image reference = draw(scene + "--technique reference");
    EXPECT_TRUE(stats_["path"].is_null());
    // A sphere does not see itself, and lights without a shape bring no noise.
    const Image path = draw(scene + "--technique path --bounces 0");
    EXPECT_EQ(path.rgba, reference.rgba);
    EXPECT_EQ(stats_["path"]["samples"], 64);
    EXPECT_EQ(stats_["path"]["bounces"], 0);
    EXPECT_EQ(stats_["path"]["noise"], 0.0);
    const Image spread = draw(scene + "--technique path --bounces 0 --samples 5");
    EXPECT_EQ(stats_["path"]["samples"], 5);
    const auto isPartly = [](const Image& image) {
        for (size_t i = 3; i < image.rgba.size(); i += 4)
            if (image.rgba[i] > 0.0f && image.rgba[i] < 1.0f) return true;
        return false;
    };
    EXPECT_FALSE(isPartly(path));
    EXPECT_TRUE(isPartly(spread));
}

TEST_F(Viewer, PathsOfLightGoFromSurfaceToSurface)
{
    writeFile(file("corner.obj"),
              "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
              "v 1 -1 0\nv 1 1 0\nv 1 1 2\nv 1 -1 2\nf 5 8 7 6\n");
    writeFile(file("one.json"),
              "{\"lights\": [{\"type\": \"point\", \"position\": [-0.5, 0, 1], "
              "\"intensity\": [1, 1, 1]}]}");
    const std::string scene = "--headless --size 16x16 --material lambert:albedo=0.8 --mesh '" +
                              file("corner.obj") + "' --lights '" + file("one.json") +
                              "' --technique path ";
    const Image direct = draw(scene + "--bounces 0"), all = draw(scene + "--bounces 4");
    EXPECT_GT(stats_["path"]["noise"], 0.0);
    EXPECT_LT(stats_["path"]["noise"], 0.1);
    double more = 0.0;
    for (size_t i = 0; i < all.rgba.size(); i += 4) more += double(all.rgba[i] - direct.rgba[i]);
    EXPECT_GT(more, 0.0);
}

TEST_F(Viewer, TechniquesAgreeAndTheStatsNameThem)
{
    NEEDS(Backend::egl);
    const std::string scene = drawMade() + "--mesh knot --light-count 3 --seed 4 ";
    const Image reference = draw(scene + "--technique reference");
    EXPECT_EQ(stats_["evaluated"], "material");
    EXPECT_TRUE(stats_["technique_drawn"].is_null());
    const Image single = draw(scene + "--technique single --frames 3");
    EXPECT_EQ(stats_["passes"], 1);
    EXPECT_EQ(stats_["draw_calls"], 1);
    EXPECT_EQ(stats_["max_lookups"], 7);
    EXPECT_EQ(stats_["frames"], 3);
    const Image two = draw(scene + "--technique two-lookup");
    EXPECT_EQ(stats_["passes"], 4);
    EXPECT_EQ(stats_["max_lookups"], 2);
    EXPECT_EQ(stats_["backend"], "egl");
    EXPECT_EQ(stats_["technique_drawn"], "two-lookup");
    EXPECT_TRUE(stats_["why_replaced"].is_null());
    EXPECT_GE(stats_["error_bound"]["relative"], 1e-5);
    EXPECT_EQ(stats_["error_bound"]["absolute"], 0.0);
    EXPECT_EQ(stats_["accumulation"], "RGBA32F");
    EXPECT_EQ(stats_["lights"]["given"], 3);
    EXPECT_EQ(stats_["lights"]["used"], 3);
    EXPECT_EQ(stats_["lights"]["dropped"], 0);
    EXPECT_NE(stats_["gl_version"].get<std::string>(), "");
    EXPECT_GT(stats_["milliseconds"]["min"], 0.0);
    const Image batched = draw(scene + "--technique batched");
    EXPECT_LE(compare(single, reference).worst, kAgainstReference);
    EXPECT_LE(compare(two, single).worst, kBetweenTechniques);
    EXPECT_EQ(stats_["look_up"], "native");
    const Image cube = draw(scene + "--look-up cube");
    EXPECT_EQ(stats_["look_up"], "cube");
    const double bound = stats_["error_bound"]["relative"];
    EXPECT_GT(bound, 1e-3);
    EXPECT_GT(compare(cube, single).worst, kBetweenTechniques);
    EXPECT_LE(compare(cube, single).worst, bound);
    EXPECT_LE(compare(batched, single).worst, kBetweenTechniques);
}

TEST_F(Viewer, BackendsAgree)
{
    NEEDS(Backend::egl);
    NEEDS(Backend::osmesa);
    const Image egl = draw(drawMade() + "--backend egl");
    const Image osmesa = draw(drawMade() + "--backend osmesa");
    EXPECT_EQ(stats_["backend"], "osmesa");
    EXPECT_EQ(compare(osmesa, egl).coverageDiffers, 0);
    EXPECT_LE(compare(osmesa, egl).worst, kBetweenTechniques);
}

TEST_F(Viewer, LightsFileCameraAndSizeAreFollowed)
{
    // A light behind the plane alone: covered, and black.
    writeFile(file("l.json"), R"({"lights": [{"type": "directional", "direction": [0, 0, -1],
                                  "intensity": [1, 1, 1]}]})");
    const Image image = draw("--headless --technique reference --material '" + file("made.fbrdf") +
                             "' --mesh plane --camera 0,0,3,0,0,0,90 --size 60x30 --lights '" +
                             file("l.json") + "'");
    EXPECT_EQ(image.width, 60);
    EXPECT_EQ(image.height, 30);
    // The square is 2 of the 6 units that the picture is high: 10 x 10 pixels.
    EXPECT_EQ(stats_["covered_pixels"], 100);
    for (size_t i = 0; i < image.rgba.size(); ++i) {
        if (i % 4 != 3) {
            EXPECT_EQ(image.rgba[i], 0.0f);
        }
    }
}

TEST_F(Viewer, ReferenceOfAModelIsTheModel)
{
    // No fit is needed, and the Lambertian plane facing a directional light is albedo / pi.
    writeFile(file("l.json"), R"({"lights": [{"type": "directional", "direction": [0, 0, 1],
                                  "intensity": [2, 2, 2]}]})");
    const Image image = draw(
        "--headless --technique reference --material lambert:albedo=0.25 --mesh plane --size 8x8 "
        "--camera 0,0,1,0,0,0,60 --lights '" +
        file("l.json") + "'");
    EXPECT_EQ(stats_["evaluated"], "source");
    EXPECT_NEAR(image.pixel(4, 4)[1], 2.0 * 0.25 / kPi, 1e-6);
}

TEST_F(Viewer, PngIsSrgbOfExposedRadiance)
{
    const Image linear = draw(drawMade() + "--technique reference");
    ASSERT_EQ(
        runViewer(drawMade() + "--technique reference --exposure 0.7 --out '" + file("p.png") + "'")
            .exitCode,
        0);
    const auto png = OIIO::ImageInput::open(file("p.png"));
    ASSERT_TRUE(png);
    ASSERT_EQ(png->spec().nchannels, 3);
    std::vector<uint8_t> codes(3 * linear.pixelCount());
    ASSERT_TRUE(png->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, codes.data()));
    for (size_t i = 0; i < linear.pixelCount(); ++i)
        for (size_t c = 0; c < 3; ++c)
            ASSERT_EQ(codes[3 * i + c], srgbCode(0.7f * linear.rgba[4 * i + c]));
}

TEST_F(Viewer, SeveralMaterialsAreSeveralObjects)
{
    NEEDS(Backend::egl);
    const std::string arguments = "--headless --size 96x48 --material '" + file("made.fbrdf") +
                                  "' --material '" + file("made.fbrdf") + "' ";
    const Image reference = draw(arguments + "--technique reference");
    const Image image = draw(arguments);
    EXPECT_EQ(stats_["draw_calls"], 2);
    EXPECT_LE(compare(image, reference).worst, kAgainstReference);
    EXPECT_EQ(image.pixel(48, 24)[3], 0.0f) << "nothing between the two";
    EXPECT_EQ(image.pixel(24, 24)[3], 1.0f);
    EXPECT_EQ(image.pixel(72, 24)[3], 1.0f);
}

TEST_F(Viewer, ASourceIsFittedFirst)
{
    NEEDS(Backend::egl);
    const std::string arguments =
        "--headless --size 32x32 --form hdio --material lambert:albedo=0.5 ";
    const Image fitted = draw(arguments);
    EXPECT_EQ(stats_["evaluated"], "material");
    const Image reference = draw(arguments + "--technique reference");
    EXPECT_EQ(stats_["evaluated"], "source");
    // 8-bit log maps of a constant: far better than a percent.
    EXPECT_LE(compare(fitted, reference).worst, 1e-2);
}

// --- the window ----------------------------------------------------------------------------------

TEST_F(ViewerWindow, DrawsFramesClosesAndAgreesWithTheReference)
{
    for (const char* technique : {"two-lookup", "vertex", "reference", "path"}) {
        const std::string scene = "--plain --size 80x80 --light-count 2 --material '" +
                                  file("made.fbrdf") + "' --technique " + technique;
        const ProgramResult result =
            runViewer(scene + " --bounces 0 --frames 3 --out '" + file("w.exr") + "' --stats '" +
                          file("w.json") + "'",
                      xvfb_);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const auto stats = readJson(file("w.json"));
        EXPECT_EQ(stats["backend"], "window");
        EXPECT_EQ(stats["technique"], technique);
        const bool isVertex = std::string(technique) == "vertex";
        const Image expected = draw("--headless " + scene.substr(0, scene.rfind("--technique")) +
                                    "--technique " + (isVertex ? "vertex" : "reference"));
        EXPECT_EQ(compare(readExr(file("w.exr")), expected).coverageDiffers, 0);
        EXPECT_LE(compare(readExr(file("w.exr")), expected).worst, kAgainstReference);
    }
}

TEST_F(ViewerWindow, BeginsWithTheFullSceneOfThePictures)
{
    const std::string scene =
        "--size 64x40 --samples 2 --environment-lobes 1 --material '" + file("made.fbrdf") + "' ";
    const ProgramResult result = runViewer(
        scene + "--frames 2 --out '" + file("w.exr") + "' --stats '" + file("w.json") + "'", xvfb_);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto stats = readJson(file("w.json"));
    EXPECT_EQ(stats["environment"]["name"], "studio");
    EXPECT_EQ(stats["frames"], 2);
    NEEDS(Backend::egl);
    const Image expected = draw("--headless --full " + scene);
    const Image window = readExr(file("w.exr"));
    ASSERT_EQ(window.rgba.size(), expected.rgba.size());
    double off = 0.0, largest = 0.0, sum = 0.0;
    for (size_t i = 0; i < window.rgba.size(); ++i) {
        const double difference = std::abs(double(window.rgba[i]) - double(expected.rgba[i]));
        off += difference;
        largest = std::max(largest, difference);
        sum += double(expected.rgba[i]);
    }
    EXPECT_LE(off / sum, 1e-4);
    EXPECT_LE(largest, 1e-2);
}

TEST_F(ViewerWindow, SaysThatGlIsTooOld)
{
    expectError(runViewer("--plain --size 64x40 --frames 1 --material '" + file("made.fbrdf") + "'",
                          xvfb_ + " MESA_GL_VERSION_OVERRIDE=2.1 MESA_GLSL_VERSION_OVERRIDE=120"),
                6, "expected a display with OpenGL 3.3");
}

}  // namespace
}  // namespace fbrdf::scene
