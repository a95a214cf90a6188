#include "Svg.h"

#include "Html.h"

#include <fmt/format.h>

namespace fbrdf::svg {

std::string drawing(double width, double height, const std::string& label,
                    const std::string& shapes)
{
    return fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">{}</svg>\n",
                       width, height, escaped(label), shapes);
}

std::string line(double x1, double y1, double x2, double y2, const char* cssClass)
{
    return fmt::format(
        "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", cssClass,
        x1, y1, x2, y2);
}

std::string circle(double x, double y, double radius, const char* cssClass)
{
    return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", cssClass,
                       x, y, radius);
}

std::string text(double x, double y, const char* anchor, const std::string& content,
                 const char* cssClass)
{
    return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>",
                       cssClass, x, y, anchor, content);
}

std::string path(const std::vector<Vec2<double>>& points, const std::string& cssClass, bool closed)
{
    std::string d;
    for (const Vec2<double>& p : points)
        d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", p.x, p.y);
    return fmt::format("<path class=\"{}\" d=\"{}{}\"/>", cssClass, d, closed ? "Z" : "");
}

std::string strokes(const std::vector<Vec2<double>>& from, const Vec2<double>& along,
                    const char* cssClass)
{
    if (from.empty()) return "";
    std::string d;
    for (const Vec2<double>& p : from)
        d += fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}", p.x, p.y, along.x, along.y);
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", cssClass, d);
}

std::string image(double x, double y, double width, double height, const std::string& dataUri)
{
    return fmt::format(
        "<image class=\"sharp\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
        "preserveAspectRatio=\"none\" href=\"{}\"/>",
        x, y, width, height, dataUri);
}

std::string angleSymbol(Angle angle)
{
    const std::string name = angleName(angle);  // "theta_h"
    const std::string letter = name[0] == 'p' ? "\xCF\x86" : "\xCE\xB8";
    return letter + "<tspan class=\"sub\" dy=\"3\">" + name.substr(name.find('_') + 1) + "</tspan>";
}

}  // namespace fbrdf::svg
