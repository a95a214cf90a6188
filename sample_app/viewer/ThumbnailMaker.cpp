#include "ThumbnailMaker.h"

#include "Headless.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Lights.h>

namespace fbrdf::viewer {
namespace {

constexpr int kOversampling = 2;  // pixels of the drawing on a side of a thumbnail's pixel
constexpr int kSegments = 48, kRings = 24;
constexpr int kThumbnailLights = 12;
constexpr float kDark = 0.02f;  // radiance behind the sphere
constexpr float kBrightness = 0.8f;

gl::RendererOptions quietOptions(gl::LoadFunction load)
{
    gl::RendererOptions options;
    options.load = load;
    return options;
}

/// A mean of pixels over what is behind them.
PngImage reduced(const scene::Image& image)
{
    scene::Image small(kThumbnailSide, kThumbnailSide);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* const from = image.pixel(x, y);
            float* const to = small.pixel(x / kOversampling, y / kOversampling);
            for (int c = 0; c < 3; ++c)
                to[c] += (from[c] + (1.0f - from[3]) * kDark) / (kOversampling * kOversampling);
        }
    PngImage png{kThumbnailSide, kThumbnailSide, 3, 8, {}};
    for (const uint8_t code : srgbCodes(small, kBrightness, Transfer::toneMap))
        png.codes.push_back(code);
    return png;
}

}  // namespace

ThumbnailMaker::ThumbnailMaker(gl::LoadFunction load)
    : renderer_(quietOptions(load)),
      offscreen_(load, {kOversampling * kThumbnailSide, kOversampling * kThumbnailSide}),
      sphere_(renderer_.createMesh(scene::makeSphere(kSegments, kRings)))
{
}

PngImage ThumbnailMaker::draw(const Material& material)
{
    const int side = kOversampling * kThumbnailSide;
    const scene::Bounds ball{Vec3f(0.0f), 1.0f};
    const gl::View view = viewFromCamera(framed(scene::Camera(), ball, 1.0), 1.0, ball);
    const auto uploaded = renderer_.createMaterial(material);
    offscreen_.clear();
    const gl::DrawStats drawn =
        renderer_.draw({offscreen_.framebuffer(), side, side}, view,
                       {{uploaded.get(), sphere_.get()}}, scene::makeLights(kThumbnailLights));
    if (drawn.itemsFailed > 0)
        throw Error(ErrorKind::gl, "thumbnail", Found("no picture").expected("one"));
    return reduced(imageFromBottomRows(offscreen_.readPixels(), side, side));
}

}  // namespace fbrdf::viewer
