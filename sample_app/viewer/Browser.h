// Browser.h - the materials of a document and of a folder, with a small picture of each.
#pragma once
#include "GlFunctions.h"
#include "ThumbnailMaker.h"
#include "World.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// What can be shown, or opened first.
struct BrowserItem {
    std::string source;    ///< as in SceneMaterial
    int place = -1;        ///< among the document's materials; -1: a file that is not opened
    uint32_t texture = 0;  ///< of GL, its thumbnail, row 0 the top; 0: not drawn yet, or none
};

/// The files of a folder that are materials, or that by their ending are measurements, by name; an
/// empty list for what is no folder.
std::vector<std::string> materialFilesIn(const std::string& folder);

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class Browser {
public:
    /// folder: may be empty.
    Browser(gl::LoadFunction load, const std::string& folder, ThumbnailCache cache);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// A material of the world is another than before: its picture will be drawn again.
    void forget(size_t slot) { stale_.insert(static_cast<int>(slot)); }
    /// Lists what there is.
    void follow(const scene::Document& document);
    /// Makes the picture of one that has none, or, where nothing is busy, of one that has become
    /// another: one at a time, so that frames stay short. False where there is none to be made.
    bool makeOne(const scene::Document& document, World& world, bool isBusy);
    const std::vector<BrowserItem>& items() const { return items_; }

private:
    /// A texture that is deleted with it; 0: there is no picture.
    class Picture {
    public:
        Picture() = default;
        Picture(const GladGLContext& gl, const PngImage& image);
        ~Picture();
        Picture(Picture&& other) noexcept;
        Picture& operator=(Picture&& other) noexcept;
        GLuint texture() const { return texture_; }

    private:
        const GladGLContext* gl_ = nullptr;
        GLuint texture_ = 0;
    };
    std::optional<PngImage> drawn(const Material& material);
    Picture pictureOfFile(const std::string& path);

    GladGLContext gl_;
    gl::LoadFunction load_;
    ThumbnailCache cache_;
    std::unique_ptr<ThumbnailMaker> maker_;  ///< null until something has to be drawn
    std::vector<std::string> files_;
    std::map<std::string, Picture> filePictures_;
    std::map<int, Picture> slotPictures_;  ///< of materials that are no files
    std::set<int> stale_;                  ///< keys of slotPictures_
    std::vector<BrowserItem> items_;
};

}  // namespace fbrdf::viewer
