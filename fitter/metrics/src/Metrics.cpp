#include <fbrdf/base/Parallel.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Means of one channel's differences over a block of samples, as sums.
struct Sums {
    double logSquares = 0, cosSquares = 0, cosReference = 0, rootSquares = 0, rootReference = 0;
    double compressed = 0;
    std::vector<float> logs;  // |ln g / f|

    void add(double f, double g, double cosine, double noiseFloor)
    {
        if (f > noiseFloor) addLog(f, g);
        const double cf = cosine * f, cg = cosine * g;
        cosSquares += (cg - cf) * (cg - cf);
        cosReference += cf * cf;
        // The other two are for reflectance only; a slightly negative g, as networks give, counts
        // as black.
        const double positive = std::max(cg, 0.0), root = std::cbrt(cf);
        rootSquares += (std::cbrt(positive) - root) * (std::cbrt(positive) - root);
        rootReference += root * root;
        compressed += std::abs(std::log1p(positive) - std::log1p(cf));
    }

    void addLog(double f, double g)
    {
        // A black g where f is not black is as wrong as a float can express, yet leaves the mean
        // finite. NaN is infinitely wrong, so that the median of the logs stays defined.
        constexpr double kBlack = static_cast<double>(std::numeric_limits<float>::min());
        const double error = std::abs(std::log(std::max(g, kBlack) / f));
        const double counted = std::isnan(g) ? std::numeric_limits<double>::infinity() : error;
        logSquares += counted * counted;
        logs.push_back(static_cast<float>(counted));
    }

    void add(const Sums& other)
    {
        logSquares += other.logSquares;
        cosSquares += other.cosSquares;
        cosReference += other.cosReference;
        rootSquares += other.rootSquares;
        rootReference += other.rootReference;
        compressed += other.compressed;
        logs.insert(logs.end(), other.logs.begin(), other.logs.end());
    }
};

double medianOf(std::vector<float>& values)
{
    if (values.empty()) return kNone;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 != 0) return static_cast<double>(*middle);
    const float below = *std::max_element(values.begin(), middle);
    return 0.5 * (static_cast<double>(below) + static_cast<double>(*middle));
}

double ratioOfRoots(double numerator, double denominator)
{
    return denominator > 0.0 ? std::sqrt(numerator / denominator) : kNone;
}

// Mean over the channels that have a value: a channel without light has no relative error.
double overChannels(const Vec3d& values)
{
    double sum = 0.0;
    int count = 0;
    for (int c = 0; c < 3; ++c) {
        if (std::isnan(values[c])) continue;
        sum += values[c];
        ++count;
    }
    return count > 0 ? sum / count : kNone;
}

Sums channelSums(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted, int channel,
                 double noiseFloor)
{
    constexpr size_t kBlock = 16384;
    std::vector<Sums> blocks((samples.size() + kBlock - 1) / kBlock);
    parallelTasks(blocks.size(), 0, [&](size_t block) {
        const size_t end = std::min(samples.size(), (block + 1) * kBlock);
        for (size_t i = block * kBlock; i < end; ++i) {
            const double f = std::max(0.0, static_cast<double>(samples[i].f[channel]));
            blocks[block].add(f, static_cast<double>(fitted[i][channel]),
                              static_cast<double>(samples[i].wi.z), noiseFloor);
        }
    });
    Sums total;
    for (const Sums& block : blocks) total.add(block);
    return total;
}

// |ln a / b|; NaN where both are black, infinite where one is.
double logRatio(double a, double b)
{
    if (a <= 0.0 && b <= 0.0) return kNone;
    if (a <= 0.0 || b <= 0.0) return std::numeric_limits<double>::infinity();
    return std::abs(std::log(a / b));
}

template <class Evaluate>
std::vector<Vec3f> evaluatedAt(const std::vector<Sample>& samples, int threads,
                               const Evaluate& evaluateOne)
{
    std::vector<Vec3f> values(samples.size());
    parallelFor(samples.size(), threads, [&](size_t i) { values[i] = evaluateOne(samples[i]); });
    return values;
}

/// Median |ln f(pair) / f(partner(pair))| over uniform pairs.
template <class Partner>
double medianChange(const BrdfFunction& brdf, int threads, size_t pairCount, const Partner& partner)
{
    const std::vector<DirectionPair<double>> pairs = uniformPairs(pairCount);
    std::vector<Vec3d> errors(pairs.size());
    parallelFor(pairs.size(), threads, [&](size_t i) {
        const DirectionPair<double> other = partner(pairs[i]);
        const Vec3d one = brdf(pairs[i].wo, pairs[i].wi), two = brdf(other.wo, other.wi);
        for (int c = 0; c < 3; ++c) errors[i][c] = logRatio(one[c], two[c]);
    });
    std::vector<float> counted;
    for (const Vec3d& error : errors)
        for (int c = 0; c < 3; ++c)
            if (!std::isnan(error[c])) counted.push_back(static_cast<float>(error[c]));
    return medianOf(counted);
}

}  // namespace

SampleErrors sampleErrors(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
                          const Vec3f& noiseFloor)
{
    FBRDF_ASSERT(fitted.size(), ==, samples.size());
    Vec3d logRms(0.0), cosRms(0.0), rootRms(0.0), compressed(0.0);
    SampleErrors errors;
    for (int c = 0; c < 3; ++c) {
        Sums sums = channelSums(samples, fitted, c, static_cast<double>(noiseFloor[c]));
        logRms[c] = ratioOfRoots(sums.logSquares, static_cast<double>(sums.logs.size()));
        errors.logMedianChannel[c] = medianOf(sums.logs);
        cosRms[c] = ratioOfRoots(sums.cosSquares, sums.cosReference);
        rootRms[c] = ratioOfRoots(sums.rootSquares, sums.rootReference);
        compressed[c] =
            samples.empty() ? kNone : sums.compressed / static_cast<double>(samples.size());
    }
    errors.logRms = overChannels(logRms);
    errors.logMedian = overChannels(errors.logMedianChannel);
    errors.cosRms = overChannels(cosRms);
    errors.cubeRootRms = overChannels(rootRms);
    errors.nbrdfLoss = overChannels(compressed);
    return errors;
}

std::vector<Vec3f> evaluateAt(const Material& material, const std::vector<Sample>& samples,
                              int threads)
{
    return evaluatedAt(samples, threads,
                       [&](const Sample& s) { return evaluate<float>(material, s.wo, s.wi); });
}

std::vector<Vec3f> evaluateAt(const BrdfFunction& brdf, const std::vector<Sample>& samples,
                              int threads)
{
    return evaluatedAt(samples, threads,
                       [&](const Sample& s) { return Vec3f(brdf(Vec3d(s.wo), Vec3d(s.wi))); });
}

double medianReciprocityError(const BrdfFunction& brdf, int threads, size_t pairCount)
{
    return medianChange(brdf, threads, pairCount, [](const DirectionPair<double>& pair) {
        return DirectionPair<double>{pair.wi, pair.wo};
    });
}

double medianMirrorError(const BrdfFunction& brdf, int threads, size_t pairCount)
{
    return medianChange(brdf, threads, pairCount, [](const DirectionPair<double>& pair) {
        return DirectionPair<double>{mirrored(pair.wo), mirrored(pair.wi)};
    });
}

PhysicsErrors physicsErrors(const BrdfFunction& brdf, int threads)
{
    constexpr size_t kIncidences = 16;
    constexpr double kLargest = 85.0 * kPi / 180.0;
    std::vector<Vec3d> albedos(kIncidences);
    parallelTasks(kIncidences, threads, [&](size_t i) {
        albedos[i] = directionalAlbedo(brdf, kLargest * static_cast<double>(i) / (kIncidences - 1));
    });
    PhysicsErrors errors;
    errors.reciprocity = medianReciprocityError(brdf, threads);
    for (const Vec3d& albedo : albedos)
        errors.albedoMax = std::max({errors.albedoMax, albedo.x, albedo.y, albedo.z});
    return errors;
}

std::map<std::string, double> named(const SampleErrors& errors)
{
    return {{"log_rms", errors.logRms},
            {"log_median", errors.logMedian},
            {"log_median_r", errors.logMedianChannel.x},
            {"log_median_g", errors.logMedianChannel.y},
            {"log_median_b", errors.logMedianChannel.z},
            {"cos_rms", errors.cosRms},
            {"cuberoot_rms", errors.cubeRootRms},
            {"nbrdf_loss", errors.nbrdfLoss}};
}

std::map<std::string, double> named(const ImageErrors& errors)
{
    return {{"psnr_linear", errors.psnrLinear},
            {"psnr_srgb", errors.psnrSrgb},
            {"ssim", errors.ssim},
            {"delta_e_itp", errors.deltaEItp},
            {"flip", errors.flip}};
}

std::map<std::string, double> named(const PhysicsErrors& errors)
{
    return {{"reciprocity", errors.reciprocity}, {"albedo_max", errors.albedoMax}};
}

}  // namespace fbrdf
