#include "search/Restrained.h"

#include "data/Symmetry.h"
#include "search/SeenErrors.h"

#include <cmath>
#include <utility>

namespace fbrdf {
namespace {

constexpr int kRounds = 2;
constexpr double kLeastStray = 0.01;  // no one sees what strays by a hundredth in the mean

Restrained measured(const FitContext& context, const Stray& stray, Fitted fitted)
{
    const int threads = context.options.threads;
    const auto probe = probeOf(context);
    const auto valuesAt = [&](const std::vector<Sample>& samples) {
        return evaluateAt(fitted.material, samples, threads);
    };
    const auto values = valuesAt(probe);
    Restrained result;
    result.all = sampleErrors(probe, values, context.statistics.floor);
    result.allMark = markOf(probe, context.turnsHeldOut ? valuesAt(turned(probe)) : values,
                            context.statistics.floor, context.options.metric);
    result.stray = stray.of(fitted.material, threads);
    result.fitted = std::move(fitted);
    return result;
}

double sumOf(const Stray::Mean& stray)
{
    return stray.hue + stray.brightness;
}

// Errors on samples may grow by a tenth, and by twice what is invented less.
bool isWorthIt(const Restrained& next, const Restrained& best)
{
    constexpr double kGrowth = 0.1, kWorth = 2.0;
    const double less = sumOf(best.stray) - sumOf(next.stray);
    return less > 0.0 && std::log(mostAbove(next.all, best.all)) <= kGrowth + kWorth * less;
}

}  // namespace

double Restrained::mark() const
{
    return 0.5 * allMark + 2.0 * inventedHue;
}

Restrained fitRestrained(const FitContext& context, const Form& form, const Stray& stray)
{
    Restrained best = measured(context, stray, fitForm(context, form));
    const double inventedHue = best.stray.hue;
    std::vector<Sample> restraints;
    Material last = best.fitted.material;
    for (int round = 0; round < kRounds && sumOf(best.stray) > kLeastStray; ++round) {
        const auto more = stray.restraints(last, context.options.threads);
        restraints.insert(restraints.end(), more.begin(), more.end());
        Restrained next = measured(context, stray, fitFormBeside(context, form, restraints));
        last = next.fitted.material;
        if (isWorthIt(next, best)) best = std::move(next);
    }
    best.inventedHue = inventedHue;
    return best;
}

}  // namespace fbrdf
