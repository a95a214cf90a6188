// Srgb.h - the transfer function of sRGB, IEC 61966-2-1:1999, and its inverse.
#pragma once
#include <algorithm>
#include <cmath>

namespace fbrdf {

/// Encoded value in [0, 1] of a linear one in [0, 1]. Values outside are clamped, NaN remains.
template <class T>
T srgbFromLinear(T linear)
{
    const T x = std::clamp(linear, T(0), T(1));
    return x <= T(0.0031308) ? T(12.92) * x : T(1.055) * std::pow(x, T(1) / T(2.4)) - T(0.055);
}

/// Linear value in [0, 1] of an encoded one in [0, 1]. Values outside are clamped, NaN remains.
template <class T>
T linearFromSrgb(T encoded)
{
    const T x = std::clamp(encoded, T(0), T(1));
    return x <= T(0.04045) ? x / T(12.92) : std::pow((x + T(0.055)) / T(1.055), T(2.4));
}

}  // namespace fbrdf
