#include <fbrdf/base/Parallel.h>
#include <fbrdf/peers/SplitSum.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

constexpr int kAlphas = 29;
constexpr double kNarrowest = 1.0 / 128.0;
constexpr int kSplits = 6;  // of texels near the axis of a lobe
constexpr double kNearAxis = 12.0 * kDegree;

/// GGX with the half vector for n and v for the mirror direction, not normalised (Karis 2013).
double lobe(double cosine, double alpha)
{
    if (cosine <= 0.0) return 0.0;
    const double h2 = 0.5 * (1.0 + cosine), d = h2 * (alpha * alpha - 1.0) + 1.0;
    return cosine / (d * d);
}

/// Directions and solid angles of all texels, and of their parts.
struct Texels {
    std::vector<Vec3d> directions;
    std::vector<double> solidAngles;
    std::vector<std::vector<Vec3d>> parts;

    explicit Texels(const Panorama& panorama)
    {
        for (int y = 0; y < panorama.height; ++y)
            for (int x = 0; x < panorama.width; ++x) {
                const auto at = [&](double dx, double dy) {
                    return panoramaDirection((x + dx) / panorama.width, (y + dy) / panorama.height);
                };
                directions.push_back(at(0.5, 0.5));
                solidAngles.push_back(texelSolidAngle(panorama, y));
                parts.emplace_back();
                for (int j = 0; j < kSplits; ++j)
                    for (int i = 0; i < kSplits; ++i)
                        parts.back().push_back(at((i + 0.5) / kSplits, (j + 0.5) / kSplits));
            }
    }
};

/// The environments averaged with the lobe about an axis.
std::vector<Vec3d> averaged(const Texels& texels, const std::vector<Panorama>& panoramas,
                            const Vec3d& axis, double alpha)
{
    std::vector<Vec3d> sums(panoramas.size(), Vec3d(0.0));
    double weights = 0.0;
    const double near = std::cos(kNearAxis);
    for (size_t i = 0; i < texels.directions.size(); ++i) {
        const double cosine = glm::dot(texels.directions[i], axis);
        double weight = lobe(cosine, alpha);
        if (cosine > near) {
            weight = 0.0;
            for (const Vec3d& part : texels.parts[i]) weight += lobe(glm::dot(part, axis), alpha);
            weight /= kSplits * kSplits;
        }
        weight *= texels.solidAngles[i];
        if (!(weight > 0.0)) continue;
        weights += weight;
        for (size_t e = 0; e < sums.size(); ++e) sums[e] += weight * Vec3d(panoramas[e].texels[i]);
    }
    for (Vec3d& sum : sums) sum /= weights;
    return sums;
}

}  // namespace

SplitSum::SplitSum(const EnvironmentSphere& sphere, int threads) : sphere_(sphere)
{
    const Texels texels(sphere.panoramas().front());
    const auto& pixels = sphere.pixels();
    for (int k = 0; k < kAlphas; ++k) {
        const double alpha = kNarrowest * std::exp2(0.25 * k);
        alphas_.push_back(alpha);
        images_.emplace_back(sphere.environments(),
                             EnvironmentSphere::Image(pixels.size(), Vec3d(0.0)));
        parallelTasks(pixels.size(), threads, [&](size_t i) {
            if (!pixels[i].isSeen()) return;
            const Vec3d& n = pixels[i].frame.n;
            const Vec3d mirror = 2.0 * pixels[i].wo.z * n - Vec3d(0.0, 0.0, 1.0);
            // Highlights lean towards the normal as they widen.
            const Vec3d axis = glm::normalize(glm::mix(mirror, n, alpha * alpha));
            const auto values = averaged(texels, sphere.panoramas(), axis, alpha);
            for (size_t e = 0; e < values.size(); ++e) images_.back()[e][i] = values[e];
        });
    }
}

SplitSum::Fit SplitSum::best(const std::vector<EnvironmentSphere::Image>& truth,
                             const std::vector<Vec3d>& albedo) const
{
    Vec3d least = albedo.front();
    for (const Vec3d& a : albedo) least = glm::min(least, a);
    Fit best;
    double bestMean = -1e9;
    for (size_t k = 0; k < alphas_.size(); ++k) {
        // (albedo - diffuse) lobe + diffuse irradiance: least squares for the diffuse albedo.
        Vec3d product(0.0), square(0.0);
        for (size_t e = 0; e < truth.size(); ++e)
            for (size_t i = 0; i < albedo.size(); ++i) {
                const Vec3d slope = sphere_.irradiance()[e][i] - images_[k][e][i];
                product += slope * (truth[e][i] - albedo[i] * images_[k][e][i]);
                square += slope * slope;
            }
        Fit fit;
        fit.alpha = alphas_[k];
        fit.diffuse = glm::clamp(product / glm::max(square, 1e-12), Vec3d(0.0), least);
        for (size_t e = 0; e < truth.size(); ++e) {
            EnvironmentSphere::Image image;
            for (size_t i = 0; i < albedo.size(); ++i)
                image.push_back((albedo[i] - fit.diffuse) * images_[k][e][i] +
                                fit.diffuse * sphere_.irradiance()[e][i]);
            fit.psnr.push_back(sphere_.psnr(image, truth[e], e));
        }
        const double mean = std::accumulate(fit.psnr.begin(), fit.psnr.end(), 0.0);
        if (mean <= bestMean) continue;
        bestMean = mean;
        best = fit;
    }
    return best;
}

}  // namespace fbrdf
