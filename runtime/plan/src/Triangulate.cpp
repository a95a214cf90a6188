#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/Triangulate.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

using PlanePoint = Vec2<double>;

/// Drops the coordinate along which the polygon is flattest, keeping its orientation.
std::vector<PlanePoint> flattened(const std::vector<Vec3d>& corners)
{
    const Vec3d normal = vectorArea(corners);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    std::vector<PlanePoint> points;
    for (const Vec3d& corner : corners)
        points.push_back(normal[axis] < 0.0 ? PlanePoint(corner[second], corner[first])
                                            : PlanePoint(corner[first], corner[second]));
    return points;
}

double doubleArea(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isEar(const std::vector<PlanePoint>& points, const std::vector<int>& left, size_t i)
{
    const size_t count = left.size();
    const auto at = [&](size_t k) { return points[static_cast<size_t>(left[k % count])]; };
    const PlanePoint a = at(i + count - 1), b = at(i), c = at(i + 1);
    if (!(doubleArea(a, b, c) > 0.0)) return false;
    for (size_t k = i + 2; k < i + count - 1; ++k) {
        const PlanePoint p = at(k);
        if (p == a || p == b || p == c) continue;
        if (doubleArea(a, b, p) >= 0.0 && doubleArea(b, c, p) >= 0.0 && doubleArea(c, a, p) >= 0.0)
            return false;
    }
    return true;
}

/// True where every corner turns the same way, or goes straight on. A polygon that crosses itself
/// turns more than once, so its corners are seen from a side too often: its facets would overlap.
bool isConvex(const std::vector<PlanePoint>& points)
{
    const size_t count = points.size();
    double turned = 0.0;
    for (size_t i = 0; i < count; ++i) {
        const PlanePoint a = points[i], b = points[(i + 1) % count], c = points[(i + 2) % count];
        const double area = doubleArea(a, b, c);
        if (area < 0.0) return false;
        turned += std::atan2(area, glm::dot(b - a, c - b));
    }
    return turned < 3.0 * kPi;
}

}  // namespace

Vec3d vectorArea(const std::vector<Vec3d>& corners)
{
    Vec3d sum(0.0);
    for (size_t i = 0; i < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    return 0.5 * sum;
}

std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3d>& corners)
{
    FBRDF_ASSERT(corners.size(), >=, 3u);
    const std::vector<PlanePoint> points = flattened(corners);
    std::vector<int> left(corners.size());
    std::iota(left.begin(), left.end(), 0);
    std::vector<std::array<int, 3>> triangles;
    while (left.size() > 3) {
        size_t ear = 0;
        while (ear < left.size() && !isEar(points, left, ear)) ++ear;
        // Where there is no ear, the second corner is cut off, which makes a fan of the rest.
        if (ear == left.size()) ear = 1;
        const size_t count = left.size();
        triangles.push_back({left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

std::vector<std::array<int, 4>> convexFacets(const std::vector<Vec3d>& corners)
{
    std::vector<std::array<int, 4>> facets;
    const int count = static_cast<int>(corners.size());
    if (isConvex(flattened(corners))) {
        for (int i = 1; i + 1 < count; i += 2)
            facets.push_back({0, i, i + 1, std::min(i + 2, count - 1)});
        return facets;
    }
    for (const auto& [a, b, c] : triangulate(corners)) facets.push_back({a, b, c, c});
    return facets;
}

}  // namespace fbrdf
