#include "PolarFigures.h"

#include "Html.h"
#include "Svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kWidth = 400, kHeight = 226, kCentreX = 200, kCentreY = 192, kRadius = 156;

// What the plots draw of a colour.
struct Series {
    const char* cssClass;
    const char* name;
    int channel;  ///< -1: the mean of R, G, B
};

double valueOf(const Series& series, const Vec3d& f)
{
    return series.channel < 0 ? (f.x + f.y + f.z) / 3.0 : f[series.channel];
}

// Grey when the channels differ by less than 3 % of the sum of what is drawn: three lines would be
// one.
std::vector<Series> seriesOf(const std::vector<PolarPanel>& panels)
{
    double difference = 0.0, sum = 0.0;
    for (const PolarPanel& panel : panels)
        for (const PolarPoint& p : panel.data) {
            difference += std::abs(p.f.x - p.f.y) + std::abs(p.f.z - p.f.y);
            sum += std::abs(p.f.y);
        }
    if (difference < 0.1 * sum) return {{"grey", "mean of R, G, B", -1}};
    return {{"red", "R", 0}, {"green", "G", 1}, {"blue", "B", 2}};
}

// Radius as a function of the value: decades from `low` (centre) to `high` (rim).
struct LogScale {
    double low = -1.0, high = 0.0;  ///< log10 of 1/sr

    double radius(double value) const
    {
        if (value <= 0.0) return 0.0;
        return kRadius * std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
    }
};

// The scale follows the data alone, so that a fit that runs away where nothing was measured does
// not shrink the data to a dot.
LogScale scaleOf(const std::vector<PolarPanel>& panels, const std::vector<Series>& series)
{
    constexpr double kMostDecades = 5.0;  // below lies what no picture shows
    constexpr double kLowest = 0.02;      // share of the values that may sink into the centre
    std::vector<double> values;
    for (const PolarPanel& panel : panels)
        for (const PolarPoint& p : panel.data)
            for (const Series& s : series)
                if (const double value = valueOf(s, p.f); value > 0.0 && std::isfinite(value))
                    values.push_back(value);
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const double least =
        values[static_cast<size_t>(kLowest * static_cast<double>(values.size() - 1))];
    const double high = std::log10(values.back()) + 0.15;
    // A decade more than the data needs, so that flat data is not all at the centre.
    return {std::clamp(std::log10(least) - 1.0, high - kMostDecades, high - 1.0), high};
}

Vec2<double> position(double theta_o, double radius)
{
    return {kCentreX + radius * std::sin(theta_o * kDegree),
            kCentreY - radius * std::cos(theta_o * kDegree)};
}

// Numbers too long to fit between two rings are written as powers of ten.
std::string decadeText(int decade)
{
    if (std::abs(decade) <= 2) return fmt::format("{:g}", std::pow(10.0, decade));
    return fmt::format("10<tspan class=\"sub\" dy=\"-4\">{}{}</tspan>",
                       decade < 0 ? "\xE2\x88\x92" : "", std::abs(decade));
}

std::string ringsOf(const LogScale& scale)
{
    std::string shapes;
    const auto half = [](double r) {
        return fmt::format(
            "<path class=\"grid\" d=\"M{:.1f} {:.1f}A{:.1f} {:.1f} 0 0 1 {:.1f} {:.1f}\"/>",
            kCentreX - r, kCentreY, r, r, kCentreX + r, kCentreY);
    };
    for (int decade = static_cast<int>(std::ceil(scale.low)); decade <= scale.high; ++decade) {
        const double r = scale.radius(std::pow(10.0, decade));
        if (r < 12.0) continue;
        if (r < kRadius - 6.0) shapes += half(r);  // the rim is drawn anyway
        shapes += svg::text(kCentreX + r, kCentreY + 14, "middle", decadeText(decade));
    }
    return shapes + half(kRadius);
}

std::string axesOf(const PolarPanel& panel, const LogScale& scale)
{
    std::string shapes = ringsOf(scale);
    for (const double angle : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
        const auto rim = position(angle, kRadius), label = position(angle, kRadius + 12);
        shapes += svg::line(kCentreX, kCentreY, rim.x, rim.y, "grid");
        shapes +=
            svg::text(label.x, label.y + 4, "middle", fmt::format("{:g}\xC2\xB0", std::abs(angle)));
    }
    shapes += svg::line(kCentreX - kRadius - 8, kCentreY, kCentreX + kRadius + 8, kCentreY, "axis");
    const auto light = position(-panel.theta_i, kRadius), mirror = position(panel.theta_i, kRadius);
    shapes += svg::line(light.x, light.y, kCentreX, kCentreY, "light");
    shapes += svg::circle(light.x, light.y, 4.5, "lamp");
    shapes += svg::line(kCentreX, kCentreY, mirror.x, mirror.y, "mirror");
    return shapes;
}

std::string curveOf(const std::vector<PolarPoint>& points, const Series& series,
                    const LogScale& scale, const char* kind)
{
    std::vector<Vec2<double>> positions;
    for (const PolarPoint& p : points)
        positions.push_back(position(p.theta_o, scale.radius(valueOf(series, p.f))));
    return svg::path(positions, std::string(kind) + " " + series.cssClass);
}

std::string dotsOf(const std::vector<PolarPoint>& points, const Series& series,
                   const LogScale& scale)
{
    const std::string cssClass = std::string("dot ") + series.cssClass;
    std::string shapes;
    for (const PolarPoint& p : points) {
        const auto at = position(p.theta_o, scale.radius(valueOf(series, p.f)));
        shapes += svg::circle(at.x, at.y, 2.6, cssClass.c_str());
    }
    return shapes;
}

std::string captionOf(const PolarPanel& panel, bool severalPlanes)
{
    std::string caption = fmt::format("Light at {:.3g}\xC2\xB0", panel.theta_i);
    if (severalPlanes)
        caption += panel.azimuth > 45.0 ? ", across the tangent" : ", along the tangent";
    if (panel.scattered)
        caption += fmt::format(
            ", {} samples{}", grouped(panel.samples),
            panel.samples > panel.data.size() ? fmt::format(" ({} shown)", panel.data.size()) : "");
    return caption;
}

std::string figureOf(const PolarPanel& panel, const std::vector<Series>& series,
                     const LogScale& scale, bool severalPlanes)
{
    std::string shapes = axesOf(panel, scale);
    // A curve of data is a wide band under the fit; dots lie upon it.
    for (const Series& s : series)
        if (!panel.scattered) shapes += curveOf(panel.data, s, scale, "data");
    for (const Series& s : series) shapes += curveOf(panel.fit, s, scale, "fit");
    for (const Series& s : series)
        if (panel.scattered) shapes += dotsOf(panel.data, s, scale);
    const std::string caption = captionOf(panel, severalPlanes);
    return element("figure", "",
                   svg::drawing(kWidth, kHeight, "Polar plot of data and fit. " + caption, shapes) +
                       element("figcaption", "", caption));
}

std::string swatch(const std::string& shapes, const std::string& label)
{
    return element("span", "class=\"key\"",
                   "<svg viewBox=\"0 0 26 12\" aria-hidden=\"true\">" + shapes + "</svg>" + label);
}

std::string legendOf(const std::vector<Series>& series, bool scattered)
{
    std::string keys = scattered ? swatch(svg::circle(13, 6, 3, "dot grey"), "data")
                                 : swatch(svg::path({{1, 6}, {25, 6}}, "data grey"), "data");
    keys += swatch(svg::path({{1, 6}, {25, 6}}, "fit grey"), "fit");
    if (series.size() > 1)
        for (const Series& s : series)
            keys += swatch(svg::path({{1, 6}, {25, 6}}, std::string("fit ") + s.cssClass), s.name);
    keys += swatch(svg::line(1, 6, 17, 6, "light") + svg::circle(20, 6, 4.5, "lamp"), "light");
    keys += swatch(svg::line(1, 6, 25, 6, "mirror"), "mirror direction");
    return element("p", "class=\"legend\"", keys);
}

}  // namespace

std::string polarFigures(const std::vector<PolarPanel>& panels)
{
    if (panels.empty()) return "";
    const std::vector<Series> series = seriesOf(panels);
    const LogScale scale = scaleOf(panels, series);
    const bool severalPlanes = std::any_of(panels.begin(), panels.end(),
                                           [](const PolarPanel& p) { return p.azimuth > 45.0; });
    std::string figures;
    for (const PolarPanel& panel : panels) figures += figureOf(panel, series, scale, severalPlanes);
    return legendOf(series, panels.front().scattered) + element("div", "class=\"pair\"", figures);
}

}  // namespace fbrdf
