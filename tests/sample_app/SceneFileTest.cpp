// SceneFileTest.cpp - scenes on disk, and the files that they name.
#include "viewer/SceneFile.h"

#include "viewer/World.h"

#include "SampleDocument.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/scene/TextFile.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <filesystem>

namespace fbrdf::viewer {
namespace {

namespace fs = std::filesystem;

scene::Document documentIn(const test::TemporaryDir& folder)
{
    scene::Document document = scene::sampleDocument();
    document.materials[0].source = folder.file("tables/paint.csv@0.55");
    document.mesh = folder.file("cow.obj");
    document.environment.name = folder.file("sky.exr");
    document.compare.a = folder.file("tables/other.fbrdf");
    return document;
}

TEST(SceneFile, GivesTheDocumentBack)
{
    const test::TemporaryDir folder;
    const scene::Document document = documentIn(folder);
    writeScene(document, folder.file("s.json"));
    EXPECT_TRUE(isSceneFile(folder.file("s.json")));
    EXPECT_TRUE(readScene(folder.file("s.json")) == document);
}

TEST(SceneFile, MovesWithItsFiles)
{
    const test::TemporaryDir folder, other;
    writeScene(documentIn(folder), folder.file("s.json"));
    fs::rename(folder.file("s.json"), other.file("moved.json"));
    EXPECT_TRUE(readScene(other.file("moved.json")) == documentIn(other));
    const std::string text = scene::readText(other.file("moved.json"), "it");
    EXPECT_EQ(text.find(folder.file("")), std::string::npos) << "no path of this machine";
    EXPECT_NE(text.find("\"tables/paint.csv@0.55\""), std::string::npos);
}

TEST(SceneFile, NamesOfWhatIsBuiltInStay)
{
    const test::TemporaryDir folder;
    const scene::Document document = scene::sampleDocument();
    writeScene(document, folder.file("s.json"));
    const scene::Document read = readScene(folder.file("s.json"));
    EXPECT_EQ(read.materials[1].source, "ggx:alpha=0.3");
    EXPECT_EQ(read.mesh, "knot");
    EXPECT_EQ(read.environment.name, "studio");
    EXPECT_EQ(read.compare.b, "hdio");
    EXPECT_EQ(fs::path(read.materials[0].source).filename(), "paint.fbrdf");
}

TEST(SceneFile, WhatIsNoSceneIsRefusedAndNamed)
{
    const test::TemporaryDir folder;
    const std::string path = folder.file("s.json");
    for (const char* text : {"", "{}", R"({"lights": []})"}) {
        writeFile(path, text);
        EXPECT_FALSE(isSceneFile(path)) << text;
        try {
            readScene(path);
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
        }
    }
    writeFile(path, R"({"fbrdf_scene": 1, "mes)");
    EXPECT_TRUE(isSceneFile(path)) << "a damaged one is to be read as what it was meant to be";
    EXPECT_FALSE(isSceneFile(folder.file("none.json")));
    EXPECT_THROW(readScene(folder.file("none.json")), Error);
}

// A picture that is dropped may be a panorama or a table of reflectance: its shape decides.
TEST(DroppedPicture, IsAPanoramaWhereItHasTheShapeOfOne)
{
    const test::TemporaryDir folder;
    const std::string path = folder.file("p.exr");
    const auto written = [&path](int width, int height) {
        scene::Image image(width, height);
        for (float& value : image.rgba) value = 0.5f;
        writeImage(image, path, 1.0f, Transfer::srgb);
        return path;
    };
    const auto wide = panoramaOf(written(16, 8));
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->panorama.width, 16);
    EXPECT_FALSE(panoramaOf(written(16, 16))) << "a slice";
    EXPECT_FALSE(panoramaOf(written(90, 9)));
    writeFile(path, "fbrdf:layout");
    EXPECT_FALSE(panoramaOf(path));
    EXPECT_FALSE(panoramaOf(folder.file("none.exr")));
}

TEST(SceneFile, AFailureLeavesTheOldFile)
{
    const test::TemporaryDir folder;
    const std::string path = folder.file("s.json");
    writeFile(path, "precious");
    scene::Document document = scene::sampleDocument();
    document.mesh = "\xff.obj";
    EXPECT_THROW(writeScene(document, path), Error);
    EXPECT_EQ(scene::readText(path, "it"), "precious");
    EXPECT_THROW(writeScene(scene::sampleDocument(), folder.file("none/s.json")), Error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace fbrdf::viewer
