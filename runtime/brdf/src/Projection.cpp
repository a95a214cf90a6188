#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/Projection.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// A value that is not a number becomes `low`: every comparison with it is false.
template <class T>
T clampTo(T value, T low, T high)
{
    return std::min(std::max(low, value), high);
}

}  // namespace

std::array<int, 3> domainSize(const Domain& domain)
{
    if (const auto* disc = std::get_if<DiscDomain>(&domain)) return {disc->size, disc->size, 1};
    std::array<int, 3> size{1, 1, 1};
    const auto& axes = std::get<GridDomain>(domain).axes;
    for (size_t i = 0; i < axes.size() && i < size.size(); ++i) size[i] = axes[i].size;
    return size;
}

int texelCount(const Domain& domain)
{
    const auto size = domainSize(domain);
    return size[0] * size[1] * size[2];
}

bool isReachable(const Domain& domain, int texel)
{
    FBRDF_ASSERT(texel, >=, 0);
    FBRDF_ASSERT(texel, <, texelCount(domain));
    const auto* disc = std::get_if<DiscDomain>(&domain);
    if (!disc) return true;
    // Filtering reads a texel within less than one texel along x and y.
    const double centre = 0.5 * (disc->size - 1);
    const double x = std::max(0.0, std::abs(texel % disc->size - centre) - 1.0),
                 y = std::max(0.0, std::abs(texel / disc->size - centre) - 1.0);
    return std::hypot(x, y) < disc->radius;
}

bool isDisc(const Domain& domain)
{
    return std::holds_alternative<DiscDomain>(domain);
}

int dimensionCount(const Domain& domain)
{
    return isDisc(domain) ? 2 : static_cast<int>(std::get<GridDomain>(domain).axes.size());
}

bool sameDomain(const Domain& a, const Domain& b)
{
    if (isDisc(a) != isDisc(b)) return false;
    if (const auto* disc = std::get_if<DiscDomain>(&a)) {
        const auto& other = std::get<DiscDomain>(b);
        return disc->size == other.size && disc->gamma == other.gamma &&
               disc->radius == other.radius;
    }
    const auto &grid = std::get<GridDomain>(a), &other = std::get<GridDomain>(b);
    const auto sameAxis = [](const Axis& x, const Axis& y) {
        return x.size == y.size && x.map.from == y.map.from && x.map.exponent == y.map.exponent;
    };
    return grid.symmetric == other.symmetric &&
           std::equal(grid.axes.begin(), grid.axes.end(), other.axes.begin(), other.axes.end(),
                      sameAxis);
}

bool argumentFits(const Domain& domain, const Argument& argument)
{
    if (isDisc(domain)) return std::holds_alternative<Direction>(argument);
    const auto* angles = std::get_if<std::vector<Angle>>(&argument);
    return angles && angles->size() == std::get<GridDomain>(domain).axes.size();
}

template <class T>
PairGeometry<T>::PairGeometry(const DirectionPair<T>& pair) : wo(pair.wo), wi(pair.wi)
{
    const Vec3<T> sum = wi + wo, difference = wi - wo;
    const T length = glm::length(sum);
    h = length > T(0) ? sum / length : Vec3<T>(T(0), T(0), T(1));
    // 1 - cos = sin^2 / (1 + cos): the sine comes from the tangential part, where nothing cancels.
    const auto set = [this](Angle angle, T cosineValue, T sineSquared) {
        const auto index = static_cast<size_t>(angle);
        cosine[index] = clampTo(cosineValue, T(0), T(1));
        complement[index] = clampTo(sineSquared / (T(1) + cosine[index]), T(0), T(1));
    };
    set(Angle::theta_h, h.z, h.x * h.x + h.y * h.y);
    set(Angle::theta_d, T(0.5) * length, T(0.25) * glm::dot(difference, difference));
    set(Angle::theta_i, wi.z, wi.x * wi.x + wi.y * wi.y);
    set(Angle::theta_o, wo.z, wo.x * wo.x + wo.y * wo.y);
    // sin theta_h sin theta_d times |cos phi_d| and |sin phi_d|; where both vanish phi_d means
    // nothing and is pi/2.
    const T side = h.x * wi.y - h.y * wi.x;  // has the sign of phi_d
    const T along = T(0.5) * std::abs(wo.z - wi.z), across = std::abs(side);
    const T sines = std::sqrt(along * along + across * across);
    const auto phi_d = static_cast<size_t>(Angle::phi_d);
    cosine[phi_d] = sines > T(0) ? along / sines : T(0);
    complement[phi_d] = sines > T(0) ? across * across / (sines * (sines + along)) : T(1);
    // cos^2 of half an angle is (1 + cos) / 2, sin^2 is (1 - cos) / 2.
    const bool isViewHigher = wo.z >= wi.z;
    const T near = T(0.5) * (T(1) + cosine[phi_d]), far = T(0.5) * complement[phi_d];
    const auto setHalf = [&](Angle angle, bool isNear) {
        set(angle, std::sqrt(isNear ? near : far), isNear ? far : near);
    };
    setHalf(Angle::half_phi_d, isViewHigher);
    setHalf(Angle::side_phi_d, isViewHigher == (side >= T(0)));
}

template <class T>
Vec3<T> combination(const Vec3<T>& weights, const Vec3<T>& wo, const Vec3<T>& wi)
{
    Vec3<T> sum = weights.x * wo + weights.y * wi;
    sum.z += weights.z;
    const T length = glm::length(sum);
    return length > T(0) ? sum / length : Vec3<T>(T(0), T(0), T(1));
}

template <class T>
Vec3<T> differenceVector(const Vec3<T>& h, const Vec3<T>& wi)
{
    const T radius = std::sqrt(h.x * h.x + h.y * h.y);
    const Vec2<T> toH = radius > T(0) ? Vec2<T>(h.x, h.y) / radius : Vec2<T>(T(1), T(0));
    return {glm::dot(wi, Vec3<T>(h.z * toH.x, h.z * toH.y, -radius)), toH.x * wi.y - toH.y * wi.x,
            glm::dot(wi, h)};
}

template <class T>
Vec3<T> directionVector(const Direction& direction, const PairGeometry<T>& g)
{
    switch (direction.kind) {
        case Direction::Kind::mirror: return {-g.wo.x, -g.wo.y, g.wo.z};
        case Direction::Kind::difference: return differenceVector(g.h, g.wi);
        case Direction::Kind::combination: break;
    }
    if (direction == Direction::wi) return g.wi;
    if (direction == Direction::wo) return g.wo;
    if (direction == Direction::h) return g.h;
    const Vec3<T> weights(static_cast<T>(direction.weight_wo), static_cast<T>(direction.weight_wi),
                          static_cast<T>(direction.weight_n));
    return combination(weights, g.wo, g.wi);
}

template <class T>
T axisCoordinate(const AxisMap& map, T cosine, T complement)
{
    const T base = map.from == AxisMap::From::cosine ? cosine : complement;
    if (map.exponent == 1.0) return base;
    if (map.exponent == 0.5) return std::sqrt(base);
    if (map.exponent == 0.25) return std::sqrt(std::sqrt(base));
    return std::pow(base, static_cast<T>(map.exponent));
}

double angleFromAxisCoordinate(const AxisMap& map, double u)
{
    const double base = std::pow(u, 1.0 / map.exponent);
    if (map.from == AxisMap::From::cosine) return std::acos(base);
    return 2.0 * std::asin(std::sqrt(0.5 * base));  // 1 - cos theta = 2 sin^2(theta / 2)
}

template <class T>
Vec2<T> discPosition(const DiscDomain& domain, const Vec3<T>& direction)
{
    Vec2<T> p = Vec2<T>(direction.x, direction.y) / (T(1) + std::max(direction.z, T(0)));
    const T radiusSquared = std::max(glm::dot(p, p), T(1e-30));  // above the smallest normal float
    if (domain.gamma == 0.5)
        p /= std::sqrt(std::sqrt(radiusSquared));
    else if (domain.gamma != 1.0)
        p *= std::pow(radiusSquared, static_cast<T>(0.5 * (domain.gamma - 1.0)));
    const T centre = static_cast<T>(0.5 * (domain.size - 1));
    return Vec2<T>(centre) + static_cast<T>(domain.radius) * p;
}

Vec3d directionFromDiscPosition(const DiscDomain& domain, const Vec2<double>& position)
{
    Vec2<double> p = (position - Vec2<double>(0.5 * (domain.size - 1))) / domain.radius;
    const double warped = glm::length(p);
    if (warped == 0.0) return {0.0, 0.0, 1.0};
    const double radius = std::pow(std::min(warped, 1.0), 1.0 / domain.gamma);
    p *= radius / warped;
    const double z = (1.0 - radius * radius) / (1.0 + radius * radius);
    return {p.x * (1.0 + z), p.y * (1.0 + z), z};
}

template <class T>
Vec3<T> texelPosition(const Domain& domain, const Argument& argument, const PairGeometry<T>& g)
{
    FBRDF_ASSERT(argumentFits(domain, argument), ==, true);
    if (const auto* disc = std::get_if<DiscDomain>(&domain)) {
        const Vec2<T> p = discPosition(*disc, directionVector(std::get<Direction>(argument), g));
        return {p.x, p.y, T(0)};
    }
    const auto& axes = std::get<GridDomain>(domain).axes;
    const auto& angles = std::get<std::vector<Angle>>(argument);
    Vec3<T> position(T(0));
    for (size_t i = 0; i < axes.size(); ++i) {
        const auto angle = static_cast<size_t>(angles[i]);
        position[static_cast<int>(i)] =
            axisCoordinate(axes[i].map, g.cosine[angle], g.complement[angle]) *
            static_cast<T>(axes[i].size - 1);
    }
    return position;
}

template <class T>
Stencil<T> stencilAt(const Domain& domain, const Vec3<T>& position)
{
    return stencilAt(domainSize(domain), position);
}

template <class T>
Stencil<T> stencilAt(const std::array<int, 3>& size, const Vec3<T>& position)
{
    Stencil<T> stencil;
    stencil.count = 1;
    stencil.texel[0] = 0;
    stencil.weight[0] = T(1);
    int stride = 1;
    for (int d = 0; d < 3; ++d) {
        const int n = size[static_cast<size_t>(d)];
        FBRDF_ASSERT(n, >=, 1);
        if (n == 1) continue;
        const T p = clampTo(position[d], T(0), static_cast<T>(n - 1));
        const int low = std::min(static_cast<int>(p), n - 2);
        const T fraction = p - static_cast<T>(low);
        for (int i = 0; i < stencil.count; ++i) {
            const auto from = static_cast<size_t>(i), to = static_cast<size_t>(i + stencil.count);
            stencil.texel[to] = stencil.texel[from] + (low + 1) * stride;
            stencil.texel[from] += low * stride;
            stencil.weight[to] = stencil.weight[from] * fraction;
            stencil.weight[from] *= T(1) - fraction;
        }
        stencil.count *= 2;
        stride *= n;
    }
    return stencil;
}

#define FBRDF_INSTANTIATE(T)                                                                \
    template struct PairGeometry<T>;                                                        \
    template T axisCoordinate(const AxisMap&, T, T);                                        \
    template Vec3<T> combination(const Vec3<T>&, const Vec3<T>&, const Vec3<T>&);           \
    template Vec3<T> differenceVector(const Vec3<T>&, const Vec3<T>&);                      \
    template Vec3<T> directionVector(const Direction&, const PairGeometry<T>&);             \
    template Vec2<T> discPosition(const DiscDomain&, const Vec3<T>&);                       \
    template Vec3<T> texelPosition(const Domain&, const Argument&, const PairGeometry<T>&); \
    template Stencil<T> stencilAt(const Domain&, const Vec3<T>&);                           \
    template Stencil<T> stencilAt(const std::array<int, 3>&, const Vec3<T>&);
FBRDF_INSTANTIATE(float)
FBRDF_INSTANTIATE(double)
#undef FBRDF_INSTANTIATE

}  // namespace fbrdf
