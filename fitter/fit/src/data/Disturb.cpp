#include <fbrdf/fit/Disturb.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fbrdf {
namespace {

// The standard library's distributions differ between implementations: these do not.
class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}

    /// A number in [0, 1) of 53 bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    /// Box and Muller 1958.
    double normal()
    {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * kPi * uniform());
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace

std::vector<Sample> withNoise(std::vector<Sample> samples, const Noise& noise, uint64_t seed)
{
    FBRDF_ASSERT(noise.zeroed + noise.spiked, <=, 1.0);
    Random random(seed);
    for (Sample& s : samples) {
        const double additive = noise.absolute / static_cast<double>(s.wi.z);
        for (int c = 0; c < 3; ++c) {
            const double factor = 1.0 + noise.relative * random.normal();
            s.f[c] = static_cast<float>(static_cast<double>(s.f[c]) * factor +
                                        additive * random.normal());
        }
        const double luck = random.uniform();
        if (luck < noise.zeroed)
            s.f = Vec3f(0.0f);
        else if (luck < noise.zeroed + noise.spiked)
            s.f *= static_cast<float>(noise.spike);
    }
    return samples;
}

std::vector<Sample> randomPart(const std::vector<Sample>& samples, size_t count, uint64_t seed)
{
    // Knuth 1997, Algorithm 3.4.2 S: each of the rest with what is still wanted over what is left.
    Random random(seed);
    std::vector<Sample> part;
    for (size_t i = 0; i < samples.size() && part.size() < count; ++i) {
        const auto wanted = static_cast<double>(count - part.size());
        if (random.uniform() * static_cast<double>(samples.size() - i) < wanted)
            part.push_back(samples[i]);
    }
    return part;
}

}  // namespace fbrdf
