// Svg.h - the few shapes that the plots are made of. Colours come from the page's style sheet by
// class, so that plots follow light, dark and print.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>
#include <vector>

namespace fbrdf::svg {

/// An <svg> of the given size in its own units, scaled to its container. `label` is a plain text
/// for readers who cannot see it.
std::string drawing(double width, double height, const std::string& label,
                    const std::string& shapes);

std::string line(double x1, double y1, double x2, double y2, const char* cssClass);
std::string circle(double x, double y, double radius, const char* cssClass);
/// `content` is markup; `anchor` is start, middle or end.
std::string text(double x, double y, const char* anchor, const std::string& content,
                 const char* cssClass = "tick");
/// Coordinates to a tenth of a unit.
std::string path(const std::vector<Vec2<double>>& points, const std::string& cssClass,
                 bool closed = false);
/// Strokes from each point, all alike, as one shape.
std::string strokes(const std::vector<Vec2<double>>& from, const Vec2<double>& along,
                    const char* cssClass);
/// A picture stretched to a rectangle, its pixels kept sharp.
std::string image(double x, double y, double width, double height, const std::string& dataUri);

/// The symbol of an angle, with its subscript: markup for <text>.
std::string angleSymbol(Angle angle);

}  // namespace fbrdf::svg
