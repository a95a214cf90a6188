#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/metrics/SpherePicture.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr double kLeastCosine = 0.0087;  // half a degree
constexpr double kMeanOfGrey = 0.4, kGrey = 0.5;

}  // namespace

bool SpherePixel::isSeen() const
{
    return wo.z > kLeastCosine;
}

std::vector<SpherePixel> spherePixels(int size)
{
    std::vector<SpherePixel> pixels;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            const double x = (2.0 * i + 1.0) / size - 1.0, y = 1.0 - (2.0 * j + 1.0) / size;
            if (x * x + y * y >= 1.0) continue;
            const Vec3d normal(x, y, std::sqrt(1.0 - x * x - y * y));
            // The tangent runs along increasing azimuth about +y.
            const auto frame = shadingFrame<double>(normal, Vec3d(normal.z, 0.0, -normal.x));
            pixels.push_back({frame, frame.local(Vec3d(0.0, 0.0, 1.0))});
        }
    return pixels;
}

SpherePicture spherePicture(const std::vector<SpherePixel>& pixels, int threads,
                            const std::function<Vec3d(const SpherePixel&)>& radiance)
{
    SpherePicture image(pixels.size(), Vec3d(0.0));
    parallelTasks(pixels.size(), threads, [&](size_t i) {
        if (pixels[i].isSeen()) image[i] = radiance(pixels[i]);
    });
    return image;
}

double exposureFor(const SpherePicture& irradiance)
{
    double sum = 0.0;
    for (const Vec3d& value : irradiance) sum += (value.x + value.y + value.z) / 3.0;
    return kMeanOfGrey / kGrey * static_cast<double>(irradiance.size()) / sum;
}

double psnr(const SpherePicture& image, const SpherePicture& reference, double exposure)
{
    FBRDF_ASSERT(image.size(), ==, reference.size());
    double sum = 0.0;
    for (size_t i = 0; i < image.size(); ++i) {
        const auto shown = [&](const Vec3d& value) {
            return glm::clamp(value * exposure, 0.0, 1.0);
        };
        const Vec3d difference = shown(image[i]) - shown(reference[i]);
        sum += glm::dot(difference, difference);
    }
    return sum > 0.0 ? 10.0 * std::log10(3.0 * static_cast<double>(image.size()) / sum)
                     : std::numeric_limits<double>::infinity();
}

}  // namespace fbrdf
