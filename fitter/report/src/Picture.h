// Picture.h - 8-bit pictures and their PNG.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

struct Picture {
    int width = 0, height = 0;
    /// width x height x 4, row 0 on top; encoded values, straight alpha.
    std::vector<uint8_t> rgba;

    Picture(int w, int h);
    /// Sets an opaque pixel. Components are display values and are clamped to [0, 1].
    void set(int x, int y, const Vec3d& colour);
};

/// The bytes of a PNG file. Throws Error(output) when the encoder fails.
std::vector<uint8_t> pngOf(const Picture& picture);
/// "data:image/png;base64,..."
std::string dataUri(const Picture& picture);

}  // namespace fbrdf
