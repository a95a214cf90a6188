#include <fbrdf/metrics/Sobol.h>

#include <fbrdf/base/SplitMix.h>

namespace fbrdf {
namespace {

constexpr int kBits = 32;
using Directions = std::array<uint32_t, kBits>;

// Joe and Kuo's rows for dimensions 2 to 4: degree s, coefficients a, initial numbers m.
struct Polynomial {
    uint32_t degree, coefficients;
    std::array<uint32_t, 3> initial;
};
constexpr std::array<Polynomial, 3> kPolynomials{
    {{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};

Directions directionsOf(const Polynomial& p)
{
    Directions v{};
    for (uint32_t i = 0; i < kBits; ++i) {
        if (i < p.degree) {
            v[i] = p.initial[i] << (kBits - 1 - i);
            continue;
        }
        v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
        for (uint32_t k = 1; k < p.degree; ++k)
            if ((p.coefficients >> (p.degree - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

std::array<Directions, 4> makeDirections()
{
    std::array<Directions, 4> all{};
    for (uint32_t i = 0; i < kBits; ++i) all[0][i] = 1u << (kBits - 1 - i);
    for (std::size_t d = 0; d < kPolynomials.size(); ++d)
        all[d + 1] = directionsOf(kPolynomials[d]);
    return all;
}

}  // namespace

std::array<double, 4> sobolPoint(uint32_t index, uint64_t seed)
{
    static const std::array<Directions, 4> directions = makeDirections();
    std::array<double, 4> point{};
    for (std::size_t d = 0; d < point.size(); ++d) {
        uint32_t digits = 0;
        for (uint32_t i = 0, bits = index; bits != 0; ++i, bits >>= 1)
            digits ^= directions[d][i] & (0u - (bits & 1u));  // no branch: bits are as if at random
        if (seed != 0) digits ^= static_cast<uint32_t>(splitMix64(seed * 4 + d) >> 32);
        point[d] = (static_cast<double>(digits) + 0.5) / 4294967296.0;
    }
    return point;
}

}  // namespace fbrdf
