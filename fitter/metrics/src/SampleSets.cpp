#include <fbrdf/base/Parallel.h>

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/metrics/Sobol.h>

#include <cmath>

namespace fbrdf {
namespace {

Vec3d cosineDirection(double u, double v)
{
    return directionFromAngles(std::asin(std::sqrt(u)), 2.0 * kPi * v);
}

DirectionPair<double> cosinePair(const std::array<double, 4>& u)
{
    return {cosineDirection(u[0], u[1]), cosineDirection(u[2], u[3])};
}

DirectionPair<double> halfDifferencePair(const std::array<double, 4>& u)
{
    const double theta_h = 0.5 * kPi * u[0] * u[0];  // sqrt theta_h is uniform
    return pairFromHalfDifference({theta_h, 2.0 * kPi * u[2], 0.5 * kPi * u[1], 2.0 * kPi * u[3]});
}

template <class MakePair>
void append(std::vector<DirectionPair<double>>& pairs, size_t count, uint64_t seed,
            MakePair makePair)
{
    const double lowest = std::sin(kMinElevation);
    uint32_t index = 0;
    for (size_t added = 0; added < count; ++index) {
        const DirectionPair<double> pair = makePair(sobolPoint(index, seed));
        if (pair.wo.z <= lowest || pair.wi.z <= lowest) continue;
        pairs.push_back(pair);
        ++added;
    }
}

}  // namespace

std::vector<DirectionPair<double>> uniformPairs(size_t count, uint64_t seed)
{
    std::vector<DirectionPair<double>> pairs;
    pairs.reserve(count);
    append(pairs, count / 2, seed, cosinePair);
    append(pairs, count - count / 2, seed, halfDifferencePair);
    return pairs;
}

std::vector<Sample> samplesAt(const Source& source, const std::vector<DirectionPair<double>>& pairs,
                              int threads)
{
    std::vector<Sample> samples(pairs.size());
    parallelFor(pairs.size(), threads, [&](size_t i) {
        samples[i] = {Vec3f(pairs[i].wo), Vec3f(pairs[i].wi),
                      Vec3f(source.evaluate(pairs[i].wo, pairs[i].wi)), 1.0f};
    });
    return samples;
}

}  // namespace fbrdf
