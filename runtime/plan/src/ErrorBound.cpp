// Derivation. Radiance is a sum of products of numbers >= 0 (signed tables have no bound), so
// relative errors behave:
//   a sum has at most the largest relative error of its terms; a product the sum of those of its
//   factors; and a total that k additions build up, each rounded by u, at most k u more, for
//   partial sums never exceed the total.
// A pass computes its value with a relative error of kEvaluation and that of one exp2, to which the
// error of the surface that it reads adds. Writing and blending round by so many units in the last
// place as the context was seen to, or as OpenGL grants (StoreRounding): relative to the value
// (float formats), or steps (UNORM). A multiplication carries the absolute error on, times a factor
// that UNORM clamps to 1.
// The mean of the samples of a surface is stored once more before it is read. Dividing it by the
// share of those that were drawn to also divides what fixed point has rounded, so the surfaces of
// such a plan are floats.
// A code of an sRGB curve is 1.055 x^(1/2.4) - 0.055, so a relative error r of x <= 1 moves it by
// at most x dcode/dx r <= 1.055 / 2.4 r; the tone map, x (1 + x / 16) / (1 + x), does not raise r,
// as its elasticity 1 + x / (16 + x) - x / (1 + x) is at most 1.
// A pass that reads a UNORM surface scales the steps of that surface by its gain and by the largest
// value of its parts. A curve turns an absolute error e into at most the code of e, for it is
// steepest at 0.
// A recombined map, or one that is filtered coarsely, changes a product by a factor of at most 2^e,
// wherever its factors are multiplied, and so a sum of products: that is a relative error of
// r = 2^e - 1. What filtering does to maps that are not logarithmic is an absolute error of the
// sum, which nothing of the plan changes but the curve.
#include <fbrdf/plan/Plan.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

// The error of float geometry, texture coordinates and pow of GL against double, without that of
// filtering (MapErrors). With tables of noise, which are steeper than those of any material, 6.7e-6
// was measured on llvmpipe, and 2.4e-5 with roots that are off by what GLSL grants them. The same
// formulas in float on the CPU are as far off as the former; the cosine and the half vector in a
// highlight cause most of it.
constexpr double kEvaluation = 3e-5;
constexpr double kCurveSlope = 1.055 / 2.4;

// GLSL 4.60, 4.7.1 grants exp2(x) an error of (3 + 2 |x|) units in the last place; llvmpipe, where
// kEvaluation was measured, needs less than one.
double exponentialError(const MapErrors& maps)
{
    return (3.0 + 2.0 * maps.exponent) * 0x1p-23;
}

StoreUnit unitOf(ColourFormat format, const StoreUnit& other)
{
    switch (format) {
        case ColourFormat::rgba32f: return {0x1p-23, 0.0};
        case ColourFormat::rgba16f: return {0x1p-10, 0x1p-24};
        case ColourFormat::rgba16: return {0.0, 1.0 / 65535.0};
        case ColourFormat::rgba8: return {0.0, 1.0 / 255.0};
        case ColourFormat::other: return other;
    }
    return other;
}

// Blending reads what was stored and may convert what is added, so that both may be taken for 0.
ErrorBound storing(ColourFormat format, Blend blend, const StoreRoundings& roundings,
                   const StoreUnit& other)
{
    const StoreRounding& rounding = roundings[static_cast<size_t>(format)];
    const double units = blend == Blend::replace ? rounding.write : rounding.blend;
    const StoreUnit unit = unitOf(format, other);
    const double tiny = format == ColourFormat::rgba16f ? rounding.tiny : 0.0;
    return {units * unit.relative,
            std::max(units * unit.absolute, blend == Blend::replace ? tiny : 2.0 * tiny)};
}

}  // namespace

double sumTolerance(ColourFormat target, const StoreUnit& other)
{
    const StoreUnit unit = unitOf(target, other);
    return unit.relative > 0.0 ? 0.0 : 0.5 * unit.absolute;
}

ErrorBound errorBound(const Plan& plan, ColourFormat target, const MapErrors& maps,
                      const StoreRoundings& roundings, const StoreUnit& other)
{
    const double evaluation = kEvaluation + exponentialError(maps);
    const double replaced = std::exp2(maps.recombination + maps.filtering) - 1.0;
    bool curved = false;
    std::array<ErrorBound, 4> surfaces{};
    for (const Pass& pass : plan.passes) {
        ErrorBound& content = surfaces[static_cast<size_t>(pass.writes)];
        const ErrorBound rounding = storing(pass.writes == Surface::target ? target : plan.surfaces,
                                            pass.blend, roundings, other);
        ErrorBound value{evaluation, 0.0};
        if (pass.reads) {
            ErrorBound from = surfaces[static_cast<size_t>(*pass.reads)];
            if (plan.resolves) {
                const ErrorBound mean = storing(plan.surfaces, Blend::replace, roundings, other);
                from.relative += mean.relative;
                from.absolute += mean.absolute;
            }
            value = {evaluation + from.relative, from.absolute * pass.gain * pass.largest};
        }
        if (isCurved(pass.transfer)) {
            curved = true;
            value = {0.0, kCurveSlope * (value.relative + replaced) + kEvaluation +
                              srgbFromLinear(std::min(1.0, value.absolute + maps.absolute))};
        }
        if (pass.blend == Blend::replace) content = value;
        if (pass.blend == Blend::add)
            content = {std::max(content.relative, value.relative),
                       content.absolute + value.absolute};
        if (pass.blend == Blend::multiply) content.relative += value.relative;
        content.relative += rounding.relative;
        content.absolute += rounding.absolute;
    }
    ErrorBound result = surfaces[static_cast<size_t>(Surface::target)];
    if (!curved) {
        result.relative += replaced * (1.0 + result.relative);
        result.absolute += maps.absolute;
    }
    result.maps = maps;
    return result;
}

}  // namespace fbrdf
