// AnimationFile.h - moving pictures as bytes in memory: GIF and WebP, which play for ever. Codecs
// as in PictureFile.h.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

struct Animation {
    int width = 0, height = 0;  ///< of every frame, 1 to 16384
    int framesPerSecond = 24;   ///< 1 to 100; a GIF counts in hundredths of a second
    /// width x height x 3 codes of sRGB each; at least one.
    std::vector<std::vector<uint8_t>> frames;
};

/// True for ".gif" and ".webp", in any case of letters.
bool isAnimationPath(const std::string& path);

/// The bytes of the file that the extension of a path names; a GIF has 256 colours a frame. Expects
/// isAnimationPath(path). Throws Error(output) naming the path as encodePicture does.
std::string encodeAnimation(const Animation& animation, const std::string& path);

}  // namespace fbrdf
