// ThumbnailCache.h - small pictures of materials that are kept between runs, in the user's folder
// of caches and nowhere else.
#pragma once
#include <fbrdf/pictures/Png.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fbrdf::viewer {

constexpr int kThumbnailSide = 96;  ///< pixels

/// Stands for the bytes of a material file: 32 digits that change with any of them, and with how
/// thumbnails are drawn.
std::string thumbnailKey(std::string_view bytes);

/// $XDG_CACHE_HOME/fbrdf/thumbnails, by default ~/.cache/fbrdf/thumbnails (XDG Base Directory
/// Specification); empty where neither is known.
std::string thumbnailFolder();

class ThumbnailCache {
public:
    static constexpr uintmax_t kMostBytes = 32 << 20;  ///< some 2,000 thumbnails

    /// folder: empty for none; made when the first thumbnail is stored. mostBytes: that it keeps;
    /// where it grows above that, those that were stored first are deleted.
    explicit ThumbnailCache(std::string folder, uintmax_t mostBytes = kMostBytes)
        : folder_(std::move(folder)), mostBytes_(mostBytes)
    {
    }

    /// None where there is no such file, or one that is no thumbnail.
    std::optional<PngImage> load(const std::string& key) const;
    /// What cannot be stored will be drawn again.
    void store(const std::string& key, const PngImage& image) const;

private:
    std::string pathOf(const std::string& key) const { return folder_ + "/" + key + ".png"; }

    void prune() const;

    std::string folder_;
    uintmax_t mostBytes_;
};

}  // namespace fbrdf::viewer
