#include "Module.h"
#include "PictureModule.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/codecs/AnimationFile.h>
#include <fbrdf/codecs/PictureFile.h>

#include <algorithm>
#include <string_view>

namespace fbrdf {
namespace {

void takeAnimation(void* file, const void* bytes, size_t size)
{
    static_cast<std::string*>(file)->assign(static_cast<const char*>(bytes), size);
}

std::string gifOf(const Animation& animation, const std::string& path)
{
    std::vector<const unsigned char*> frames;
    for (const auto& frame : animation.frames) frames.push_back(frame.data());
    const fbrdf_frames_to_write source{animation.width, animation.height, animation.framesPerSecond,
                                       static_cast<int>(frames.size()), frames.data()};
    std::string bytes;
    char why[512] = "";
    const fbrdf_picture_module& module = pictureModule(ErrorKind::output, path);
    if (module.encodeFrames("gif", &source, takeAnimation, &bytes, why, sizeof why) != 0)
        throw Error(ErrorKind::output, path, std::string("cannot be written: ") + why);
    return bytes;
}

// Google 2023, "WebP Container Specification": chunks of a name, a size and so many bytes, padded
// to an even number; numbers begin with their lowest byte.

std::string number(uint32_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffu);
    return text;
}

std::string chunk(const char* name, const std::string& content)
{
    return name + number(static_cast<uint32_t>(content.size()), 4) + content +
           std::string(content.size() % 2, '\0');
}

/// The coded picture within a file of one: the first chunk of its kind, whole.
std::string codedPicture(std::string_view file, const std::string& path)
{
    for (size_t at = 12; at + 8 <= file.size();) {
        size_t size = 0;
        for (size_t i = 0; i < 4; ++i)
            size |= static_cast<size_t>(static_cast<unsigned char>(file[at + 4 + i])) << (8 * i);
        const size_t whole = 8 + size + size % 2;
        const std::string_view name = file.substr(at, 4);
        if ((name == "VP8 " || name == "VP8L") && whole <= file.size() - at)
            return std::string(file.substr(at, whole));
        at += whole;
    }
    throw Error(ErrorKind::output, path, "cannot be written: a frame has no coded picture");
}

std::string webpOf(const Animation& animation, const std::string& path)
{
    const auto size = [&] {
        return number(static_cast<uint32_t>(animation.width - 1), 3) +
               number(static_cast<uint32_t>(animation.height - 1), 3);
    }();
    constexpr uint32_t kAnimated = 0x02, kReplaces = 0x02;
    std::string chunks = chunk("VP8X", number(kAnimated, 4) + size);
    chunks += chunk("ANIM", number(0xff000000u, 4) + number(0, 2));  // black behind, without end
    for (const auto& frame : animation.frames) {
        PictureSamples picture{animation.width, animation.height, 3, {}};
        picture.samples.resize(frame.size());
        std::transform(frame.begin(), frame.end(), picture.samples.begin(),
                       [](uint8_t code) { return static_cast<float>(code) / 255.0f; });
        const std::string file = encodePicture(picture, *pictureFormatOf(path), path);
        chunks +=
            chunk("ANMF", number(0, 6) + size +
                              number(1000u / static_cast<uint32_t>(animation.framesPerSecond), 3) +
                              number(kReplaces, 1) + codedPicture(file, path));
    }
    return chunk("RIFF", "WEBP" + chunks);
}

}  // namespace

bool isAnimationPath(const std::string& path)
{
    const PictureFormat* const format = pictureFormatOf(path);
    return format &&
           (format->name == std::string_view("gif") || format->name == std::string_view("webp"));
}

std::string encodeAnimation(const Animation& animation, const std::string& path)
{
    FBRDF_ASSERT(animation.frames.size(), >, 0u);
    for (const auto& frame : animation.frames)
        FBRDF_ASSERT(
            frame.size(), ==,
            3 * static_cast<size_t>(animation.width) * static_cast<size_t>(animation.height));
    return pictureFormatOf(path)->name == std::string_view("gif") ? gifOf(animation, path)
                                                                  : webpOf(animation, path);
}

}  // namespace fbrdf
