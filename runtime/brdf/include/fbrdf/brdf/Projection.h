// Projection.h - from a pair of directions to a position in a table (eta of docs/method.md, Eq. 4).
//
// A table has a domain: a disc map of the hemisphere, or a grid over one to three angles. A factor
// names what the domain is looked up with: one direction of the pair, or as many of its angles as
// the grid has axes. Positions are in texels: 0 is the centre of the first texel, size - 1 that of
// the last. The texture coordinate is (position + 1/2) / size; positions never leave [0, size - 1],
// so bilinear filtering never reads outside. Reference: Heidrich and Seidel 1998 (parabolic maps);
// McCool, Ang, Ahmad 2001, section 4.2 (their use here).
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

namespace fbrdf {

/// A unit vector made from the pair: a normalised linear combination of wo, wi and n, or a vector
/// that turns with the pair. Combinations that point below the surface are looked up at the
/// horizon; a combination of length 0 stands for n.
struct Direction {
    enum class Kind {
        combination,  ///< norm(weight_wo wo + weight_wi wi + weight_n n)
        difference,   ///< d: wi in the frame whose pole is h (Rusinkiewicz 1998)
        mirror,       ///< wo mirrored about the normal: (-wo.x, -wo.y, wo.z)
    } kind = Kind::combination;
    double weight_wo = 0, weight_wi = 0, weight_n = 0;  ///< used by combinations alone

    static const Direction wo, wi, h, d, mirror;
    static Direction combination(double weight_wo, double weight_wi, double weight_n)
    {
        return {Kind::combination, weight_wo, weight_wi, weight_n};
    }
};
inline constexpr Direction Direction::wo{Direction::Kind::combination, 1, 0, 0};
inline constexpr Direction Direction::wi{Direction::Kind::combination, 0, 1, 0};
inline constexpr Direction Direction::h{Direction::Kind::combination, 1, 1, 0};
inline constexpr Direction Direction::d{Direction::Kind::difference, 0, 0, 0};
inline constexpr Direction Direction::mirror{Direction::Kind::mirror, 0, 0, 0};
constexpr bool operator==(const Direction& a, const Direction& b)
{
    return a.kind == b.kind && a.weight_wo == b.weight_wo && a.weight_wi == b.weight_wi &&
           a.weight_n == b.weight_n;
}

/// phi_d is folded to [0, pi/2] by reciprocity and the mirror symmetry of isotropic surfaces:
/// cos theta_o - cos theta_i = 2 sin theta_h sin theta_d cos phi_d. half_phi_d is phi_d / 2 with
/// phi_d folded to [0, pi] by the mirror symmetry alone: it tells light from view. side_phi_d is
/// phi_d / 2 with phi_d folded to [0, pi] by reciprocity alone: it tells the two sides of the plane
/// of incidence apart.
enum class Angle { theta_h, theta_d, theta_i, theta_o, phi_d, half_phi_d, side_phi_d };

struct AngleInfo {
    Angle angle;
    const char* name;     ///< in files, messages and shaders
    bool dependsOnLight;  ///< false for an angle of wo alone
};

/// One row for each angle, in the order of the enumerators.
inline constexpr std::array<AngleInfo, 7> kAngles{{
    {Angle::theta_h, "theta_h", true},
    {Angle::theta_d, "theta_d", true},
    {Angle::theta_i, "theta_i", true},
    {Angle::theta_o, "theta_o", false},
    {Angle::phi_d, "phi_d", true},
    {Angle::half_phi_d, "half_phi_d", true},
    {Angle::side_phi_d, "side_phi_d", true},
}};
constexpr int kAngleCount = static_cast<int>(kAngles.size());

constexpr const AngleInfo& angleInfo(Angle angle)
{
    return kAngles[static_cast<size_t>(angle)];
}

/// How an angle in [0, pi/2] becomes u in [0, 1]: (1 - cos)^exponent, or cos^exponent. Cheap in a
/// shader, where acos is not: (1 - cos theta)^(1/2) is sqrt(2) sin(theta / 2), nearly linear;
/// ^(1/4) is nearly its square root.
struct AxisMap {
    enum class From { oneMinusCosine, cosine } from = From::oneMinusCosine;
    double exponent = 0.5;  ///< > 0
};

/// Knots along one angle: the first at u = 0, the last at u = 1.
struct Axis {
    int size = 16;  ///< knots, >= 2; 1 for an axis that does not vary
    AxisMap map;
};

/// size x size texels over the hemisphere. A direction lies at (x, y) / (1 + z), whose radius r in
/// [0, 1] is warped to r^gamma and then scaled to `radius` texels about the centre of the map.
/// gamma = 1 is the map of 2001; gamma = 1/2 spends texels on the highlight.
struct DiscDomain {
    int size = 32;       ///< texels on a side, >= 2
    double gamma = 0.5;  ///< > 0
    /// Texels from the centre to the horizon, at most (size - 1) / 2; the maps of 2001 have
    /// 7/16 size.
    double radius = 15.5;

    static DiscDomain fitting(int size, double gamma) { return {size, gamma, 0.5 * (size - 1)}; }
};

/// Product grid over angles, first axis contiguous.
struct GridDomain {
    std::vector<Axis> axes;  ///< 1 to 3
    /// The two axes are equal and F(a, b) = F(b, a). Both halves are stored, so that the shader
    /// need not sort the angles.
    bool symmetric = false;
};

using Domain = std::variant<DiscDomain, GridDomain>;

/// What a factor looks its table up with: a direction for a disc, one angle an axis for a grid.
using Argument = std::variant<Direction, std::vector<Angle>>;

/// Texels along x, y, z; 1 where the domain has no such dimension.
std::array<int, 3> domainSize(const Domain& domain);
int texelCount(const Domain& domain);
/// True when filtering at some position reads the texel; the corners of a disc are read by none.
bool isReachable(const Domain& domain, int texel);
/// Number of coordinates: 2 for a disc, the number of axes for a grid.
int dimensionCount(const Domain& domain);
bool isDisc(const Domain& domain);
/// Equal in every field.
bool sameDomain(const Domain& a, const Domain& b);
/// True when the argument suits the domain.
bool argumentFits(const Domain& domain, const Argument& argument);

/// What every projection of a pair needs, computed once. `complement` is 1 - cosine without
/// cancellation. Its twins in angles.glsl are fbrdfHalfVector (h), fbrdfZenith (theta_o, theta_i
/// and theta_h), fbrdfDifferenceAngle (theta_d), fbrdfDifferenceAzimuth (phi_d),
/// fbrdfHalfDifferenceAzimuth (half_phi_d) and fbrdfSideDifferenceAzimuth (side_phi_d).
template <class T>
struct PairGeometry {
    Vec3<T> wo, wi, h;
    std::array<T, kAngleCount> cosine, complement;  ///< indexed by Angle

    explicit PairGeometry(const DirectionPair<T>& pair);
};

/// u of an angle from its cosine and 1 - cosine. Twin: fbrdfAxisCoordinate in projection.glsl.
template <class T>
T axisCoordinate(const AxisMap& map, T cosine, T complement);
/// Angle of u, radians. Inverse of axisCoordinate.
double angleFromAxisCoordinate(const AxisMap& map, double u);

/// norm(weights.x wo + weights.y wi + weights.z n), or n where the sum has length 0. Twin:
/// fbrdfCombination in angles.glsl.
template <class T>
Vec3<T> combination(const Vec3<T>& weights, const Vec3<T>& wo, const Vec3<T>& wi);
/// wi in the frame whose pole is h and whose x axis leads down the meridian of h. Twin:
/// fbrdfDifferenceVector in angles.glsl.
template <class T>
Vec3<T> differenceVector(const Vec3<T>& h, const Vec3<T>& wi);
/// The vector that a direction names, for this pair.
template <class T>
Vec3<T> directionVector(const Direction& direction, const PairGeometry<T>& geometry);

/// Texel position of a direction of the upper hemisphere. Twin: fbrdfDiscPosition in
/// projection.glsl.
template <class T>
Vec2<T> discPosition(const DiscDomain& domain, const Vec3<T>& direction);
/// Direction at a texel position; positions outside the disc give the nearest direction on the
/// horizon.
Vec3d directionFromDiscPosition(const DiscDomain& domain, const Vec2<double>& position);

/// Texel position of a pair in a domain; unused coordinates are 0. Expects
/// argumentFits(domain, argument).
template <class T>
Vec3<T> texelPosition(const Domain& domain, const Argument& argument,
                      const PairGeometry<T>& geometry);

/// The texels that linear filtering mixes at a position, at most 8, and their weights, which sum
/// to 1.
template <class T>
struct Stencil {
    int count = 0;
    std::array<int, 8> texel{};
    std::array<T, 8> weight{};
};
template <class T>
Stencil<T> stencilAt(const Domain& domain, const Vec3<T>& position);
/// The same for a domain whose domainSize is `size`.
template <class T>
Stencil<T> stencilAt(const std::array<int, 3>& size, const Vec3<T>& position);

}  // namespace fbrdf
