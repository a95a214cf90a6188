#include <fbrdf/base/Parallel.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/metrics/StandardSphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

struct DirectionalLight {
    Vec3d direction, irradiance;
};

// The lights of docs/method.md, section Errors.
const std::array<DirectionalLight, 128> kLights{{
#include "StandardLights.inc"
}};

const double kMinCosine = std::sin(0.5 * kPi / 180.0);
constexpr double kMeanOfHalfLambertian = 0.4;

struct Frame {
    Vec3d t, s, n;
    Vec3d local(const Vec3d& v) const { return {glm::dot(t, v), glm::dot(s, v), glm::dot(n, v)}; }
};

Frame frameAt(double x, double y)
{
    Frame frame;
    frame.n = {x, y, std::sqrt(1.0 - x * x - y * y)};
    // y cross n: the direction of increasing azimuth about +y.
    frame.t = glm::normalize(Vec3d(frame.n.z, 0.0, -frame.n.x));
    frame.s = glm::cross(frame.n, frame.t);
    return frame;
}

// Calls visit(wo, wi, irradiance of the surface) for every light.
template <class Visit>
void forEachLight(const Frame& frame, const Visit& visit)
{
    const Vec3d wo = frame.local({0.0, 0.0, 1.0});
    if (wo.z <= kMinCosine) return;
    for (const DirectionalLight& light : kLights) {
        const Vec3d wi = frame.local(glm::normalize(light.direction));
        if (wi.z > kMinCosine) visit(wo, wi, wi.z * light.irradiance);
    }
}

template <class Brdf>
Vec3d radianceAt(const Frame& frame, const Brdf& brdf)
{
    Vec3d sum(0.0);
    forEachLight(frame, [&](const Vec3d& wo, const Vec3d& wi, const Vec3d& irradiance) {
        sum += brdf(wo, wi) * irradiance;
    });
    return sum;
}

// Centre of pixel i of `size` in [-1, 1].
double centre(int i, int size)
{
    return (i + 0.5) / size * 2.0 - 1.0;
}

bool isCovered(int column, int row, int size)
{
    const double x = centre(column, size), y = -centre(row, size);
    return x * x + y * y < 1.0;
}

Frame frameOf(int pixel, int size)
{
    return frameAt(centre(pixel % size, size), -centre(pixel / size, size));
}

double exposureFor(int size, int threads)
{
    const auto lambertian = [](const Vec3d&, const Vec3d&) { return Vec3d(0.5 / kPi); };
    std::vector<double> rows(static_cast<size_t>(size));
    std::vector<size_t> pixels(rows.size());
    parallelTasks(rows.size(), threads, [&](size_t row) {
        for (int column = 0; column < size; ++column) {
            if (!isCovered(column, static_cast<int>(row), size)) continue;
            const int pixel = static_cast<int>(row) * size + column;
            const Vec3d l = radianceAt(frameOf(pixel, size), lambertian);
            rows[row] += (l.x + l.y + l.z) / 3.0;
            ++pixels[row];
        }
    });
    return kMeanOfHalfLambertian *
           static_cast<double>(std::accumulate(pixels.begin(), pixels.end(), size_t{0})) /
           std::accumulate(rows.begin(), rows.end(), 0.0);
}

}  // namespace

SphereImage renderStandardSphere(const BrdfFunction& brdf, int size, int threads)
{
    FBRDF_ASSERT(size, >, 0);
    SphereImage image;
    image.size = size;
    const auto count = static_cast<size_t>(size) * static_cast<size_t>(size);
    image.radiance.assign(count, Vec3f(0.0f));
    image.covered.assign(count, false);
    for (size_t i = 0; i < count; ++i)
        image.covered[i] = isCovered(static_cast<int>(i) % size, static_cast<int>(i) / size, size);
    const double exposure = exposureFor(size, threads);
    parallelTasks(static_cast<size_t>(size), threads, [&](size_t row) {
        for (size_t i = row * static_cast<size_t>(size); i < (row + 1) * static_cast<size_t>(size);
             ++i) {
            if (!image.covered[i]) continue;
            const Frame frame = frameOf(static_cast<int>(i), size);
            image.radiance[i] = Vec3f(glm::clamp(exposure * radianceAt(frame, brdf), 0.0, 1.0));
        }
    });
    return image;
}

std::vector<SphereTerm> standardSphereTerms(int size)
{
    FBRDF_ASSERT(size, >, 0);
    const double exposure = exposureFor(size, 0);
    std::vector<SphereTerm> terms;
    for (int pixel = 0; pixel < size * size; ++pixel) {
        if (!isCovered(pixel % size, pixel / size, size)) continue;
        forEachLight(frameOf(pixel, size),
                     [&](const Vec3d& wo, const Vec3d& wi, const Vec3d& irradiance) {
                         terms.push_back({pixel, {wo, wi}, exposure * irradiance});
                     });
    }
    return terms;
}

}  // namespace fbrdf
