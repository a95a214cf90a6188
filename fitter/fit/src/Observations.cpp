#include "LeastSquares.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Folds are dealt like cards after a shuffle by hash: equal sizes, no pattern of the measurement
// survives.
uint64_t hashed(uint64_t index, uint64_t seed)
{
    uint64_t x = index * 0x9e3779b97f4a7c15u + seed * 0xbf58476d1ce4e5b9u + 1;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}  // namespace

Observations observe(std::vector<Sample> samples, const Vec3f& floor, uint64_t seed)
{
    Observations o;
    o.samples = std::move(samples);
    o.floor = floor;
    const size_t count = o.samples.size();
    o.logValue.resize(count);
    o.weight.resize(count);
    o.censored.assign(count, 0);
    o.fold.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const Sample& s = o.samples[i];
        bool any = false;
        for (int c = 0; c < 3; ++c) {
            const float f = s.f[c], sigma = floor[c];
            const bool above = f > 0.0f && f > 0.5f * sigma;
            // Without an estimate of the floor a zero says nothing about how small f is.
            const bool isCensored = !above && sigma > 0.0f;
            o.logValue[i][c] = above ? std::log2(f) : isCensored ? std::log2(sigma) : 0.0f;
            o.weight[i][c] = above        ? s.weight * f * f / (f * f + sigma * sigma)
                             : isCensored ? 0.5f * s.weight
                                          : 0.0f;
            if (isCensored) o.censored[i] |= static_cast<uint8_t>(1 << c);
            o.belowFloor += above ? 0 : 1;
            any = any || above;
        }
        o.used += any ? 1 : 0;
        o.fold[i] = static_cast<uint8_t>(hashed(i, seed) % kFolds);
    }
    if (o.used == 0)
        throw Error(ErrorKind::fit, "samples",
                    "found " + std::to_string(count) +
                        " samples, none with a value above the noise floor; expected some");
    return o;
}

}  // namespace fbrdf
