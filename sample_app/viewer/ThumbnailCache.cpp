#include "ThumbnailCache.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/scene/TextFile.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <tuple>
#include <vector>

namespace fbrdf::viewer {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kVersion = 1;  // of how thumbnails are drawn
constexpr size_t kKeyDigits = 32;

bool isThumbnailName(const fs::path& path)
{
    const std::string key = path.stem().string();
    return path.extension() == ".png" && key.size() == kKeyDigits &&
           key.find_first_not_of("0123456789abcdef") == std::string::npos;
}

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
    prune();
}

/// What others have put into the folder stays.
void ThumbnailCache::prune() const
{
    struct Kept {
        fs::file_time_type time;
        uintmax_t bytes = 0;
        fs::path path;
    };
    std::vector<Kept> kept;
    uintmax_t bytes = 0;
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error), end; !error && entry != end;
         entry.increment(error)) {
        if (!isThumbnailName(entry->path())) continue;
        std::error_code gone;  // another window prunes as well
        const Kept one{entry->last_write_time(gone), entry->file_size(gone), entry->path()};
        if (gone) continue;
        kept.push_back(one);
        bytes += one.bytes;
    }
    std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
        return std::tie(a.time, a.path) < std::tie(b.time, b.path);
    });
    for (const Kept& oldest : kept) {
        if (bytes <= mostBytes_) return;
        fs::remove(oldest.path, error);
        bytes -= oldest.bytes;
    }
}

}  // namespace fbrdf::viewer
