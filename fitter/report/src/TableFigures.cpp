#include "TableFigures.h"

#include "Html.h"
#include "Svg.h"

#include <fbrdf/base/Srgb.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

template <class Visit>
void forEachReachedTexel(const Table& table, const Visit& visit)
{
    const auto size = domainSize(table.domain);
    for (int z = 0; z < size[2]; ++z)
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x)
                if (const int index = (z * size[1] + y) * size[0] + x;
                    isReachable(table.domain, index))
                    visit(x, y, z, index);
}

double shown(const Table& table, const ShownRange& range, int index, int channel)
{
    const auto value = static_cast<double>(table.texel(index, channel));
    if (table.storage == Storage::linear8) return srgbFromLinear(value);
    return range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5;
}

// Where a degree lies along an axis, in texels.
double texelOfDegrees(const Axis& axis, double degrees)
{
    const double angle = degrees * kPi / 180.0, half = std::sin(0.5 * angle);
    return axisCoordinate(axis.map, std::max(0.0, std::cos(angle)), 2.0 * half * half) *
           (axis.size - 1);
}

// Degrees to label along an axis of `length` units, no two closer than `apart`.
std::vector<std::pair<double, double>> ticksOf(const Axis& axis, double length, double apart)
{
    std::vector<std::pair<double, double>> ticks;  // degrees, position
    for (const double degrees : {0.0, 90.0, 45.0, 30.0, 60.0, 15.0, 75.0, 5.0, 10.0, 20.0}) {
        const double at = (texelOfDegrees(axis, degrees) + 0.5) / axis.size * length;
        if (std::all_of(ticks.begin(), ticks.end(),
                        [&](const auto& t) { return std::abs(t.second - at) >= apart; }))
            ticks.emplace_back(degrees, at);
    }
    return ticks;
}

// The angles that a grid table is looked up with, from the first factor that uses it.
std::vector<Angle> anglesOf(const Form& form, size_t table)
{
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors)
            if (static_cast<size_t>(factor.table) == table)
                if (const auto* angles = std::get_if<std::vector<Angle>>(&factor.argument))
                    return *angles;
    return {};
}

std::string degreesText(double degrees)
{
    return fmt::format("{:g}\xC2\xB0", degrees);
}

bool isUnsupported(const Table& table, int index)
{
    return !table.unsupported.empty() && table.unsupported[static_cast<size_t>(index)];
}

// A stroke across every texel that no sample supports, over the picture of the table.
std::string hatching(const Table& table, double left, double top, double width, double height)
{
    const auto size = domainSize(table.domain);
    const Vec2<double> texel(width / size[0], height / (size[1] * size[2]));
    std::vector<Vec2<double>> corners;
    forEachReachedTexel(table, [&](int x, int y, int z, int index) {
        if (isUnsupported(table, index))
            corners.emplace_back(left + x * texel.x, top + (z * size[1] + y + 1) * texel.y);
    });
    return svg::strokes(corners, {texel.x, -texel.y}, "hatch");
}

std::string discDrawing(const Table& table, const DiscDomain& disc, const std::string& label)
{
    constexpr double kSide = 200;
    const double texel = kSide / disc.size, centre = 0.5 * kSide;
    std::string shapes =
        svg::image(0, 0, kSide, kSide, dataUri(pictureOf(table, shownRange(table)))) +
        hatching(table, 0, 0, kSide, kSide);
    for (const double degrees : {15.0, 45.0, 90.0}) {
        const Vec3d direction(std::sin(degrees * kPi / 180.0), 0.0,
                              std::max(0.0, std::cos(degrees * kPi / 180.0)));
        const double radius = discPosition(disc, direction).x * texel + 0.5 * texel - centre;
        shapes += svg::circle(centre, centre, radius, "ring");
        const double height = centre - radius * 0.7071;
        shapes += svg::text(centre + radius * 0.7071 + 2, height, "start", degreesText(degrees),
                            "tick halo");
    }
    return svg::drawing(kSide + 24, kSide, label, shapes);
}

std::string gridDrawing(const Table& table, const GridDomain& grid,
                        const std::vector<Angle>& angles, const std::string& label)
{
    const Picture picture = pictureOf(table, shownRange(table));
    const double width = 300, left = 54;
    const double slice = std::clamp(width * grid.axes[1].size / grid.axes[0].size, 90.0, width);
    const double height = slice * picture.height / grid.axes[1].size;
    std::string shapes = svg::image(left, 4, width, height, dataUri(picture)) +
                         hatching(table, left, 4, width, height);
    for (const auto& [degrees, at] : ticksOf(grid.axes[0], width, 26.0)) {
        shapes += svg::line(left + at, height + 4, left + at, height + 8, "axis");
        shapes += svg::text(left + at, height + 20, "middle", degreesText(degrees));
    }
    for (const auto& [degrees, at] : ticksOf(grid.axes[1], slice, 14.0)) {
        shapes += svg::line(left - 4, 4 + at, left, 4 + at, "axis");
        shapes += svg::text(left - 6, 8 + at, "end", degreesText(degrees));
    }
    if (angles.size() >= 2) {
        shapes += svg::text(left + width / 2, height + 36, "middle", svg::angleSymbol(angles[0]),
                            "label");
        shapes += svg::text(2, 8 + slice / 2, "start", svg::angleSymbol(angles[1]), "label");
    }
    return svg::drawing(left + width + 14, height + 42, label, shapes);
}

std::string curveDrawing(const Table& table, const Axis& axis, const std::vector<Angle>& angles,
                         const std::string& label)
{
    constexpr double kCurveWidth = 300, kCurveHeight = 150, kCurveLeft = 54, kCurveTop = 8;
    const ShownRange range = shownRange(table);
    const auto y = [&](double value) {
        const double span = std::max(1e-6, range.high - range.low);
        return kCurveTop + kCurveHeight * (1.0 - (value - range.low) / span);
    };
    std::string shapes;
    for (const double value : {range.low, 0.5 * (range.low + range.high), range.high}) {
        shapes += svg::line(kCurveLeft, y(value), kCurveLeft + kCurveWidth, y(value), "grid");
        shapes += svg::text(kCurveLeft - 6, y(value) + 4, "end", shortNumber(value));
    }
    for (const double degrees : {0.0, 30.0, 60.0, 90.0})
        shapes += svg::text(kCurveLeft + kCurveWidth * degrees / 90.0,
                            kCurveTop + kCurveHeight + 16, "middle", degreesText(degrees));
    const auto x = [&](int knot) {
        const double u = axis.size > 1 ? static_cast<double>(knot) / (axis.size - 1) : 0.0;
        return kCurveLeft + kCurveWidth * angleFromAxisCoordinate(axis.map, u) / (0.5 * kPi);
    };
    std::vector<Vec2<double>> unsupported;
    for (int i = 0; i < axis.size; ++i)
        if (isUnsupported(table, i)) unsupported.emplace_back(x(i), kCurveTop);
    shapes += svg::strokes(unsupported, {0.0, kCurveHeight}, "hatch");
    const char* const channelClass[] = {"fit red", "fit green", "fit blue"};
    for (int c = 0; c < table.channels; ++c) {
        std::vector<Vec2<double>> points;
        for (int i = 0; i < axis.size; ++i)
            points.emplace_back(x(i), y(static_cast<double>(table.texel(i, c))));
        shapes += svg::path(points, table.channels == 1 ? "fit grey" : channelClass[c]);
    }
    if (!angles.empty())
        shapes += svg::text(kCurveLeft + kCurveWidth / 2, kCurveTop + kCurveHeight + 32, "middle",
                            svg::angleSymbol(angles[0]), "label");
    return svg::drawing(kCurveLeft + kCurveWidth + 14, kCurveTop + kCurveHeight + 38, label,
                        shapes);
}

std::string sizeText(const Domain& domain)
{
    const auto size = domainSize(domain);
    std::string text = std::to_string(size[0]);
    for (size_t i = 1; i < 3; ++i)
        if (size[i] > 1) text += "\xC3\x97" + std::to_string(size[i]);
    return text;
}

std::string captionOf(const Table& table)
{
    const ShownRange range = shownRange(table);
    const std::string what = isLog(table.storage)                   ? "log<sub>2</sub> F"
                             : table.storage == Storage::signedHalf ? "F, of either sign"
                                                                    : "F, sRGB-encoded";
    const bool isCurve = dimensionCount(table.domain) == 1;
    const std::string scale =
        isCurve
            ? what + fmt::format(" from {} to {}", shortNumber(range.low), shortNumber(range.high))
            : what + fmt::format(" from {} (black) to {} (white)", shortNumber(range.low),
                                 shortNumber(range.high));
    const size_t guessed = table.unsupportedCount();
    const std::string support =
        guessed == 0 ? ""
                     : fmt::format(" {} supported by no sample: {}.", grouped(guessed),
                                   isCurve ? "upright lines" : "hatched");
    return element("b", "", escaped(table.name)) +
           fmt::format(" &#8212; {} texels, {}, {}, {} bytes. {}.", sizeText(table.domain),
                       table.channels == 1 ? "one channel" : "R, G, B", storageName(table.storage),
                       grouped(table.bytes()), scale) +
           support;
}

std::string drawingOf(const Material& material, size_t index)
{
    const Table& table = material.tables[index];
    const std::string label = "Map " + table.name;
    if (const auto* disc = std::get_if<DiscDomain>(&table.domain))
        return discDrawing(table, *disc, label);
    const auto& grid = std::get<GridDomain>(table.domain);
    const std::vector<Angle> angles = anglesOf(material.form, index);
    if (grid.axes.size() == 1) return curveDrawing(table, grid.axes[0], angles, label);
    return gridDrawing(table, grid, angles, label);
}

}  // namespace

ShownRange shownRange(const Table& table)
{
    if (table.storage == Storage::linear8) return {0.0, 1.0};
    std::vector<double> values;
    forEachReachedTexel(table, [&](int, int, int, int index) {
        for (int c = 0; c < table.channels; ++c)
            values.push_back(static_cast<double>(table.texel(index, c)));
    });
    std::sort(values.begin(), values.end());
    if (table.storage == Storage::signedHalf) {
        const double most = std::max(-values.front(), values.back());
        return {-most, most};
    }
    const bool isCurve = dimensionCount(table.domain) == 1;
    const double last = static_cast<double>(values.size() - 1);
    const auto outside = isCurve ? size_t{0} : static_cast<size_t>(kClipped * last);
    return {values[outside], values[values.size() - 1 - outside]};
}

Picture pictureOf(const Table& table, const ShownRange& range)
{
    const auto size = domainSize(table.domain);
    Picture picture(size[0], size[1] * size[2]);
    forEachReachedTexel(table, [&](int x, int y, int z, int index) {
        const auto value = [&](int c) { return shown(table, range, index, c); };
        picture.set(x, z * size[1] + y, {value(0), value(1), value(2)});
    });
    return picture;
}

std::string tableFigures(const Material& material)
{
    std::string figures;
    for (size_t i = 0; i < material.tables.size(); ++i)
        figures += element(
            "figure", isDisc(material.tables[i].domain) ? "class=\"disc\"" : "",
            drawingOf(material, i) + element("figcaption", "", captionOf(material.tables[i])));
    return element("div", "class=\"maps\"", figures);
}

}  // namespace fbrdf
