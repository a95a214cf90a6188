// Transfer.h - what becomes of radiance on its way into the target. Pure; the GLSL twins are in
// transfer.glsl.
//
// The encoding is done by the last pass of an object, never by the hardware: what is stored is the
// same whether the buffer is RGBA8, SRGB8_ALPHA8 or float, and whatever the host left in
// FRAMEBUFFER_SRGB.
#pragma once
#include <fbrdf/base/Srgb.h>
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>

namespace fbrdf {

/// x is exposure times radiance.
enum class Transfer {
    linear,    ///< radiance; the exposure is not used
    exposure,  ///< x, linear: for a host that tone-maps by itself
    srgb,      ///< the sRGB code of x clamped to [0, 1] (IEC 61966-2-1:1999)
    toneMap,   ///< the sRGB code of toneMapped(x)
};

/// True where several passes may not add up after the transfer.
constexpr bool isCurved(Transfer transfer)
{
    return transfer == Transfer::srgb || transfer == Transfer::toneMap;
}

/// Reinhard, Stark, Shirley, Ferwerda 2002, "Photographic Tone Reproduction for Digital Images",
/// Eq. 4, on each channel, with 4 as the smallest value that becomes white; below 0 (of materials
/// with signs) it is 0.
template <class T>
T toneMapped(T radiance)
{
    const T x = std::clamp(radiance, T(0), T(4));  // white, also where radiance is infinite
    return x * (T(1) + x / T(16)) / (T(1) + x);
}

/// One channel of radiance >= 0 as it is stored.
template <class T>
T transferred(Transfer transfer, T exposure, T radiance)
{
    if (transfer == Transfer::linear) return radiance;
    const T x = exposure * radiance;
    if (transfer == Transfer::srgb) return srgbFromLinear(x);
    return transfer == Transfer::toneMap ? srgbFromLinear(toneMapped(x)) : x;
}

}  // namespace fbrdf
