#include "ErrorFigures.h"

#include "ColourMap.h"
#include "Html.h"
#include "Svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fbrdf {
namespace {

constexpr double kLeft = 44, kTop = 6, kPlot = 270;
constexpr double kBarLeft = kLeft + kPlot + 18, kBarWidth = 14;

// What a heat map shows of a bin; NaN leaves it hatched.
struct Quantity {
    const char* name;
    const char* unit;
    const char* caption;
    const char* patternId;
    std::function<double(const ErrorBin&)> value;
};

double positionOfThetaH(double degrees)
{
    return kLeft + kPlot * std::sqrt(degrees / 90.0);
}

// 1, 2 or 5 times a power of ten, at or above the value.
double niceAbove(double value)
{
    if (!(value > 0.0)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= value * (1.0 - 1e-9)) return step * power;
    return 10.0 * power;
}

// The end of the colour scale: all but the worst 2 % of the bins lie below, so that one bin does
// not darken the rest.
double scaleEnd(const ErrorBins& bins, const Quantity& quantity)
{
    constexpr double kShare = 0.98;
    std::vector<double> values;
    for (const ErrorBin& bin : bins.bins)
        if (const double v = quantity.value(bin); std::isfinite(v)) values.push_back(v);
    if (values.empty()) return 1.0;
    std::sort(values.begin(), values.end());
    return niceAbove(values[static_cast<size_t>(kShare * static_cast<double>(values.size() - 1))]);
}

std::string placeText(int h, int d)
{
    return fmt::format("theta_h {:.2g} to {:.2g}, theta_d {:g} to {:g} degrees", edgeOfThetaH(h),
                       edgeOfThetaH(h + 1), edgeOfThetaD(d), edgeOfThetaD(d + 1));
}

std::string cellsOf(const ErrorBins& bins, const Quantity& quantity, double end)
{
    const double step = kPlot / kErrorBins;
    std::string cells;
    for (int d = 0; d < kErrorBins; ++d)
        for (int h = 0; h < kErrorBins; ++h) {
            const ErrorBin& bin = bins.at(h, d);
            const double value = quantity.value(bin);
            if (std::isnan(value)) continue;
            // Half a unit wider than the step, so that there are no seams between neighbours.
            cells += fmt::format(
                "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                "fill=\"{}\"><title>{}: {}{}, {} "
                "samples</title></rect>",
                kLeft + h * step, kTop + (kErrorBins - 1 - d) * step, step + 0.5, step + 0.5,
                hexColour(viridis(value / end)), placeText(h, d), number(value), quantity.unit,
                grouped(bin.samples));
        }
    return cells;
}

std::string axesOf()
{
    std::string shapes;
    for (const double degrees : {0.0, 1.0, 5.0, 15.0, 30.0, 60.0, 90.0}) {
        const double x = positionOfThetaH(degrees);
        shapes += svg::line(x, kTop + kPlot, x, kTop + kPlot + 5, "axis");
        shapes += svg::text(x, kTop + kPlot + 18, "middle", fmt::format("{:g}\xC2\xB0", degrees));
    }
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
        const double y = kTop + kPlot * (1.0 - degrees / 90.0);
        shapes += svg::line(kLeft - 5, y, kLeft, y, "axis");
        shapes += svg::text(kLeft - 8, y + 4, "end", fmt::format("{:g}\xC2\xB0", degrees));
    }
    shapes += svg::text(kLeft + kPlot / 2, kTop + kPlot + 34, "middle",
                        svg::angleSymbol(Angle::theta_h), "label");
    return shapes +
           svg::text(2, kTop + kPlot / 2, "start", svg::angleSymbol(Angle::theta_d), "label");
}

std::string colourBar(double end, bool isClipped, const char* unit)
{
    constexpr int kSteps = 32;
    std::string shapes;
    for (int i = 0; i < kSteps; ++i)
        shapes += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{:.1f}\" height=\"{:.2f}\" fill=\"{}\"/>",
            kBarLeft, kTop + kPlot * (kSteps - 1 - i) / kSteps, kBarWidth, kPlot / kSteps + 0.4,
            hexColour(viridis((i + 0.5) / kSteps)));
    for (const double t : {0.0, 0.5, 1.0}) {
        const std::string prefix = t == 1.0 && isClipped ? "\xE2\x89\xA5 " : "";
        shapes += svg::text(kBarLeft + kBarWidth + 5,
                            kTop + kPlot * (1.0 - t) +
                                (t == 1.0   ? 10
                                 : t == 0.0 ? 0
                                            : 4),
                            "start", prefix + shortNumber(t * end) + unit);
    }
    return shapes;
}

// Draws the background of the plot, which stays visible where there was no sample.
std::string hatching(const char* id)
{
    return fmt::format(
        "<defs><pattern id=\"{}\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(45)\"><rect class=\"void\" width=\"7\" height=\"7\"/><line "
        "class=\"grid\" x1=\"0\" "
        "y1=\"0\" x2=\"0\" y2=\"7\"/></pattern></defs><rect x=\"{:.1f}\" y=\"{:.1f}\" "
        "width=\"{:.1f}\" "
        "height=\"{:.1f}\" fill=\"url(#{})\"/>",
        id, kLeft, kTop, kPlot, kPlot, id);
}

std::string figureOf(const ErrorBins& bins, const Quantity& quantity)
{
    const double end = scaleEnd(bins, quantity);
    const bool isClipped =
        std::any_of(bins.bins.begin(), bins.bins.end(),
                    [&](const ErrorBin& bin) { return quantity.value(bin) > end; });
    const std::string shapes = hatching(quantity.patternId) + cellsOf(bins, quantity, end) +
                               axesOf() + colourBar(end, isClipped, quantity.unit);
    return element(
        "figure", "",
        svg::drawing(kBarLeft + kBarWidth + 62, kTop + kPlot + 42,
                     std::string("Heat map of the ") + quantity.name + " by theta_h and theta_d",
                     shapes) +
            element("figcaption", "", quantity.caption));
}

using Places = std::pair<int, int>;

// Bin of the largest value among those with at least `fewest` samples; {-1, -1} when there is none.
Places worst(const ErrorBins& bins, size_t fewest,
             const std::function<double(const ErrorBin&)>& value)
{
    Places place{-1, -1};
    double largest = 0.0;
    for (int d = 0; d < kErrorBins; ++d)
        for (int h = 0; h < kErrorBins; ++h) {
            const double v = value(bins.at(h, d));
            if (bins.at(h, d).samples < fewest || !(v > largest)) continue;
            largest = v;
            place = {h, d};
        }
    return place;
}

// A median of one or two samples means little, so bins with more are preferred where there are any.
size_t fewestForMedian(const ErrorBins& bins)
{
    size_t samples = 0;
    for (const ErrorBin& bin : bins.bins) samples += bin.samples;
    return std::clamp<size_t>(samples / 1000, 1, 5);
}

std::string placeMarkup(const Places& place)
{
    return fmt::format(
        "\xCE\xB8<sub>h</sub> {:.2g}\xE2\x80\x93{:.2g}\xC2\xB0, \xCE\xB8<sub>d</sub> "
        "{:g}\xE2\x80\x93{:g}\xC2\xB0",
        edgeOfThetaH(place.first), edgeOfThetaH(place.first + 1), edgeOfThetaD(place.second),
        edgeOfThetaD(place.second + 1));
}

}  // namespace

std::string errorFigures(const ErrorBins& bins)
{
    const Quantity median{"median log error", "",
                          "Median |ln g/f| above the noise floor (0.1 is about 10\xC2\xA0%).",
                          "void-median", [](const ErrorBin& bin) { return bin.median; }};
    const Quantity share{
        "share of the squared error", " %",
        "Share of the squared cosine-weighted error, in percent of the whole.", "void-share",
        [](const ErrorBin& bin) { return bin.samples > 0 ? 100.0 * bin.share : std::nan(""); }};
    return element("div", "class=\"pair\"", figureOf(bins, median) + figureOf(bins, share));
}

std::string weakestPlaces(const ErrorBins& bins)
{
    std::string sentences;
    const Places relative =
        worst(bins, fewestForMedian(bins), [](const ErrorBin& bin) { return bin.median; });
    if (relative.first >= 0) {
        const ErrorBin& bin = bins.at(relative.first, relative.second);
        sentences +=
            fmt::format("The relative error is largest at {}: median |ln g/f| {} (samples: {}). ",
                        placeMarkup(relative), number(bin.median), grouped(bin.samples));
    }
    const Places absolute = worst(bins, 1, [](const ErrorBin& bin) { return bin.share; });
    if (absolute.first >= 0) {
        const ErrorBin& bin = bins.at(absolute.first, absolute.second);
        sentences += fmt::format("Of the squared error, {} % lies at {}.",
                                 number(100.0 * bin.share), placeMarkup(absolute));
    }
    return sentences.empty() ? "" : element("p", "", sentences);
}

}  // namespace fbrdf
