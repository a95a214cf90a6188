// ViewerDocumentTest.cpp - scenes of fbrdf-viewer: saved and undone in the window, drawn without.
#include "ViewerFixture.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/scene/TextFile.h>

namespace fbrdf::scene {
namespace {

class ViewerDocument : public ViewerActions {
protected:
    std::string saved() const { return file("fbrdf-viewer-001.json"); }
};

/// Mean difference over the mean of what is expected.
double difference(const Image& a, const Image& b)
{
    EXPECT_EQ(a.rgba.size(), b.rgba.size());
    double off = 0.0, sum = 0.0;
    for (size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i) {
        off += std::abs(double(a.rgba[i]) - double(b.rgba[i]));
        sum += double(b.rgba[i]);
    }
    return off / sum;
}

TEST_F(ViewerDocument, WhatTheWindowSavesIsDrawnWithoutOne)
{
    const std::string arguments = "--plain --ground --shadows --samples 2 --material '" +
                                  file("made.fbrdf") + "' --out '" + file("w.exr") + "' --stats '" +
                                  file("w.json") + "'";
    const ProgramResult result = press(arguments, "o t l plus ctrl+s");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto scene = readJson(saved());
    EXPECT_EQ(scene["mesh"], "knot");
    EXPECT_EQ(scene["technique"], "batched");
    EXPECT_EQ(scene["lights"]["made"], 10);
    EXPECT_EQ(scene["materials"][0]["source"], "made.fbrdf");
    EXPECT_EQ(scene["size"], (nlohmann::json{96, 64}));
    const Image window = readExr(file("w.exr"));
    const Image headless = draw("--headless --scene '" + saved() + "'");
    EXPECT_LE(difference(headless, window), 1e-4);
    EXPECT_EQ(stats_["technique"], "batched");
    // The test can fail: another light is another picture.
    EXPECT_GT(difference(draw("--headless '" + saved() + "' --light-count 2"), window), 1e-2);
}

TEST_F(ViewerDocument, UndoAndRedoGoThroughTheChanges)
{
    const std::string material = "--plain --material '" + file("made.fbrdf") + "' ";
    ASSERT_EQ(press(material, "space o t plus ctrl+z ctrl+z ctrl+z ctrl+s").exitCode, 0);
    auto scene = readJson(saved());
    EXPECT_EQ(scene["mesh"], "sphere");
    EXPECT_EQ(scene["technique"], "single");
    EXPECT_EQ(scene["turning"], true);
    std::filesystem::remove(saved());
    ASSERT_EQ(press(material, "space o t plus ctrl+z ctrl+z ctrl+z ctrl+shift+z ctrl+s").exitCode,
              0);
    scene = readJson(saved());
    EXPECT_EQ(scene["mesh"], "knot");
    EXPECT_EQ(scene["technique"], "single");
}

TEST_F(ViewerDocument, ComparisonsAreUndoneSavedAndDrawnWithoutAWindow)
{
    const std::string material = "--plain --material '" + file("made.fbrdf") + "' ";
    ASSERT_EQ(press(material, "space v 3 bracketright ctrl+z ctrl+s").exitCode, 0);
    const auto compare = readJson(saved())["compare"];
    EXPECT_EQ(compare["on"], true);
    EXPECT_EQ(compare["mode"], "split");
    EXPECT_EQ(compare["a"], "reference") << "3 exchanged the sides";
    EXPECT_EQ(compare["b"], "drawn");
    EXPECT_EQ(compare["at"], 0.5) << "the step of the line is undone";
    draw("--headless --scene '" + saved() + "'");
    EXPECT_EQ(stats_["compare"]["a"]["name"], "reference");
    EXPECT_EQ(stats_["compare"]["b"]["name"], "drawn");
    draw("--headless --scene '" + saved() + "' --compare drawn drawn");
    EXPECT_EQ(stats_["compare"]["a"]["name"], "drawn") << "options change a part of the scene";
    // A window that begins with the scene has the comparison, and leaves it as it is.
    ASSERT_EQ(press("--scene '" + saved() + "'", "ctrl+s").exitCode, 0);
    EXPECT_EQ(readJson(saved())["compare"], compare);
}

TEST_F(ViewerDocument, AWindowGoesOnWithASceneAndSavesItToItsFile)
{
    const std::string path = file("mine.json");
    writeFile(path, R"({"fbrdf_scene": 1, "materials": [{"source": "made.fbrdf"}], "mesh": "knot",
                        "lights": {"made": 2}, "exposure": 0.5})");
    const ProgramResult result = press("--scene '" + path + "'", "o ctrl+s");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto scene = readJson(path);
    EXPECT_EQ(scene["mesh"], "plane");
    EXPECT_EQ(scene["exposure"], 0.5);
    EXPECT_EQ(scene["ground"], false);
    EXPECT_FALSE(std::filesystem::exists(saved()));
}

TEST_F(ViewerDocument, ALightIsAddedAndDraggedAsOneChange)
{
    const std::string arguments = "--plain --light-count 0 --material '" + file("made.fbrdf") + "'";
    size_ = "700x400";  // the panel ends at 312
    // A directional light from where the camera is stands in the middle of the picture.
    const std::string lights = file("lights.json");
    writeFile(lights, R"({"lights": [{"type": "directional", "direction": [0, 0, 1],
                                      "intensity": [1, 1, 1]}]})");
    // Frames come as fast as the machine allows: one has passed when a scene has been saved. The
    // panel must have seen that the mouse left it, and the history that the button is up.
    const std::string frame = "rm -f '" + saved() +
                              "'; xdotool key ctrl+s\n"
                              "for i in $(seq 600); do [ -s '" +
                              saved() + "' ] && break; sleep 0.1; done\n";
    const std::string drag =
        "xdotool mousemove 350 200\n" + frame + frame + "xdotool mousedown 1\n" + frame +
        "for x in 370 390 410; do xdotool mousemove $x 200; sleep 0.1; done\n" + frame +
        "xdotool mouseup 1\n" + frame + frame;
    const std::string with =
        "--plain --lights '" + lights + "' --material '" + file("made.fbrdf") + "'";
    ASSERT_EQ(act(with, drag).exitCode, 0);
    const auto moved = readJson(saved())["lights"][0]["direction"];
    EXPECT_GT(moved[0].get<double>(), 0.1) << moved;
    EXPECT_NEAR(moved[1].get<double>(), 0.0, 0.05);
    std::filesystem::remove(saved());
    ASSERT_EQ(act(with, drag + "xdotool key ctrl+z\n" + frame).exitCode, 0);
    EXPECT_EQ(readJson(saved())["lights"][0]["direction"], (nlohmann::json{0.0, 0.0, 1.0}))
        << "a drag is one change";
    std::filesystem::remove(saved());
    ASSERT_EQ(press(arguments, "a Right Delete a a ctrl+s").exitCode, 0);
    EXPECT_EQ(readJson(saved())["lights"].size(), 2u);
}

TEST_F(ViewerDocument, AMaterialOfTheFolderIsChosenByKeys)
{
    writeMaterial(madeMaterial(formPqp(16, 0.9)), file("other.fbrdf"));
    const ProgramResult result =
        press("--plain --material '" + file("made.fbrdf") + "'", "y Right Return ctrl+s");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto scene = readJson(saved());
    ASSERT_EQ(scene["materials"].size(), 2u);
    EXPECT_EQ(scene["materials"][1]["source"], "other.fbrdf");
    EXPECT_EQ(scene["shown"], 1);
    EXPECT_TRUE(std::filesystem::is_directory(file("caches/fbrdf/thumbnails")));
}

TEST_F(ViewerDocument, PicturesAreSavedAsShownAndAsRadiance)
{
    const ProgramResult result = press("--plain --exposure 0.5 --material '" + file("made.fbrdf") +
                                           "' --out '" + file("w.exr") + "'",
                                       "s ctrl+e ctrl+e");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Image radiance = readExr(file("fbrdf-viewer-001.exr"));
    EXPECT_EQ(radiance.rgba, readExr(file("w.exr")).rgba) << "before exposure and tone mapping";
    EXPECT_TRUE(std::filesystem::exists(file("fbrdf-viewer-002.exr")));
    const std::string png = readText(file("fbrdf-viewer-001.png"), "a picture");
    EXPECT_EQ(png, encodeImage(radiance, "p.png", 0.5f, Transfer::srgb));
}

TEST_F(Viewer, OptionsChangePartsOfAScene)
{
    NEEDS(Backend::egl);
    const std::string path = file("scene.json");
    writeFile(path, R"({"fbrdf_scene": 1, "materials": [{"source": "made.fbrdf"}], "mesh": "knot",
                        "lights": {"made": 3, "seed": 2}, "size": [40, 30],
                        "technique": "two-lookup"})");
    const Image image = draw("--headless --scene '" + path + "'");
    EXPECT_EQ(image.width, 40);
    EXPECT_EQ(stats_["mesh"], "knot");
    EXPECT_EQ(stats_["lights"]["given"], 3);
    EXPECT_EQ(stats_["technique"], "two-lookup");
    const Image same = draw(
        "--headless --size 40x30 --mesh knot --light-count 3 --seed 2 "
        "--technique two-lookup --material '" +
        file("made.fbrdf") + "'");
    EXPECT_EQ(image.rgba, same.rgba);
    draw("--headless '" + path + "' --mesh sphere --light-count 1 --technique single");
    EXPECT_EQ(stats_["mesh"], "sphere");
    EXPECT_EQ(stats_["lights"]["given"], 1);
    EXPECT_EQ(stats_["technique"], "single");
}

TEST_F(Viewer, ASceneSaysWhatIsDrawnTo)
{
    NEEDS(Backend::egl);
    const std::string path = file("scene.json");
    writeFile(path, R"({"fbrdf_scene": 1, "materials": [{"source": "made.fbrdf"}], "size": [32, 32],
                        "lights": {"made": 1}, "target": "RGBA8"})");
    for (const float value : draw("--headless '" + path + "'").rgba) {
        EXPECT_LE(value, 1.0f);
        EXPECT_NEAR(value * 255.0f, std::round(value * 255.0f), 1e-3f) << "codes of 8 bits";
    }
}

TEST_F(Viewer, ASceneThatIsWrongIsNamedAndLeavesNoPicture)
{
    const std::string path = file("scene.json"), out = file("p.png");
    const auto refuse = [&](const char* text, int exitCode, const std::string& where) {
        writeFile(path, text);
        expectError(runViewer("--headless --scene '" + path + "' --out '" + out + "'"), exitCode,
                    where);
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    refuse(R"({"fbrdf_scene": 1, "exposure": "high"})", 3, "scene.json: exposure: found \"high\"");
    refuse(R"({"fbrdf_scene": 1, "mesh": "none.obj"})", 3, "none.obj");
    refuse(R"({"fbrdf_scene": 1, "materials": [{"source": "none.csv"}]})", 3, "none.csv");
    refuse(R"({"fbrdf_scene": 1, )", 3, "scene.json: found");
    expectError(runViewer("--headless --scene '" + file("none.json") + "'"), 3, "none.json");
    expectError(runViewer("sheet made.fbrdf --scene '" + path + "' -o '" + out + "'"), 3,
                "scene.json");
}

}  // namespace
}  // namespace fbrdf::scene
