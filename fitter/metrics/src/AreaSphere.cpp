#include <fbrdf/base/Assert.h>
#include <fbrdf/metrics/AreaSphere.h>
#include <fbrdf/plan/AreaContour.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// So far that directions to the light are the same all over the sphere.
constexpr double kFar = 1000.0;
// Lobes are broader than two neighbours of so many points.
constexpr AreaPoints kManyPoints{1024, 4096};

AreaLight rectangleLight(const Vec3d& centre, double width, double height)
{
    AreaLight light;
    light.shape = AreaLight::Shape::rectangle;
    light.position = centre;
    // It shines towards the origin.
    const Vec3d across = glm::normalize(glm::cross(centre, Vec3d(0.0, 1.0, 0.0)));
    light.axisU = 0.5 * width * across;
    light.axisV = 0.5 * height * glm::normalize(glm::cross(across, centre));
    if (glm::dot(glm::cross(light.axisU, light.axisV), light.position) > 0.0f)
        light.axisU = -light.axisU;
    return light;
}

}  // namespace

std::vector<NamedAreaLight> comparedAreaLights()
{
    std::vector<NamedAreaLight> lights;
    for (const Vec3d& direction : {Vec3d(-0.5, 0.6, 0.62), Vec3d(0.8, 0.2, 0.55),
                                   Vec3d(0.1, -0.3, 0.95), Vec3d(0.9, 0.35, -0.25)}) {
        AreaLight sphere;
        sphere.position = kFar * glm::normalize(direction);
        sphere.size = static_cast<float>(kFar * std::sin(15.0 * kDegree));
        lights.push_back({"sphere " + std::to_string(lights.size() + 1), sphere});
    }
    lights.push_back({"window", rectangleLight({-1.6, 1.2, 1.8}, 1.0, 1.4)});
    lights.push_back({"strip", rectangleLight({1.5, 0.4, 1.5}, 0.2, 2.5)});
    lights.push_back({"ceiling", rectangleLight({0.2, 3.0, 0.6}, 3.0, 3.0)});
    lights.push_back({"rim", rectangleLight({2.0, 0.8, -1.2}, 1.0, 1.0)});
    return lights;
}

AreaSphere::AreaSphere(const std::vector<NamedAreaLight>& lights, int size, int threads)
    : threads_(threads), lights_(lights), pixels_(spherePixels(size))
{
    LobeSum<double> white;
    white.cosine = Vec3d(1.0);
    for (const NamedAreaLight& named : lights_) {
        FBRDF_ASSERT(named.light.shape != AreaLight::Shape::polygon, ==, true);
        appendAreaVectors(named.light, 0, glm::dmat4(1.0), vectors_);
        truths_.emplace_back(named.light, kManyPoints);
        const AreaVectors& light = vectors_.back();
        exposures_.push_back(exposureFor(spherePicture(pixels_, threads, [&](const SpherePixel& p) {
            return areaReflected(white, p.frame, light, p.frame.n);
        })));
    }
}

std::vector<SpherePicture> AreaSphere::truth(const Reflectance& f) const
{
    std::vector<SpherePicture> images;
    for (const AreaTruth& light : truths_)
        images.push_back(spherePicture(pixels_, threads_, [&](const SpherePixel& p) {
            return light.reflected(f, p.frame.n, p.frame, {0.0, 0.0, 1.0});
        }));
    return images;
}

std::vector<SpherePicture> AreaSphere::lit(const LobeTable& lobes) const
{
    std::vector<SpherePicture> images;
    for (const AreaVectors& light : vectors_)
        images.push_back(spherePicture(pixels_, threads_, [&](const SpherePixel& p) {
            return areaReflected(lobesAt(lobes, p.wo), p.frame, light, p.frame.n);
        }));
    return images;
}

AreaSphere::Errors AreaSphere::errors(const SpherePicture& image, const SpherePicture& reference,
                                      size_t light) const
{
    const auto sumOf = [](const SpherePicture& picture) {
        double sum = 0.0;
        for (const Vec3d& value : picture) sum += value.x + value.y + value.z;
        return sum;
    };
    double squares = 0.0, largest = 0.0, peak = 0.0;
    for (size_t i = 0; i < image.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double difference = std::abs(image[i][c] - reference[i][c]);
            squares += difference * difference;
            largest = std::max(largest, difference);
            peak = std::max(peak, reference[i][c]);
        }
    const double rms = std::sqrt(squares / (3.0 * static_cast<double>(image.size())));
    return {psnr(image, reference, exposures_[light]),
            std::abs(sumOf(image) / sumOf(reference) - 1.0), rms / peak, largest / peak};
}

}  // namespace fbrdf
