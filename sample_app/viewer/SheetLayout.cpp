#include "SheetLayout.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <string>

namespace fbrdf::viewer {
namespace {

constexpr int kLargestSheet = 16384;  // pixels on a side

}  // namespace

void checkLayout(const SheetLayout& layout)
{
    if (layout.sheetWidth() <= kLargestSheet && layout.sheetHeight() <= kLargestSheet) return;
    throw Error(ErrorKind::usage, "sheet",
                Found(std::to_string(layout.sheetWidth()) + "x" +
                      std::to_string(layout.sheetHeight()) + " pixels")
                    .expected("up to " + std::to_string(kLargestSheet) + " a side; see --size"));
}

void paste(const scene::Image& picture, int left, int top, scene::Image& sheet)
{
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, y), 4 * picture.width, sheet.pixel(left, top + y));
}

scene::Image paperOf(const SheetLayout& layout, float radiance)
{
    scene::Image sheet(layout.sheetWidth(), layout.sheetHeight());
    for (size_t i = 0; i < sheet.rgba.size(); ++i) sheet.rgba[i] = i % 4 == 3 ? 1.0f : radiance;
    return sheet;
}

}  // namespace fbrdf::viewer
