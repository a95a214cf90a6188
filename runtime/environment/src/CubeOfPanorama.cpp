// Meridians are straight lines on all faces of a cube: columns of constant s on the four sides, and
// rays from the centre of the two others. So light is integrated along meridians, each within one
// column of the panorama, exactly, and between meridians by the midpoint rule. What one texel of
// the cube does not get the next one gets: nothing is lost or counted twice, however small a lamp
// is.
#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/CubeFaces.h>
#include <fbrdf/environment/CubeImage.h>

#include <glm/vec4.hpp>

#include <cmath>

namespace fbrdf {
namespace {

/// Integral of radiance, and in w the same of 1: the solid angle.
using Light = glm::dvec4;

/// From one meridian to the next an edge of a texel of the upper or lower face moves by at most
/// this many texels along the meridian; and meridians are at most this many texels apart. The solid
/// angle of a texel is then right to 0.15 %.
constexpr double kLargestShift = 0.15, kLargestGap = 0.04;
/// Meridians on a side are at most this many radians and half a texel apart, so that solid angles
/// are right to 1e-5; and there are so many in each column of the panorama, so that a lamp of one
/// texel on the edge of the upper or lower face is parted well.
constexpr double kLargestStep = 0.02;
constexpr int kLeastSteps = 8;

/// One column of the panorama, integrated from +y downwards, for each radian of azimuth.
class Meridian {
public:
    explicit Meridian(const Panorama& panorama) : panorama_(panorama)
    {
        const auto height = static_cast<size_t>(panorama.height);
        for (size_t y = 0; y <= height; ++y)
            cosines_.push_back(std::cos(kPi * static_cast<double>(y) / panorama.height));
        above_.resize(height + 1);
    }

    void setColumn(int column)
    {
        if (column == column_) return;
        column_ = column;
        for (int y = 0; y < panorama_.height; ++y) {
            const auto row = static_cast<size_t>(y);
            above_[row + 1] = above_[row] + within(y, cosines_[row] - cosines_[row + 1]);
        }
    }

    /// From +y to an angle whose cosine is given. Fast where the one asked for before is near.
    Light above(double cosine)
    {
        while (row_ > 0 && cosines_[row_] < cosine) --row_;
        while (row_ + 2 < cosines_.size() && cosines_[row_ + 1] > cosine) ++row_;
        return above_[row_] + within(static_cast<int>(row_), cosines_[row_] - cosine);
    }

private:
    Light within(int y, double zone) const
    {
        return Light(Vec3d(panorama_.texel(column_, y)), 1.0) * zone;
    }

    const Panorama& panorama_;
    std::vector<double> cosines_;  ///< of the upper edges of rows, and of the last lower one
    std::vector<Light> above_;     ///< the same edges
    int column_ = -1;
    size_t row_ = 0;
};

Vec3f meanOf(const Light& light)
{
    // Differences of sums can be a rounding below 0.
    return Vec3f(glm::max(Vec3d(light) / light.w, Vec3d(0.0)));
}

/// A face whose centre is on the horizon.
struct Side {
    int face;
    double azimuth;  ///< of its centre, 0 at -z and positive towards +x
};
constexpr Side kSides[] = {{0, 0.5 * kPi}, {1, -0.5 * kPi}, {4, kPi}, {5, 0.0}};

/// Adds a meridian of a side, `azimuth` from its centre, to a column of texels from the top.
void addMeridian(std::vector<Light>& texels, Meridian& meridian, double azimuth, double step)
{
    const auto size = static_cast<double>(texels.size());
    const double across = std::cos(azimuth);
    Light before(0.0);
    for (size_t j = 0; j <= texels.size(); ++j) {
        const double up = (1.0 - 2.0 * static_cast<double>(j) / size) * across;
        const Light at = meridian.above(up / std::sqrt(1.0 + up * up));
        if (j > 0) texels[j - 1] += (at - before) * step;
        before = at;
    }
}

/// A column of texels of a side.
std::vector<Light> columnOfSide(const Panorama& panorama, const Side& side, int x, int size)
{
    const double columns = panorama.width / (2.0 * kPi);
    const auto edge = [&](int i) {  // s runs against the azimuth: maps are seen from outside
        return columns * (kPi + side.azimuth - std::atan(2.0 * i / size - 1.0));
    };
    const double first = edge(x + 1), last = edge(x);
    const double step = std::min(kLargestStep, 0.25 * kPi / size);
    Meridian meridian(panorama);
    std::vector<Light> texels(static_cast<size_t>(size), Light(0.0));
    for (int c = static_cast<int>(std::floor(first)); c < last; ++c) {
        const double from = std::max(first, double(c)), to = std::min(last, c + 1.0);
        const int steps =
            std::max(kLeastSteps, static_cast<int>(std::ceil((to - from) / columns / step)));
        meridian.setColumn((c + panorama.width) % panorama.width);
        for (int i = 0; i < steps; ++i) {
            const double at = from + (to - from) * (i + 0.5) / steps;
            addMeridian(texels, meridian, at / columns - kPi - side.azimuth,
                        (to - from) / columns / steps);
        }
    }
    return texels;
}

/// The upper or lower face: texels by increasing t.
struct Cap {
    int face;  ///< 2 or 3
    int size;
    std::vector<Light> texels;
};

/// Adds a meridian to a cap, from its centre outwards.
void addRay(Cap& cap, Meridian& meridian, double azimuth, double step)
{
    const bool isUpper = cap.face == 2;
    const double pole = isUpper ? 1.0 : -1.0;
    const double s = std::sin(azimuth), t = -pole * std::cos(azimuth);
    const int half = cap.size / 2;
    Light before = meridian.above(pole);
    for (int x = 0, y = 0; x < half && y < half;) {  // texels from the centre
        const double nextX = (x + 1.0) / half / std::abs(s), nextY = (y + 1.0) / half / std::abs(t);
        const double radius = std::min(nextX, nextY);
        const Light at = meridian.above(pole / std::sqrt(1.0 + radius * radius));
        const int column = s > 0.0 ? half + x : half - 1 - x;
        const int row = t > 0.0 ? half + y : half - 1 - y;
        cap.texels[static_cast<size_t>(row * cap.size + column)] +=
            (isUpper ? at - before : before - at) * step;
        before = at;
        ++(nextX < nextY ? x : y);
    }
}

/// Azimuths from 0 to a quarter of a turn between which meridians of a cap are. An edge of a texel
/// is at x / sin(azimuth) on a meridian: it moves fast where the azimuth is small, but below that
/// of the first corner there is none.
std::vector<double> quarterOfCap(int size)
{
    const double half = 0.5 * size;
    std::vector<double> azimuths = {0.0};
    for (double azimuth = std::min(1.0 / half, 0.25 * kPi); azimuth < 0.25 * kPi;
         azimuth += std::min(kLargestShift * azimuth, kLargestGap) / half)
        azimuths.push_back(azimuth);
    azimuths.push_back(0.25 * kPi);
    for (size_t i = azimuths.size() - 1; i-- > 0;) azimuths.push_back(0.5 * kPi - azimuths[i]);
    return azimuths;
}

/// All meridians of a quarter of a cap: quarters share no texel.
void addQuarter(Cap& cap, const Panorama& panorama, int quarter)
{
    std::vector<double> edges = quarterOfCap(cap.size);
    const double columns = panorama.width / (2.0 * kPi), first = 0.25 * quarter * panorama.width;
    for (int c = static_cast<int>(first) + 1; c < first + 0.25 * panorama.width; ++c)
        edges.push_back((c - first) / columns);
    std::sort(edges.begin(), edges.end());
    Meridian meridian(panorama);
    for (size_t i = 1; i < edges.size(); ++i) {
        const double middle = 0.5 * (edges[i - 1] + edges[i]);
        meridian.setColumn(
            std::min(static_cast<int>(first + middle * columns), panorama.width - 1));
        addRay(cap, meridian, middle + kPi * (0.5 * quarter - 1.0), edges[i] - edges[i - 1]);
    }
}

std::vector<Vec3f> firstLevel(const Panorama& panorama, int size, int threads)
{
    const auto side = static_cast<size_t>(size), area = side * side;
    std::vector<Vec3f> texels(kFaces * area);
    parallelTasks(4 * side, threads, [&](size_t task) {
        const Side& at = kSides[task / side];
        const std::vector<Light> column =
            columnOfSide(panorama, at, static_cast<int>(task % side), size);
        for (size_t y = 0; y < side; ++y)
            texels[static_cast<size_t>(at.face) * area + y * side + task % side] =
                meanOf(column[y]);
    });
    Cap caps[] = {{2, size, std::vector<Light>(area, Light(0.0))},
                  {3, size, std::vector<Light>(area, Light(0.0))}};
    parallelTasks(8, threads, [&](size_t task) {
        addQuarter(caps[task / 4], panorama, static_cast<int>(task % 4));
    });
    for (const Cap& cap : caps)
        std::transform(cap.texels.begin(), cap.texels.end(),
                       texels.begin() + static_cast<std::ptrdiff_t>(size_t(cap.face) * area),
                       meanOf);
    return texels;
}

/// size: of the level that is halved.
std::vector<Vec3f> halved(const std::vector<Vec3f>& texels, int size)
{
    const auto from = static_cast<size_t>(size), to = from / 2;
    std::vector<Vec3f> result(kFaces * to * to);
    for (size_t i = 0; i < result.size(); ++i) {
        const size_t row = i / to, x = i % to;  // rows of all faces follow each other
        const Vec3f* upper = &texels[2 * row * from + 2 * x];
        result[i] = 0.25f * ((upper[0] + upper[1]) + (upper[from] + upper[from + 1]));
    }
    return result;
}

}  // namespace

CubeImage cubeOfPanorama(const Panorama& panorama, int size, int threads)
{
    FBRDF_ASSERT(size, >=, 1);
    FBRDF_ASSERT((size & (size - 1)), ==, 0);
    CubeImage cube{size, {}};
    // A face of one texel has no quarters; it is halved from one of two.
    const int first = std::max(2, size);
    std::vector<Vec3f> level = firstLevel(panorama, first, threads);
    if (first == size) cube.levels.push_back(level);
    for (int side = first; side > 1; side /= 2) {
        level = halved(level, side);
        cube.levels.push_back(level);
    }
    return cube;
}

}  // namespace fbrdf
