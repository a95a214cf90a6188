// SheetLayout.h - where the pictures of a sheet and their labels are.
#pragma once
#include <fbrdf/scene/Image.h>

namespace fbrdf::viewer {

constexpr int kSheetGap = 8;          ///< pixels between pictures
constexpr int kPixelsPerScale = 320;  ///< of a picture's width, for labels to grow
constexpr float kSheetPaper = 0.02f, kSheetInk = 0.8f;  ///< shares of what is shown white

/// Pictures of one size in columns and rows, each with a strip for a label below it.
struct SheetLayout {
    int columns = 1, rows = 1;
    int width = 0, height = 0, label = 0;  ///< of a picture and of the strip, pixels

    int sheetWidth() const { return kSheetGap + columns * (width + kSheetGap); }
    int sheetHeight() const { return kSheetGap + rows * (height + label + kSheetGap); }
    int left(int column) const { return kSheetGap + column * (width + kSheetGap); }
    int top(int row) const { return kSheetGap + row * (height + label + kSheetGap); }
};

/// Throws Error(usage) for a sheet of more than 16384 pixels a side.
void checkLayout(const SheetLayout& layout);
/// An empty sheet of that radiance, opaque.
scene::Image paperOf(const SheetLayout& layout, float radiance);
/// Copies a picture into the sheet, its top left corner to that pixel.
void paste(const scene::Image& picture, int left, int top, scene::Image& sheet);

}  // namespace fbrdf::viewer
