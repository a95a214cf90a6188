// Says how far the pictures of two folders are from each other, as people see them.
// Usage: picture_flip FOLDER REFERENCES LIMIT
// Every PNG of FOLDER is compared with that of the same name in REFERENCES.
// Exit codes: 0 each has a FLIP of at most LIMIT, 1 one has more, or there is none, 2 bad usage.
#include <fbrdf/metrics/ImageErrors.h>

#include <OpenImageIO/imageio.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

float linearOf(float code)
{
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

fbrdf::ShownImage read(const std::filesystem::path& path)
{
    const auto file = OIIO::ImageInput::open(path.string());
    if (!file) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = file->spec();
    const auto pixels = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height);
    if (spec.nchannels < 3) throw std::runtime_error(path.string() + ": found no colours");
    std::vector<float> codes(3 * pixels);
    if (!file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, codes.data()))
        throw std::runtime_error(file->geterror());
    fbrdf::ShownImage image{spec.width, spec.height, {}, std::vector<bool>(pixels, true)};
    for (size_t i = 0; i < pixels; ++i)
        image.radiance.push_back(
            {linearOf(codes[3 * i]), linearOf(codes[3 * i + 1]), linearOf(codes[3 * i + 2])});
    return image;
}

/// Infinite for pictures of two sizes.
double flipOf(const fbrdf::ShownImage& image, const fbrdf::ShownImage& reference)
{
    if (image.width != reference.width || image.height != reference.height)
        return std::numeric_limits<double>::infinity();
    return fbrdf::imageErrors(image, reference).flip;
}

}  // namespace

int main(int argc, char** argv)
try {
    const std::string text = argc == 4 ? argv[3] : "";
    double limit = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), limit);
    if (text.empty() || parsed.ptr != text.data() + text.size()) {
        std::fprintf(stderr, "usage: picture_flip FOLDER REFERENCES LIMIT\n");
        return 2;
    }
    bool isNear = true, isEmpty = true;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        if (entry.path().extension() != ".png") continue;
        const auto reference = std::filesystem::path(argv[2]) / entry.path().filename();
        const double flip = flipOf(read(entry.path()), read(reference));
        std::printf("%-24s FLIP %.4f\n", entry.path().filename().c_str(), flip);
        isNear = isNear && flip <= limit;
        isEmpty = false;
    }
    if (isEmpty) std::fprintf(stderr, "%s: found no PNG\n", argv[1]);
    return isNear && !isEmpty ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
