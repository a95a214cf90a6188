// Derivation. Radiance is a sum of products of numbers >= 0 (signed tables have no bound), so
// relative errors behave:
//   a sum has at most the largest relative error of its terms; a product the sum of those of its
//   factors; and a total that k additions build up, each rounded by u, at most k u more, for
//   partial sums never exceed the total.
// A pass computes its value within kEvaluation, and within that of what it reads beside. Writing
// rounds: by u relative to the value (float formats), by one step (UNORM: GL asks for an integer
// next to the product). A multiplication carries the absolute error on, times a factor that UNORM
// clamps to 1.
// A code of an sRGB curve is 1.055 x^(1/2.4) - 0.055, so a relative error r of x <= 1 moves it by
// at most x dcode/dx r <= 1.055 / 2.4 r; the tone map, x (1 + x / 16) / (1 + x), does not raise r,
// as its elasticity 1 + x / (16 + x) - x / (1 + x) is at most 1.
// A pass that reads a UNORM surface scales its steps by its gain and by what its parts can be; a
// curve makes of an absolute error e at most its code of e, for it is steepest at 0.
// A recombined map changes a product by a factor of at most 2^e, wherever its factors are
// multiplied, and so a sum of products; a curve makes of that what it makes of r = 2^e - 1.
#include <fbrdf/plan/Plan.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

// Float geometry, texture coordinates, exp2 and pow of GL against double, where texels are filtered
// in float: 6.7e-6 measured on llvmpipe in tables of noise, steeper than any material's. The same
// formulas in float on the CPU are as far off: it is the cosine and the highlight's half vector.
constexpr double kEvaluation = 1e-5;
constexpr double kCurveSlope = 1.055 / 2.4;

// GL lets a float format cut off instead of round.
ErrorBound writing(ColourFormat format)
{
    switch (format) {
        case ColourFormat::rgba32f: return {0x1p-23, 0.0};
        case ColourFormat::rgba16f: return {0x1p-10, 0x1p-24};
        case ColourFormat::rgba16: return {0.0, 1.0 / 65535.0};
        case ColourFormat::rgba8:
        case ColourFormat::other: return {0.0, 1.0 / 255.0};
    }
    return {};
}

}  // namespace

ErrorBound errorBound(const Plan& plan, ColourFormat target, double recombination)
{
    const double replaced = std::exp2(recombination) - 1.0;
    bool curved = false;
    std::array<ErrorBound, 4> surfaces{};
    for (const Pass& pass : plan.passes) {
        ErrorBound& held = surfaces[static_cast<size_t>(pass.writes)];
        const ErrorBound rounding =
            writing(pass.writes == Surface::target ? target : plan.surfaces);
        ErrorBound value{kEvaluation, 0.0};
        if (pass.reads) {
            const ErrorBound& from = surfaces[static_cast<size_t>(*pass.reads)];
            value = {kEvaluation + from.relative, from.absolute * pass.gain * pass.largest};
        }
        if (isCurved(pass.transfer)) {
            curved = true;
            value = {0.0, kCurveSlope * (value.relative + replaced) + kEvaluation +
                              srgbFromLinear(std::min(1.0, value.absolute))};
        }
        if (pass.blend == Blend::replace) held = value;
        if (pass.blend == Blend::add)
            held = {std::max(held.relative, value.relative), held.absolute + value.absolute};
        if (pass.blend == Blend::multiply) held.relative += value.relative;
        held.relative += rounding.relative;
        held.absolute += rounding.absolute;
    }
    ErrorBound result = surfaces[static_cast<size_t>(Surface::target)];
    if (!curved) result.relative += replaced * (1.0 + result.relative);
    result.recombination = recombination;
    return result;
}

}  // namespace fbrdf
