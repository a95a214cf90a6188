#include <fbrdf/brdf/Half.h>

#include <cstring>

namespace fbrdf {
namespace {

uint32_t bitsOf(float value)
{
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

float floatOf(uint32_t bits)
{
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

constexpr uint32_t kOverflow = 0x477ff000;        // 65520: the first float that rounds to infinity
constexpr uint32_t kSmallestNormal = 0x38800000;  // 2^-14

}  // namespace

uint16_t halfFromFloat(float value)
{
    const uint32_t bits = bitsOf(value), sign = (bits >> 16) & 0x8000u;
    uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return static_cast<uint16_t>(sign | 0x7e00u);
    if (magnitude >= kOverflow) return static_cast<uint16_t>(sign | 0x7c00u);
    if (magnitude < kSmallestNormal)  // adding 1/2 leaves the subnormal, rounded by the hardware,
                                      // in the low bits
        return static_cast<uint16_t>(sign | (bitsOf(floatOf(magnitude) + 0.5f) - bitsOf(0.5f)));
    magnitude += 0xfffu + ((magnitude >> 13) & 1u);  // ties to even
    return static_cast<uint16_t>(sign | ((magnitude - ((127u - 15u) << 23)) >> 13));
}

float floatFromHalf(uint16_t half)
{
    const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16,
                   exponent = (half >> 10) & 0x1fu, mantissa = half & 0x3ffu;
    if (exponent == 0x1fu) return floatOf(sign | 0x7f800000u | (mantissa << 13));
    if (exponent != 0) return floatOf(sign | ((exponent + 127u - 15u) << 23) | (mantissa << 13));
    const float subnormal = static_cast<float>(mantissa) * 5.9604644775390625e-8f;  // 2^-24
    return sign ? -subnormal : subnormal;
}

}  // namespace fbrdf
