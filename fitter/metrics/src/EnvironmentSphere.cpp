#include <fbrdf/base/Parallel.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/environment/SampledLight.h>
#include <fbrdf/metrics/EnvironmentSphere.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr int kWidth = 128, kHeight = 64;
constexpr double kLeastCosineOfLight = 0.0087;  // half a degree

std::vector<Panorama> allReduced(const std::vector<Panorama>& environments)
{
    std::vector<Panorama> result;
    for (const Panorama& environment : environments)
        result.push_back(reduced(environment, kWidth, kHeight));
    return result;
}

/// Part of a texel that a larger one covers: all of one add up to 1.
struct Share {
    int texel;
    double weight;
};

/// The texels that each of fewer texels along one axis covers. measure: of the axis from its
/// beginning to a place in [0, 1].
template <class Measure>
std::vector<std::vector<Share>> sharesOf(int from, int to, const Measure& measure)
{
    std::vector<std::vector<Share>> result;
    for (int k = 0; k < to; ++k) {
        const double begin = double(k) / to, end = double(k + 1) / to;
        const double whole = measure(end) - measure(begin);
        result.emplace_back();
        for (int texel = k * from / to; texel < from && texel < end * from; ++texel) {
            const double first = std::max(begin, double(texel) / from),
                         last = std::min(end, double(texel + 1) / from);
            if (last > first)
                result.back().push_back({texel, (measure(last) - measure(first)) / whole});
        }
    }
    return result;
}

}  // namespace

Panorama reduced(const Panorama& panorama, int width, int height)
{
    if (panorama.width <= width && panorama.height <= height) return panorama;
    Panorama result{std::min(width, panorama.width), std::min(height, panorama.height), {}};
    const auto columns = sharesOf(panorama.width, result.width, [](double u) { return u; });
    // Solid angle between two parallels.
    const auto rows =
        sharesOf(panorama.height, result.height, [](double v) { return -std::cos(kPi * v); });
    for (const auto& row : rows)
        for (const auto& column : columns) {
            Vec3d sum(0.0);
            for (const Share& j : row)
                for (const Share& i : column)
                    sum += i.weight * j.weight * Vec3d(panorama.texel(i.texel, j.texel));
            result.texels.emplace_back(sum);
        }
    return result;
}

int EnvironmentSphere::cubeSizeFor(int pixels)
{
    int size = 64;
    while (size < 512 && size < 8 * pixels) size *= 2;
    return size;
}

EnvironmentSphere::EnvironmentSphere(const std::vector<Panorama>& environments, int size,
                                     int cubeSize, int threads)
    : threads_(threads),
      panoramas_(allReduced(environments)),
      truth_(panoramas_),
      pixels_(spherePixels(size))
{
    for (const Panorama& panorama : panoramas_) {
        unfiltered_.push_back(cubeOfPanorama(panorama, cubeSize));
        cubes_.push_back(prefiltered(unfiltered_.back(), cubeSize, threads));
    }
    // The exposure must not depend on what is judged, so the irradiance is a sum over texels too.
    const Panorama& first = panoramas_.front();
    irradiance_ = imagesOf([&](const Pixel& pixel, size_t environment) {
        Vec3d sum(0.0);
        for (int y = 0; y < first.height; ++y)
            for (int x = 0; x < first.width; ++x) {
                const double cosine =
                    glm::dot(pixel.frame.n,
                             panoramaDirection((x + 0.5) / first.width, (y + 0.5) / first.height));
                if (cosine > 0.0)
                    sum += cosine / kPi * texelSolidAngle(first, y) *
                           Vec3d(panoramas_[environment].texel(x, y));
            }
        return sum;
    });
    for (const Image& image : irradiance_) exposures_.push_back(exposureFor(image));
}

std::vector<EnvironmentSphere::Image> EnvironmentSphere::truth(const Reflectance& f) const
{
    std::vector<Image> images(environments(), Image(pixels_.size(), Vec3d(0.0)));
    parallelTasks(pixels_.size(), threads_, [&](size_t i) {
        if (!pixels_[i].isSeen()) return;
        const auto sums =
            truth_.reflected(f, pixels_[i].frame, Vec3d(0.0, 0.0, 1.0), kLeastCosineOfLight);
        for (size_t e = 0; e < images.size(); ++e) images[e][i] = sums[e];
    });
    return images;
}

std::vector<EnvironmentSphere::Image> EnvironmentSphere::imagesOf(
    const std::function<Vec3d(const Pixel&, size_t)>& radiance) const
{
    std::vector<Image> images(environments(), Image(pixels_.size(), Vec3d(0.0)));
    parallelTasks(pixels_.size(), threads_, [&](size_t i) {
        if (!pixels_[i].isSeen()) return;
        for (size_t e = 0; e < images.size(); ++e) images[e][i] = radiance(pixels_[i], e);
    });
    return images;
}

std::vector<EnvironmentSphere::Image> EnvironmentSphere::lit(const LobeTable& lobes) const
{
    return imagesOf([&](const Pixel& pixel, size_t environment) {
        const CubeImage& cube = cubes_[environment];
        const LobeSum<double> sum = lobesAt(lobes, pixel.wo);
        Vec3d radiance = sum.cosine * samplePrefiltered(cube, pixel.frame.n, kCosineLevel);
        for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) {
            const Vec3d& axis = sum.axis[k];
            const Vec3d world =
                pixel.frame.t * axis.x + pixel.frame.s * axis.y + pixel.frame.n * axis.z;
            radiance += sum.weight[k] * samplePrefiltered(cube, world, sum.level[k]);
        }
        return radiance;
    });
}

std::vector<EnvironmentSphere::Image> EnvironmentSphere::sampled(const LobeTable& lobes,
                                                                 const Reflectance& f,
                                                                 int samples) const
{
    return imagesOf([&](const Pixel& pixel, size_t environment) {
        return sampledLight(unfiltered_[environment], lobes, f, pixel.frame, pixel.wo, samples);
    });
}

double EnvironmentSphere::psnr(const Image& image, const Image& reference, size_t environment) const
{
    return fbrdf::psnr(image, reference, exposures_[environment]);
}

}  // namespace fbrdf
