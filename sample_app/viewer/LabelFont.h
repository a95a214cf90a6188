// LabelFont.h - lines of text in pictures, in the font that Dear ImGui brings (LabelFontImGui.cpp),
// or none without Dear ImGui (LabelFontNone.cpp).
#pragma once
#include <fbrdf/scene/Image.h>

#include <memory>
#include <string>

namespace fbrdf::viewer {

/// Where a line may be, in pixels from the picture's top left corner.
struct LabelPlace {
    int x = 0, y = 0, width = 0;
};

class LabelFont {
public:
    static bool isThere();  ///< in builds with Dear ImGui
    /// scale: 1 for letters of 13 pixels, 2 for 26, ... Throws Error(usage) without Dear ImGui.
    explicit LabelFont(int scale);
    ~LabelFont();
    LabelFont(const LabelFont&) = delete;
    LabelFont& operator=(const LabelFont&) = delete;

    int height() const;                          ///< pixels
    int widthOf(const std::string& text) const;  ///< pixels
    /// Draws ASCII, and a question mark for every other byte, from the left, in grey of that
    /// radiance. What is too wide loses its middle, and has "..." there.
    void draw(scene::Image& image, const LabelPlace& place, const std::string& text,
              float radiance) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf::viewer
