// The difference of two interpolations is smooth between texels. With samples d apart its peak lies
// within d / 2 of a sample, and exceeds that sample by at most f'' d^2 / 8; an interpolation over
// texels h apart is off by f'' h^2 / 8. So with d = h / 4 the peaks are at most a sixteenth higher
// than the largest sample.
#include <fbrdf/brdf/CubeFaces.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/DirectionMap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr double kAim = 1.0 / 64.0;  // octaves: a percent
constexpr double kBetweenSamples = 17.0 / 16.0;
constexpr int kSamplesPerTexel = 4, kSamplesPerNativeTexel = 8;
constexpr int kFirstSize = 16;
// How far inside of a face its border is sampled, in texels: far above rounding.
constexpr double kInside = 1e-9;

int largestByItself(LookUp lookUp)
{
    return lookUp == LookUp::cube ? 256 : 512;
}

/// False where a pair above the surface has the direction below it.
bool staysAbove(const Direction& direction)
{
    if (direction.kind != Direction::Kind::combination) return true;
    return direction.weight_wi >= 0.0 && direction.weight_wo >= 0.0 && direction.weight_n >= 0.0;
}

Vec3d valueAt(const Table& table, const Vec3d& direction)
{
    const auto position = discPosition(std::get<DiscDomain>(table.domain), direction);
    return sample(table, Vec3d(position, 0.0));
}

/// Filtering a cube above the horizon reads no direction whose z is below this.
double nearestOf(int size)
{
    return -2.0 / size;
}

/// Filtering at the horizon also reads texels below it: they continue the table without a kink.
/// nearest: filtering reads no direction whose z is below that.
Vec3d continuedAt(const Table& table, const Vec3d& direction, double nearest)
{
    if (direction.z >= 0.0) return valueAt(table, direction);
    const double radius = std::hypot(direction.x, direction.y);
    if (radius == 0.0) return valueAt(table, {1.0, 0.0, 0.0});
    const Vec3d atHorizon = valueAt(table, {direction.x / radius, direction.y / radius, 0.0});
    if (direction.z < nearest) return atHorizon;
    return 2.0 * atHorizon - valueAt(table, {direction.x, direction.y, -direction.z});
}

/// The direction of a position in a parabolic map, also outside of the disc.
Vec3d parabolicDirection(const DiscDomain& disc, double x, double y)
{
    const double centre = 0.5 * (disc.size - 1);
    const Vec2<double> p((x - centre) / disc.radius, (y - centre) / disc.radius);
    const double square = glm::dot(p, p);
    return Vec3d(2.0 * p, 1.0 - square) / (1.0 + square);
}

void append(std::vector<float>& texels, const Vec3d& value, int channels)
{
    for (int c = 0; c < channels; ++c) texels.push_back(static_cast<float>(value[c]));
}

Table emptyMap(const Table& table, Domain domain)
{
    Table map;
    map.name = table.name;
    map.domain = std::move(domain);
    map.channels = table.channels;
    return map;
}

Table parabolicTable(const Table& table, int size)
{
    const DiscDomain disc = DiscDomain::fitting(size, 1.0);
    Table map = emptyMap(table, disc);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            append(map.texels, continuedAt(table, parabolicDirection(disc, x, y), -1.0),
                   map.channels);
    return map;
}

Table cubeTable(const Table& table, int size)
{
    Table map = emptyMap(table, GridDomain{{Axis{size, {}}, Axis{size, {}}, Axis{kFaces, {}}}});
    for (int face = 0; face < kFaces; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                append(map.texels,
                       continuedAt(table, glm::normalize(cubePoint(face, x, y, size)),
                                   nearestOf(size)),
                       map.channels);
    return map;
}

/// |log2| between the map and the table in one direction.
class Difference {
public:
    Difference(const Table& table, const DirectionMap& map, bool seamless)
        : table_(table), map_(map), seamless_(seamless)
    {
    }

    double at(const Vec3d& direction) const
    {
        const Vec3d exact = valueAt(table_, direction);
        if (map_.lookUp == LookUp::parabolic) {
            const Vec3d difference = glm::abs(valueAt(map_.table, direction) - exact);
            return std::max({difference.x, difference.y, difference.z});
        }
        const double across = cube(cubeStencil(direction, map_.size(), true), exact);
        return seamless_
                   ? across
                   : std::max(across, cube(cubeStencil(direction, map_.size(), false), exact));
    }

private:
    // Beyond a corner of the cube there is no texel: drivers take one of the others, or their mean.
    double cube(const CubeStencil& stencil, const Vec3d& exact) const
    {
        double worst = 0.0;
        for (const int instead : stencil.texel) {
            if (instead < 0) continue;
            Vec3d sum(0.0);
            for (size_t k = 0; k < stencil.texel.size(); ++k)
                for (int c = 0; c < 3; ++c)
                    sum[c] += stencil.weight[k] *
                              static_cast<double>(map_.table.texel(
                                  stencil.texel[k] < 0 ? instead : stencil.texel[k], c));
            const Vec3d difference = glm::abs(sum - exact);
            worst = std::max({worst, difference.x, difference.y, difference.z});
            if (stencil.isWhole) break;
        }
        return worst;
    }

    const Table& table_;
    const DirectionMap& map_;
    bool seamless_;
};

/// The largest difference on a disc at positions `samples` to the texel; no longer than it stays
/// below `enough`.
double worstOnDisc(const Difference& difference, const DiscDomain& disc, int samples, double enough)
{
    double worst = 0.0;
    const int last = (disc.size - 1) * samples;
    const double centre = 0.5 * (disc.size - 1);
    for (int y = 0; y <= last && worst < enough; ++y)
        for (int x = 0; x <= last; ++x) {
            const Vec2<double> at(static_cast<double>(x) / samples,
                                  static_cast<double>(y) / samples);
            if (glm::length(at - centre) <= disc.radius)
                worst = std::max(worst, difference.at(directionFromDiscPosition(disc, at)));
        }
    return worst;
}

/// The same on the faces of a cube, above the horizon.
double worstOnCube(const Difference& difference, int size, double enough)
{
    double worst = 0.0;
    const int last = size * kSamplesPerTexel;
    // The border of a face is read from either side.
    const auto coordinate = [size](int i) {
        const double p = static_cast<double>(i) / kSamplesPerTexel - 0.5;
        return std::clamp(p, -0.5 + kInside, size - 0.5 - kInside);
    };
    for (int face = 0; face < kFaces; ++face)
        for (int y = 0; y <= last && worst < enough; ++y)
            for (int x = 0; x <= last; ++x) {
                const Vec3d point = cubePoint(face, coordinate(x), coordinate(y), size);
                if (point.z >= 0.0) worst = std::max(worst, difference.at(glm::normalize(point)));
            }
    return worst;
}

DirectionMap recombinedAt(const Table& table, const DirectionMapRequest& request, int size,
                          double enough)
{
    DirectionMap map;
    map.lookUp = request.lookUp;
    map.table =
        request.lookUp == LookUp::cube ? cubeTable(table, size) : parabolicTable(table, size);
    const Difference difference(table, map, request.seamless);
    const double atNative =
        worstOnDisc(difference, std::get<DiscDomain>(table.domain), kSamplesPerNativeTexel, enough);
    const double atMap = request.lookUp == LookUp::cube
                             ? worstOnCube(difference, size, enough)
                             : worstOnDisc(difference, std::get<DiscDomain>(map.table.domain),
                                           kSamplesPerTexel, enough);
    map.error = kBetweenSamples * std::max(atNative, atMap);
    return map;
}

double contrastOfFace(const DirectionMap& map, int face)
{
    const int size = map.size();
    Table table = emptyMap(map.table, GridDomain{{Axis{size, {}}, Axis{size, {}}}});
    const auto length = static_cast<std::ptrdiff_t>(map.table.texels.size()) / kFaces;
    const auto first = map.table.texels.begin() + face * length;
    table.texels.assign(first, first + length);
    // What is never read differs from nothing: std::max leaves out what is no number.
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (glm::normalize(cubePoint(face, x, y, size)).z < nearestOf(size))
                for (int c = 0; c < table.channels; ++c)
                    table.texels[static_cast<size_t>((y * size + x) * table.channels + c)] =
                        std::numeric_limits<float>::quiet_NaN();
    return contrast(table);
}

/// A bound of the contrast where filtering crosses the border of a face: neither of two axes sees
/// more than the range of the texels that are mixed there.
double contrastOfBorder(const DirectionMap& map, int face)
{
    const int size = map.size();
    const double low = kInside - 0.5, high = size - 0.5 - kInside;
    double worst = 0.0;
    for (int i = 0; i <= size; ++i) {
        const double along = std::clamp(i - 0.5, low, high);
        for (const auto& [x, y] : {std::pair{along, low}, std::pair{along, high},
                                   std::pair{low, along}, std::pair{high, along}}) {
            const Vec3d direction = glm::normalize(cubePoint(face, x, y, size));
            if (direction.z < 0.0) continue;
            for (int c = 0; c < map.table.channels; ++c) {
                float least = std::numeric_limits<float>::max(), most = -least;
                for (const int texel : cubeStencil(direction, size, true).texel) {
                    if (texel < 0) continue;
                    least = std::min(least, map.table.texel(texel, c));
                    most = std::max(most, map.table.texel(texel, c));
                }
                worst = std::max(worst, 2.0 * static_cast<double>(most - least));
            }
        }
    }
    return worst;
}

}  // namespace

const char* lookUpName(LookUp lookUp)
{
    switch (lookUp) {
        case LookUp::native: return "native";
        case LookUp::parabolic: return "parabolic";
        case LookUp::cube: return "cube";
    }
    return "?";
}

LookUp lookUpFromName(const std::string& name)
{
    for (const LookUp l : {LookUp::native, LookUp::parabolic, LookUp::cube})
        if (name == lookUpName(l)) return l;
    throw Error(ErrorKind::usage, "look-up",
                Found("'" + name + "'").expected("native, parabolic or cube"));
}

std::string whyNotRecombined(const Form& form, int table, Storage storage)
{
    FBRDF_ASSERT(table, >=, 0);
    FBRDF_ASSERT(static_cast<size_t>(table), <, form.tables.size());
    const std::string name = "table '" + form.tables[static_cast<size_t>(table)].name + "': ";
    if (!isLog(storage)) return name + Found("values").expected("logs: only those have a bound");
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors) {
            if (factor.table != table) continue;
            const auto* direction = std::get_if<Direction>(&factor.argument);
            if (!direction) return name + Found("angles").expected("one direction");
            if (!staysAbove(*direction))
                return name + Found(directionName(*direction))
                                  .expected("a direction that is never below the horizon");
        }
    return "";
}

double contrast(const DirectionMap& map)
{
    if (map.lookUp != LookUp::cube) return contrast(map.table);
    // The faces are six tables, not one of three axes.
    double worst = 0.0;
    for (int face = 0; face < kFaces; ++face)
        worst = std::max({worst, contrastOfFace(map, face), contrastOfBorder(map, face)});
    return worst;
}

DirectionMap recombined(const Table& table, const DirectionMapRequest& request)
{
    FBRDF_ASSERT(isDisc(table.domain), ==, true);
    FBRDF_ASSERT(isLog(table.storage), ==, true);
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (request.size != 0) {
        if (request.size < kLeastMapSize || request.size > kLargestMapSize || request.size % 2 != 0)
            throw Error(ErrorKind::usage, "map size",
                        Found(std::to_string(request.size))
                            .expected("an even number from " + std::to_string(kLeastMapSize) +
                                      " to " + std::to_string(kLargestMapSize)));
        return recombinedAt(table, request, request.size, kNever);
    }
    const int largest = std::min(largestByItself(request.lookUp), request.largest);
    for (int size = kFirstSize; size < largest; size *= 2) {
        DirectionMap map = recombinedAt(table, request, size, kAim);
        if (map.error <= kAim) return map;
    }
    return recombinedAt(table, request, std::max(largest - largest % 2, kLeastMapSize), kNever);
}

}  // namespace fbrdf
