#include "PlanSimulator.h"

#include <fbrdf/brdf/Half.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fbrdf {
namespace {

// The content that another object left in an offscreen surface: no result may depend on it.
constexpr double kStale = 1e30;

const std::vector<double>& valuesOf(const SimulatedFragment& fragment, int term, int factor)
{
    return fragment.factor[static_cast<size_t>(term)][static_cast<size_t>(factor)];
}

double valueOf(const SimulatedFragment& fragment, int term, int factor, int light)
{
    const auto& values = valuesOf(fragment, term, factor);
    // .at throws for a wrong plan, whose pass reads the factor of a light without a light.
    return values.size() == 1 ? values[0] : values.at(static_cast<size_t>(light));
}

double partsOf(const Pass& pass, const SimulatedFragment& fragment, int light)
{
    double sum = 0.0;
    for (const Part& part : pass.parts) {
        double product = part.scaled ? simulatedScale(part.term) : 1.0;
        for (const int factor : part.factors)
            product *= valueOf(fragment, part.term, factor, light);
        sum += product;
    }
    return sum;
}

double valueOf(const Pass& pass, const SimulatedFragment& fragment)
{
    if (!pass.lit) return partsOf(pass, fragment, pass.lightCount > 0 ? pass.firstLight : -1);
    double sum = 0.0;
    for (int i = pass.firstLight; i < pass.firstLight + pass.lightCount; ++i)
        sum += partsOf(pass, fragment, i) * fragment.irradiance[static_cast<size_t>(i)];
    return sum;
}

/// The lobes of a share that one light lights. .at throws for a wrong plan, which adds a lobe that
/// there is not.
double lobesOf(const LobeShare& share, const std::vector<double>& lobes)
{
    double sum = share.cosine ? lobes.at(0) : 0.0;
    for (int k = 0; k < share.count; ++k) sum += lobes.at(static_cast<size_t>(1 + share.first + k));
    return sum;
}

double lobesOf(const Pass& pass, const SimulatedFragment& fragment)
{
    const LobeShare& share = pass.lobes;
    if (share.isEmpty()) return 0.0;
    double sum = share.environment ? lobesOf(share, fragment.lobes) : 0.0;
    for (int i = 0; i < share.areaCount; ++i)
        sum += lobesOf(share, fragment.areaLobes.at(static_cast<size_t>(share.firstArea + i)));
    return sum;
}

bool isUnorm(ColourFormat format)
{
    return format == ColourFormat::rgba8 || format == ColourFormat::rgba16;
}

double halfOf(double value, Store store)
{
    uint16_t half = halfFromFloat(static_cast<float>(value));
    const bool above = double(floatFromHalf(half)) > value;  // no value is negative here
    if (store != Store::nearest && above) --half;
    return double(floatFromHalf(half));
}

double stored(ColourFormat format, double value, Store store)
{
    if (format == ColourFormat::rgba16f) return halfOf(value, store);
    if (!isUnorm(format)) return value;
    const double steps = format == ColourFormat::rgba8 ? 255.0 : 65535.0,
                 code = steps * std::clamp(value, 0.0, 1.0);
    // What was stored already stays, whatever the division has rounded.
    return (store == Store::nearest ? std::round(code) : std::floor(code + 1e-9)) / steps;
}

double blended(Blend blend, double held, double value)
{
    switch (blend) {
        case Blend::replace: return value;
        case Blend::add: return held + value;
        case Blend::multiply: return held * value;
    }
    return kStale;
}

}  // namespace

double simulatedScale(int term)
{
    return 1.5 + term;
}

SimulatedFragment simulatedFragment(const Form& form, int lights, double depth, unsigned seed,
                                    int lobes, const LobeLight& light)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0.5, 2.0);
    SimulatedFragment fragment;
    fragment.depth = depth;
    for (const Term& term : form.terms) {
        fragment.factor.emplace_back();
        for (const Factor& factor : term.factors) {
            auto& values = fragment.factor.back().emplace_back();
            const int count = dependsOnLight(factor) ? lights : 1;
            for (int i = 0; i < count; ++i) values.push_back(value(random));
            // One light must not look like none: a second value makes the size differ from 1.
            if (dependsOnLight(factor) && lights == 1) values.push_back(kStale);
        }
    }
    for (int i = 0; i < lights; ++i) fragment.irradiance.push_back(value(random));
    const auto fill = [&](std::vector<double>& values) {
        for (int i = 0; i <= lobes; ++i) values.push_back(value(random));
    };
    if (light.environment && lobes > 0) fill(fragment.lobes);
    fragment.areaLobes.resize(static_cast<size_t>(light.areaLights));
    for (auto& values : fragment.areaLobes) fill(values);
    return fragment;
}

double expectedValue(const Form& form, const SimulatedFragment& fragment)
{
    double sum = 0.0;
    for (size_t light = 0; light < fragment.irradiance.size(); ++light)
        for (size_t t = 0; t < form.terms.size(); ++t) {
            double product = simulatedScale(static_cast<int>(t)) * fragment.irradiance[light];
            for (size_t k = 0; k < form.terms[t].factors.size(); ++k)
                product *= valueOf(fragment, static_cast<int>(t), static_cast<int>(k),
                                   static_cast<int>(light));
            sum += product;
        }
    for (const double lobe : fragment.lobes) sum += lobe;
    for (const auto& lobes : fragment.areaLobes)
        for (const double lobe : lobes) sum += lobe;
    return sum;
}

SimulatedPixel simulate(const Plan& plan, const std::vector<SimulatedFragment>& fragments,
                        SimulatedPixel target, ColourFormat format, Store store)
{
    double surface[4] = {target.value, kStale, kStale, kStale};
    double targetDepth = target.depth, offscreenDepth = 1.0;
    for (const Pass& pass : plan.passes) {
        double& depth = pass.writes == Surface::target ? targetDepth : offscreenDepth;
        for (const SimulatedFragment& fragment : fragments) {
            const bool passes =
                pass.depth == Depth::write ? fragment.depth < depth : fragment.depth == depth;
            if (!passes) continue;
            if (pass.depth == Depth::write) depth = fragment.depth;
            double value = valueOf(pass, fragment);
            if (pass.reads) value *= surface[static_cast<size_t>(*pass.reads)];
            value = (value + lobesOf(pass, fragment)) * pass.gain;
            if (isCurved(pass.transfer)) value = transferred(pass.transfer, 1.0, value);
            double& held = surface[static_cast<size_t>(pass.writes)];
            const ColourFormat into = pass.writes == Surface::target ? format : plan.surfaces;
            // A UNORM surface clamps what is blended as well.
            if (isUnorm(into)) value = std::clamp(value, 0.0, 1.0);
            if (store == Store::coarsest) value = stored(into, value, store);
            held = stored(into, blended(pass.blend, held, value), store);
        }
    }
    return {surface[0], targetDepth};
}

}  // namespace fbrdf
