// BrowserGLTest.cpp - the materials of a document and of a folder, and their thumbnails.
#include "viewer/Browser.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/headless/Context.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/scene/TextFile.h>
#include <fbrdf/sources/OpenSource.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

Material fitted(const std::string& spec)
{
    FitOptions options;
    options.form = "io";
    options.smoothness = 1e-3;
    return fitMaterial(openSource(spec), options).material;
}

class Thumbnails : public testing::Test {
protected:
    void SetUp() override
    {
        try {
            context_.emplace(HeadlessOptions{});
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
        writeMaterial(fitted("lambert:albedo=0.8/0.1/0.1"), folder_.file("red.fbrdf"));
        writeMaterial(fitted("lambert:albedo=0.1/0.1/0.8"), folder_.file("blue.fbrdf"));
        writeFile(folder_.file("some.csv"), "theta_i");
        writeFile(folder_.file("notes.md"), "");
        writeFile(folder_.file("broken.fbrdf"), "no material");
    }
    /// Codes of R, G and B in the middle of a texture.
    std::array<int, 3> middleOf(uint32_t texture)
    {
        const GladGLContext gl = loadGlFunctions(context_->loader());
        std::vector<uint8_t> rgb(size_t{3} * kThumbnailSide * kThumbnailSide);
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
        gl.BindTexture(GL_TEXTURE_2D, 0);
        const size_t at = size_t{3} * (kThumbnailSide / 2 * kThumbnailSide + kThumbnailSide / 2);
        return {rgb[at], rgb[at + 1], rgb[at + 2]};
    }

    /// A frame.
    bool makeOne(Browser& browser, bool isBusy = false)
    {
        const bool isMade = browser.makeOne(document_, world_, isBusy);
        browser.follow(document_);
        return isMade;
    }

    test::TemporaryDir folder_, caches_;
    std::optional<HeadlessContext> context_;
    World world_;
    scene::Document document_;
};

TEST_F(Thumbnails, AFolderHasItsMaterialsAndMeasurements)
{
    const auto files = materialFilesIn(folder_.file(""));
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(std::filesystem::path(files[0]).filename(), "blue.fbrdf");
    EXPECT_EQ(std::filesystem::path(files[1]).filename(), "red.fbrdf");
    EXPECT_EQ(std::filesystem::path(files[2]).filename(), "some.csv");
    EXPECT_TRUE(materialFilesIn(folder_.file("none")).empty());
    EXPECT_TRUE(materialFilesIn("").empty());
}

TEST_F(Thumbnails, OneIsMadeAFrameAndShowsItsMaterial)
{
    Browser browser(context_->loader(), folder_.file(""), ThumbnailCache(caches_.file("")));
    const auto made = [&browser] {
        return std::count_if(browser.items().begin(), browser.items().end(),
                             [](const BrowserItem& item) { return item.texture != 0; });
    };
    browser.follow(document_);
    EXPECT_EQ(browser.items().size(), 3u);
    EXPECT_EQ(made(), 0);
    for (const int expected : {1, 2, 2, 2}) {
        makeOne(browser);
        EXPECT_EQ(made(), expected) << "a measurement has none before it is fitted";
    }
    EXPECT_FALSE(makeOne(browser)) << "none is left";
    const auto blue = middleOf(browser.items()[0].texture),
               red = middleOf(browser.items()[1].texture);
    EXPECT_GT(blue[2], 2 * blue[0]);
    EXPECT_GT(red[0], 2 * red[2]);
    EXPECT_LT(red[0], 250) << "it is not burnt out";
}

TEST_F(Thumbnails, AreTakenFromTheCacheAndMadeAnewWhereThatIsBroken)
{
    const std::string key = thumbnailKey(scene::readText(folder_.file("blue.fbrdf"), "it"));
    const ThumbnailCache cache(caches_.file(""));
    const auto firstOf = [&] {
        Browser browser(context_->loader(), folder_.file(""), cache);
        makeOne(browser);
        return middleOf(browser.items()[0].texture);
    };
    const auto drawn = firstOf();
    ASSERT_TRUE(cache.load(key)) << "named by the bytes of the material";
    PngImage grey{kThumbnailSide, kThumbnailSide, 3, 8, {}};
    grey.codes.assign(size_t{3} * kThumbnailSide * kThumbnailSide, 77);
    cache.store(key, grey);
    EXPECT_EQ(firstOf(), (std::array<int, 3>{77, 77, 77})) << "what is kept is not drawn";
    writeFile(caches_.file(key + ".png"), "broken");
    EXPECT_EQ(firstOf(), drawn);
    EXPECT_TRUE(cache.load(key));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.file("")),
                            std::filesystem::directory_iterator()),
              5)
        << "nothing is left beside the user's files";
}

TEST_F(Thumbnails, MaterialsOfTheDocumentComeFirstAndFollowTheirFits)
{
    world_.materials.emplace_back("lambert:albedo=0.8/0.1/0.1", nullptr,
                                  fitted("lambert:albedo=0.8/0.1/0.1"));
    document_.materials.resize(2);
    document_.materials[0].source = "lambert:albedo=0.8/0.1/0.1";
    document_.materials[0].slot = 0;
    document_.materials[1].source = folder_.file("red.fbrdf");  // still to be loaded
    Browser browser(context_->loader(), folder_.file(""), ThumbnailCache(""));
    EXPECT_TRUE(makeOne(browser, true)) << "what has no picture gets one, whatever else is done";
    ASSERT_EQ(browser.items().size(), 4u) << "a file that is open is not listed twice";
    EXPECT_EQ(browser.items()[0].place, 0);
    EXPECT_EQ(browser.items()[1].place, 1);
    EXPECT_EQ(browser.items()[1].texture, 0u);
    EXPECT_EQ(browser.items()[2].place, -1);
    EXPECT_GT(middleOf(browser.items()[0].texture)[0], middleOf(browser.items()[0].texture)[2]);
    world_.materials[0].replace("lambert:albedo=0.1/0.1/0.8", nullptr,
                                fitted("lambert:albedo=0.1/0.1/0.8"));
    browser.forget(0);
    while (makeOne(browser, true)) continue;
    EXPECT_GT(middleOf(browser.items()[0].texture)[0], middleOf(browser.items()[0].texture)[2])
        << "while fits follow a slider, the picture waits";
    EXPECT_TRUE(makeOne(browser));
    EXPECT_LT(middleOf(browser.items()[0].texture)[0], middleOf(browser.items()[0].texture)[2]);
}

}  // namespace
}  // namespace fbrdf::viewer
