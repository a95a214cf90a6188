#include "Picture.h"

#include "Html.h"

#include <fbrdf/base/Error.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

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
    std::vector<uint8_t> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto writer = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(picture.width, picture.height, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const bool written =
        writer && writer->set_ioproxy(&memory) && writer->open("picture.png", spec) &&
        writer->write_image(OIIO::TypeDesc::UINT8, picture.rgba.data()) && writer->close();
    if (!written)
        throw Error(ErrorKind::output, "report",
                    "found no PNG encoder that writes to memory: " +
                        (writer ? writer->geterror() : OIIO::geterror()) +
                        ", expected OpenImageIO's");
    return bytes;
}

std::string dataUri(const Picture& picture)
{
    return "data:image/png;base64," + base64(pngOf(picture));
}

}  // namespace fbrdf
