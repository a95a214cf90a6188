// Image.h - a picture of linear radiance, and its files.
#pragma once
#include <fbrdf/plan/Transfer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf::scene {

/// width x height pixels of linear RGB (Rec. 709 primaries) radiance and coverage. Row 0 is the
/// top.
struct Image {
    int width = 0, height = 0;
    std::vector<float> rgba;  ///< height x width x 4, channel contiguous

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgba(4 * pixelCount(), 0.0f) {}
    size_t pixelCount() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
    float* pixel(int x, int y) { return rgba.data() + 4 * offset(x, y); }
    const float* pixel(int x, int y) const { return rgba.data() + 4 * offset(x, y); }

private:
    size_t offset(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

/// Adds a picture of the same size to a sum of such.
void add(const Image& image, Image& sum);
/// The sum over a number of pictures, > 0: exactly the picture where that is 1.
Image meanOf(Image sum, int count);

/// 8-bit code of a linear value (IEC 61966-2-1), rounded to nearest; below 0 and NaN give 0, above
/// 1 gives 255.
uint8_t srgbCode(float linear);

/// The codes of sRGB of exposure x radiance, with Transfer::toneMap after its curve; no other
/// transfer than that and Transfer::srgb is expected. width x height x 3.
std::vector<uint8_t> srgbCodes(const Image& image, float exposure, Transfer transfer);

/// The bytes that writeImage writes.
std::string encodeImage(const Image& image, const std::string& path, float exposure,
                        Transfer transfer);

/// ".exr": the image as it is, 32-bit float RGBA. ".png": 8-bit sRGB of exposure x radiance, no
/// alpha. Others (fbrdf/codecs/PictureFile.h): ".hdr" linear radiance, the rest sRGB of exposure x
/// radiance in 8 or, for ".tif", 16 bits; transfer as above. The file appears whole or not at all.
/// Throws Error(usage) for any other extension, Error(output) where it cannot be written.
void writeImage(const Image& image, const std::string& path, float exposure,
                Transfer transfer = Transfer::srgb);

/// Throws what writeImage would because of the extension: Error(usage) where it is unknown,
/// Error(output) where the module that writes the format cannot be loaded.
void checkImagePath(const std::string& path);

}  // namespace fbrdf::scene
