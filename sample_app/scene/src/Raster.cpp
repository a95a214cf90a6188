#include <fbrdf/base/Assert.h>
#include <fbrdf/scene/Raster.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::scene {
namespace {

// Sub-pixel steps a pixel: at least 4 bits by the specification, 8 in Mesa and in current hardware.
constexpr double kSubPixels = 256.0;

using Vec4d = glm::dvec4;

/// A corner of a clipped triangle: clip coordinates and where in the whole triangle it is.
struct ClipCorner {
    Vec4d position;
    Vec3d weights;
};

/// A corner on the screen: pixels, y up.
struct ScreenCorner {
    double x, y, depth, inverseW;
    double snappedX, snappedY;  ///< in sub-pixel steps, whole numbers
    Vec3d weights;
};

/// Distance to the near plane z = -w, scaled: >= 0 inside.
double nearDistance(const ClipCorner& corner)
{
    return corner.position.z + corner.position.w;
}

ClipCorner mixed(const ClipCorner& a, const ClipCorner& b, double share)
{
    return {a.position + share * (b.position - a.position),
            a.weights + share * (b.weights - a.weights)};
}

/// Clips as Sutherland and Hodgman 1974, at the near plane alone: what lies outside the other
/// planes has no pixel, but behind the eye the projection would turn over.
std::vector<ClipCorner> clippedAtNear(const std::array<ClipCorner, 3>& triangle)
{
    std::vector<ClipCorner> kept;
    for (size_t i = 0; i < 3; ++i) {
        const ClipCorner &a = triangle[i], &b = triangle[(i + 1) % 3];
        const double da = nearDistance(a), db = nearDistance(b);
        if (da >= 0.0) kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) kept.push_back(mixed(a, b, da / (da - db)));
    }
    return kept;
}

ScreenCorner onScreen(const ClipCorner& corner, int width, int height)
{
    const Vec4d& p = corner.position;
    ScreenCorner screen{};
    screen.inverseW = 1.0 / p.w;
    screen.x = (p.x * screen.inverseW + 1.0) * 0.5 * width;
    screen.y = (p.y * screen.inverseW + 1.0) * 0.5 * height;
    screen.depth = p.z * screen.inverseW;
    screen.snappedX = std::round(screen.x * kSubPixels);
    screen.snappedY = std::round(screen.y * kSubPixels);
    screen.weights = corner.weights;
    return screen;
}

/// Twice the area of (a, b, p), p in sub-pixel steps; > 0 when p is left of a -> b. Exact: whole
/// numbers below 2^53 for all corners within some 2^17 pixels.
double edge(const ScreenCorner& a, const ScreenCorner& b, double x, double y)
{
    return (b.snappedX - a.snappedX) * (y - a.snappedY) -
           (b.snappedY - a.snappedY) * (x - a.snappedX);
}

/// True for a left or a bottom edge of a counter-clockwise triangle, y up: a left edge goes down, a
/// bottom edge is level and goes right. Row 0 of a framebuffer object is the bottom one, so this is
/// the top-left rule of its rows.
bool ownsTies(const ScreenCorner& a, const ScreenCorner& b)
{
    return b.snappedY < a.snappedY || (b.snappedY == a.snappedY && b.snappedX > a.snappedX);
}

double cross2(const ScreenCorner& a, const ScreenCorner& b, double x, double y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

struct PixelRange {
    int begin, end;
};

/// Pixels whose centres may lie in [low, high] sub-pixel steps, cut to the picture.
PixelRange pixelRange(double low, double high, int size)
{
    const double begin = std::ceil(low / kSubPixels - 0.5),
                 end = std::floor(high / kSubPixels + 0.5);
    return {static_cast<int>(std::clamp(begin, 0.0, double(size))),
            static_cast<int>(std::clamp(end, 0.0, double(size)))};
}

/// Draws triangles of one instance into the picture.
class Drawing {
public:
    Drawing(Fragments& fragments, int instance) : fragments_(fragments), instance_(instance) {}

    void draw(const std::array<ClipCorner, 3>& triangle, uint32_t first)
    {
        const std::vector<ClipCorner> corners = clippedAtNear(triangle);
        for (size_t i = 1; i + 1 < corners.size(); ++i)
            drawClipped({project(corners[0]), project(corners[i]), project(corners[i + 1])}, first);
    }

private:
    ScreenCorner project(const ClipCorner& corner) const
    {
        return onScreen(corner, fragments_.width, fragments_.height);
    }

    void drawClipped(std::array<ScreenCorner, 3> corner, uint32_t first)
    {
        double area = edge(corner[0], corner[1], corner[2].snappedX, corner[2].snappedY);
        if (area < 0.0) std::swap(corner[1], corner[2]);
        if (area == 0.0 || !std::isfinite(area)) return;
        const auto [lowX, highX] =
            std::minmax({corner[0].snappedX, corner[1].snappedX, corner[2].snappedX});
        const auto [lowY, highY] =
            std::minmax({corner[0].snappedY, corner[1].snappedY, corner[2].snappedY});
        const PixelRange xs = pixelRange(lowX, highX, fragments_.width);
        const PixelRange ys = pixelRange(lowY, highY, fragments_.height);
        for (int y = ys.begin; y < ys.end; ++y)
            for (int x = xs.begin; x < xs.end; ++x)
                if (covers(corner, x, y)) drawPixel(corner, x, y, first);
    }

    static bool covers(const std::array<ScreenCorner, 3>& corner, int x, int y)
    {
        const double px = (x + 0.5) * kSubPixels, py = (y + 0.5) * kSubPixels;
        for (size_t i = 0; i < 3; ++i) {
            const ScreenCorner &a = corner[i], &b = corner[(i + 1) % 3];
            const double side = edge(a, b, px, py);
            if (side < 0.0 || (side == 0.0 && !ownsTies(a, b))) return false;
        }
        return true;
    }

    /// Interpolates between the corners as they were before snapping, as Mesa does.
    void drawPixel(const std::array<ScreenCorner, 3>& corner, int x, int y, uint32_t first)
    {
        const double px = x + 0.5, py = y + 0.5;
        const double area = cross2(corner[0], corner[1], corner[2].x, corner[2].y);
        if (!(std::abs(area) > 0.0)) return;
        const Vec3d screen(cross2(corner[1], corner[2], px, py) / area,
                           cross2(corner[2], corner[0], px, py) / area,
                           cross2(corner[0], corner[1], px, py) / area);
        Fragment fragment{instance_, first, 0.0, Vec3d(0.0)};
        double inverseW = 0.0;
        for (int k = 0; k < 3; ++k) {
            const ScreenCorner& c = corner[static_cast<size_t>(k)];
            fragment.depth += screen[k] * c.depth;
            fragment.weights += screen[k] * c.inverseW * c.weights;
            inverseW += screen[k] * c.inverseW;
        }
        fragment.weights /= inverseW;
        // GL's row 0 is the bottom one, the picture's the top one.
        const size_t row = static_cast<size_t>(fragments_.height - 1 - y);
        Fragment& seen =
            fragments_.pixels[row * static_cast<size_t>(fragments_.width) + static_cast<size_t>(x)];
        if (fragment.depth < seen.depth && fragment.depth >= -1.0) seen = fragment;
    }

    Fragments& fragments_;
    int instance_;
};

}  // namespace

Fragments rasterise(const std::vector<Instance>& instances, const gl::View& view, int width,
                    int height)
{
    FBRDF_ASSERT(width, >, 0);
    FBRDF_ASSERT(height, >, 0);
    Fragments fragments{width, height, {}};
    fragments.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (size_t i = 0; i < instances.size(); ++i) {
        const Mesh& mesh = *instances[i].mesh;
        const glm::dmat4 modelView = glm::dmat4(view.view) * glm::dmat4(instances[i].model);
        const glm::dmat4 projection(view.projection);
        Drawing drawing(fragments, static_cast<int>(i));
        for (uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
            std::array<ClipCorner, 3> triangle;
            for (uint32_t k = 0; k < 3; ++k) {
                const Vec3f& position = mesh.positions[mesh.indices[first + k]];
                triangle[k].position = projection * (modelView * Vec4d(Vec3d(position), 1.0));
                triangle[k].weights = Vec3d(0.0);
                triangle[k].weights[static_cast<int>(k)] = 1.0;
            }
            drawing.draw(triangle, first);
        }
    }
    return fragments;
}

}  // namespace fbrdf::scene
