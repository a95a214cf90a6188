// ThumbnailCacheTest.cpp - thumbnails that are kept between runs.
#include "viewer/ThumbnailCache.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/scene/TextFile.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace fbrdf::viewer {
namespace {

PngImage picture(uint16_t code)
{
    PngImage image{kThumbnailSide, kThumbnailSide, 3, 8, {}};
    image.codes.assign(size_t{3} * kThumbnailSide * kThumbnailSide, code);
    image.codes[7] = 200;
    return image;
}

TEST(ThumbnailCache, GivesBackWhatWasStored)
{
    const test::TemporaryDir folder;
    const ThumbnailCache cache(folder.file("a/b"));
    const std::string key = thumbnailKey("material");
    EXPECT_FALSE(cache.load(key));
    cache.store(key, picture(10));
    ASSERT_TRUE(cache.load(key));
    EXPECT_EQ(cache.load(key)->codes, picture(10).codes);
    EXPECT_FALSE(cache.load(thumbnailKey("other")));
    cache.store(key, picture(11));
    EXPECT_EQ(cache.load(key)->codes, picture(11).codes);
}

TEST(ThumbnailCache, KeysChangeWithEveryByteAndLength)
{
    std::set<std::string> keys;
    std::string bytes(37, 'x');
    keys.insert(thumbnailKey(bytes));
    for (size_t i = 0; i < bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i] = 'y';
        keys.insert(thumbnailKey(changed));
    }
    keys.insert(thumbnailKey(bytes + '\0'));
    keys.insert(thumbnailKey(""));
    EXPECT_EQ(keys.size(), bytes.size() + 3);
    for (const std::string& key : keys) {
        EXPECT_EQ(key.size(), 32u);
        EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
    }
}

TEST(ThumbnailCache, WhatIsNoThumbnailIsNone)
{
    const test::TemporaryDir folder;
    const ThumbnailCache cache(folder.file(""));
    const std::string key = thumbnailKey("material"), path = folder.file(key + ".png");
    cache.store(key, picture(10));
    const std::string whole = scene::readText(path, "it");
    for (size_t length = 0; length < whole.size(); length += 7) {
        writeFile(path, whole.substr(0, length));
        EXPECT_FALSE(cache.load(key)) << length;
    }
    PngImage small{8, 8, 3, 8, std::vector<uint16_t>(192, 1)};
    writeFile(path, encodePng(small, path));
    EXPECT_FALSE(cache.load(key)) << "of another size";
    cache.store(key, picture(10));
    EXPECT_TRUE(cache.load(key)) << "it is made anew";
}

TEST(ThumbnailCache, TheOldestAreDeletedWhereThereAreTooManyBytes)
{
    const test::TemporaryDir folder;
    const auto keyOf = [](int i) { return thumbnailKey("material " + std::to_string(i)); };
    const auto pathOf = [&](int i) { return folder.file(keyOf(i) + ".png"); };
    ThumbnailCache(folder.file("")).store(keyOf(0), picture(10));
    const auto bytes = std::filesystem::file_size(pathOf(0));
    writeFile(folder.file("notes.png"), std::string(10 * bytes, 'x'));
    const ThumbnailCache small(folder.file(""), 3 * bytes);
    const auto now = std::filesystem::last_write_time(pathOf(0));
    for (int i = 1; i < 6; ++i) {
        // As if each was stored an hour after the one before.
        for (int k = 0; k < i; ++k)
            if (std::filesystem::exists(pathOf(k)))
                std::filesystem::last_write_time(pathOf(k), now - std::chrono::hours(i - k));
        small.store(keyOf(i), picture(10));
    }
    for (int i = 0; i < 6; ++i) EXPECT_EQ(small.load(keyOf(i)).has_value(), i >= 3) << i;
    EXPECT_TRUE(std::filesystem::exists(folder.file("notes.png"))) << "it is no thumbnail";
}

TEST(ThumbnailCache, AFolderThatCannotBeIsLikeNone)
{
    const test::TemporaryDir folder;
    writeFile(folder.file("taken"), "");
    for (const std::string& path : {std::string(), folder.file("taken/a")}) {
        const ThumbnailCache cache(path);
        cache.store(thumbnailKey("m"), picture(1));
        EXPECT_FALSE(cache.load(thumbnailKey("m")));
    }
}

TEST(ThumbnailCache, IsInTheUsersFolderOfCaches)
{
    setenv("XDG_CACHE_HOME", "/somewhere", 1);
    EXPECT_EQ(thumbnailFolder(), "/somewhere/fbrdf/thumbnails");
    setenv("XDG_CACHE_HOME", "not/absolute", 1);
    setenv("HOME", "/home/someone", 1);
    EXPECT_EQ(thumbnailFolder(), "/home/someone/.cache/fbrdf/thumbnails");
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    EXPECT_EQ(thumbnailFolder(), "");
}

}  // namespace
}  // namespace fbrdf::viewer
