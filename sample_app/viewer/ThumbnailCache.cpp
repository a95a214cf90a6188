#include "ThumbnailCache.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/scene/TextFile.h>

#include <fmt/core.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr uint64_t kVersion = 1;  // of how thumbnails are drawn

uint64_t hashOf(std::string_view bytes, uint64_t seed)
{
    uint64_t hash = splitMix64(seed ^ bytes.size());
    for (size_t i = 0; i < bytes.size(); i += sizeof hash) {
        uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        hash = splitMix64(hash ^ word);
    }
    return hash;
}

std::string variable(const char* name)
{
    const char* const value = std::getenv(name);
    // Relative paths are to be ignored, says the specification.
    return value && std::filesystem::path(value).is_absolute() ? value : "";
}

}  // namespace

std::string thumbnailKey(std::string_view bytes)
{
    return fmt::format("{:016x}{:016x}", hashOf(bytes, kVersion), hashOf(bytes, ~kVersion));
}

std::string thumbnailFolder()
{
    std::string caches = variable("XDG_CACHE_HOME");
    if (caches.empty() && !variable("HOME").empty()) caches = variable("HOME") + "/.cache";
    return caches.empty() ? "" : caches + "/fbrdf/thumbnails";
}

std::optional<PngImage> ThumbnailCache::load(const std::string& key) const
{
    const std::string path = pathOf(key);
    if (folder_.empty() || !std::filesystem::is_regular_file(path)) return std::nullopt;
    try {
        PngImage image = decodePng(scene::readText(path, "a thumbnail"), path);
        const bool isOne = image.width == kThumbnailSide && image.height == kThumbnailSide &&
                           image.channels == 3 && image.bits == 8;
        return isOne ? std::optional(std::move(image)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void ThumbnailCache::store(const std::string& key, const PngImage& image) const
{
    if (folder_.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(folder_, ignored);
    try {
        writeFile(pathOf(key), encodePng(image, pathOf(key)));
    } catch (const Error&) {
        return;
    }
}

}  // namespace fbrdf::viewer
