#include "Browser.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/scene/TextFile.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fbrdf::viewer {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostFiles = 2000;

/// Endings that measurements have and hardly anything else; the others can be dropped.
bool hasMeasuredEnding(const fs::path& path)
{
    constexpr const char* kEndings[] = {".astm",  ".binary", ".brdf", ".bsdf",
                                        ".mbsdf", ".xompt",  ".csv"};
    const std::string ending = lowerCase(path.extension().string());
    return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

bool isSameFile(const std::string& a, const std::string& b)
{
    return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

}  // namespace

std::vector<std::string> materialFilesIn(const std::string& folder)
{
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        if (!entry->is_regular_file(unknown)) continue;
        const std::string path = entry->path().string();
        const bool isFbrdf = entry->path().extension() == ".fbrdf";
        if ((isFbrdf && isMaterialFile(path)) || hasMeasuredEnding(entry->path()))
            files.push_back(path);
        if (files.size() == kMostFiles) break;
    }
    std::sort(files.begin(), files.end());
    return files;
}

Browser::Picture::Picture(const GladGLContext& gl, const PngImage& image) : gl_(&gl)
{
    const std::vector<uint8_t> bytes(image.codes.begin(), image.codes.end());
    gl.GenTextures(1, &texture_);
    gl.BindTexture(GL_TEXTURE_2D, texture_);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                  bytes.data());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.BindTexture(GL_TEXTURE_2D, 0);
}

Browser::Picture::~Picture()
{
    if (texture_ != 0) gl_->DeleteTextures(1, &texture_);
}

Browser::Picture::Picture(Picture&& other) noexcept
    : gl_(other.gl_), texture_(std::exchange(other.texture_, 0))
{
}

Browser::Picture& Browser::Picture::operator=(Picture&& other) noexcept
{
    std::swap(gl_, other.gl_);
    std::swap(texture_, other.texture_);
    return *this;
}

Browser::Browser(gl::LoadFunction load, const std::string& folder, ThumbnailCache cache)
    : gl_(loadGlFunctions(load)),
      load_(load),
      cache_(std::move(cache)),
      files_(materialFilesIn(folder))
{
}

Browser::~Browser() = default;

void Browser::follow(const scene::Document& document)
{
    items_.clear();
    const auto textureIn = [](const auto& pictures, const auto& key) {
        const auto known = pictures.find(key);
        return known == pictures.end() ? 0 : known->second.texture();
    };
    std::vector<bool> isOpen(files_.size(), false);
    for (size_t i = 0; i < document.materials.size(); ++i) {
        const scene::SceneMaterial& material = document.materials[i];
        items_.push_back(
            {material.source, static_cast<int>(i), textureIn(slotPictures_, material.slot)});
        for (size_t k = 0; k < files_.size(); ++k)
            if (isSameFile(files_[k], material.source)) isOpen[k] = true;
    }
    for (size_t k = 0; k < files_.size(); ++k)
        if (!isOpen[k]) items_.push_back({files_[k], -1, textureIn(filePictures_, files_[k])});
}

/// Nothing for a material that GL cannot draw.
std::optional<PngImage> Browser::drawn(const Material& material)
{
    try {
        if (!maker_) maker_ = std::make_unique<ThumbnailMaker>(load_);
        return maker_->draw(material);
    } catch (const Error&) {
        return std::nullopt;
    }
}

Browser::Picture Browser::pictureOfFile(const std::string& path)
{
    try {
        if (!isMaterialFile(path)) return {};  // it has to be fitted first
        const std::string bytes = scene::readText(path, "a material");
        const std::string key = thumbnailKey(bytes);
        std::optional<PngImage> image = cache_.load(key);
        if (!image) {
            image = drawn(materialFromFileBytes(bytes, path));
            if (image) cache_.store(key, *image);
        }
        return image ? Picture(gl_, *image) : Picture();
    } catch (const Error&) {
        return {};  // opening it says why
    }
}

/// Each picture once, that of a file that has none too.
bool Browser::makeOne(const scene::Document& document, World& world, bool isBusy)
{
    for (const scene::SceneMaterial& material : document.materials) {
        const int slot = material.slot;
        const bool isThere = slotPictures_.count(slot) > 0;
        if (slot < 0 || (isThere && (isBusy || stale_.count(slot) == 0))) continue;
        const auto image = drawn(world.materials[static_cast<size_t>(slot)].material());
        slotPictures_[slot] = image ? Picture(gl_, *image) : Picture();
        stale_.erase(slot);
        return true;
    }
    for (const std::string& path : files_) {
        if (filePictures_.count(path) > 0) continue;
        filePictures_[path] = pictureOfFile(path);
        return true;
    }
    return false;
}

}  // namespace fbrdf::viewer
