#include "Picture.h"

#include "Html.h"

#include <fbrdf/pictures/Png.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

Picture::Picture(int w, int h)
    : width(w), height(h), rgba(static_cast<size_t>(w) * static_cast<size_t>(h) * 4, 0)
{
}

void Picture::set(int x, int y, const Vec3d& colour)
{
    uint8_t* pixel =
        &rgba[(static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * 4];
    for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<uint8_t>(std::lround(255.0 * std::clamp(colour[c], 0.0, 1.0)));
    pixel[3] = 255;
}

std::vector<uint8_t> pngOf(const Picture& picture)
{
    const std::vector<uint16_t> codes(picture.rgba.begin(), picture.rgba.end());
    const std::string bytes = encodePng({picture.width, picture.height, 4, 8, codes}, "report");
    return {bytes.begin(), bytes.end()};
}

std::string dataUri(const Picture& picture)
{
    return "data:image/png;base64," + base64(pngOf(picture));
}

}  // namespace fbrdf
