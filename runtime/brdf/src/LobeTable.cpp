#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/LobeTable.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kLastKnot = 89.0 * kDegree;
constexpr int kMostKnots = 1024;  // a table of the fitter has 24 or 84
constexpr float kLargestTilt = 256.0f;

/// A place between two knots of one axis.
template <class T>
struct KnotPlace {
    int knot;
    T fraction;
};

template <class T>
KnotPlace<T> placeOf(T position, int count)
{
    const T clamped = std::clamp(position, T(0), T(count - 1));
    const int knot = std::min(static_cast<int>(clamped), std::max(0, count - 2));
    return {knot, clamped - T(knot)};
}

/// The position of theta_o among the knots, inverse of lobeKnotAngle.
template <class T>
T thetaPosition(const Vec3<T>& wo, int count)
{
    const T theta = std::atan2(std::hypot(wo.x, wo.y), wo.z);
    const T left = std::max(T(0), T(1) - theta / T(kLastKnot));
    return (T(1) - std::pow(left, T(2) / T(3))) * T(count - 1);
}

template <class T>
T azimuthPosition(const Vec3<T>& wo, int count)
{
    return std::atan2(std::abs(wo.y), std::abs(wo.x)) / T(0.5 * kPi) * T(count - 1);
}

template <class T>
Vec3<T> tiltedAxis(const Vec3<T>& wo, T angle)
{
    const T across = std::hypot(wo.x, wo.y);
    // At normal incidence every direction is in the plane, and the tilt is 0.
    if (!(across > T(0))) return {T(0), T(0), T(1)};
    const T c = std::cos(angle), s = std::sin(angle);
    // The mirror direction (-x, -y, z), and the unit vector from it towards the normal.
    const Vec3<T> mirror(-wo.x, -wo.y, wo.z);
    const Vec3<T> inwards(wo.x * wo.z / across, wo.y * wo.z / across, across);
    return mirror * c + inwards * s;
}

template <class T>
Vec3<T> bentAxis(const LobeTable& table, const Vec3<T>& wo, int lobe)
{
    // Knots are those of the quadrant x, y >= 0; in the others the normals are mirrored as wo is.
    const T side = (table.acrossTangent ? wo.y : wo.x) < T(0) ? T(-1) : T(1);
    const T offset = side * T(table.spread) * (T(lobe) - T(0.5) * T(table.lobes - 1));
    const Vec3<T> normal = glm::normalize(table.acrossTangent ? Vec3<T>(T(0), offset, T(1))
                                                              : Vec3<T>(offset, T(0), T(1)));
    return T(2) * glm::dot(wo, normal) * normal - wo;
}

template <class T>
void add(LobeSum<T>& sum, std::array<T, kMostLobes>& tilts, const LobeKnot& knot, T weight)
{
    sum.cosine += Vec3<T>(knot.cosine) * weight;
    for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) {
        sum.weight[k] += Vec3<T>(knot.lobes[k].weight) * weight;
        sum.level[k] += T(knot.lobes[k].level) * weight;
        tilts[k] += T(knot.lobes[k].tilt) * weight;
    }
}

bool isWeight(const Vec3f& weight)
{
    for (int c = 0; c < 3; ++c)
        if (!(std::isfinite(weight[c]) && weight[c] >= 0.0f)) return false;
    return true;
}

bool isKnot(const LobeTable& table, const LobeKnot& knot)
{
    const auto isLobe = [](const Lobe& lobe) {
        return isWeight(lobe.weight) && lobe.level >= 0.0f &&
               lobe.level <= static_cast<float>(kCosineLevel) &&
               std::abs(lobe.tilt) <= kLargestTilt;
    };
    return isWeight(knot.cosine) &&
           std::all_of(knot.lobes.begin(), knot.lobes.begin() + table.lobes, isLobe);
}

bool isCount(const LobeTable& table)
{
    if (table.axes == LobeAxes::tilted) return table.lobes >= 1 && table.lobes <= kMostTiltedLobes;
    return table.lobes >= 1 && table.lobes <= kMostLobes && table.lobes % 2 == 1;
}

}  // namespace

double lobeWidth(double level)
{
    return std::exp2(level - kCosineLevel);
}

double stretchedCosine(double cosine, double width)
{
    if (cosine <= 0.0) return 0.0;
    const double s2 = width * width, c2 = std::min(1.0, cosine * cosine);
    const double norm = s2 * c2 + (1.0 - c2);
    return s2 * cosine / (kPi * norm * norm);
}

double lobeValue(double cosine, double level)
{
    const double clamped = std::clamp(level, 0.0, double(kCosineLevel));
    const double lower = std::min(std::floor(clamped), kCosineLevel - 1.0);
    const double fraction = clamped - lower;
    return (1.0 - fraction) * stretchedCosine(cosine, lobeWidth(lower)) +
           fraction * stretchedCosine(cosine, lobeWidth(lower + 1.0));
}

double lobeKnotAngle(int knot, int count)
{
    const double u = count > 1 ? static_cast<double>(knot) / (count - 1) : 0.0;
    return kLastKnot * (1.0 - std::pow(1.0 - u, 1.5));
}

void validate(const LobeTable& table, const std::string& where)
{
    if (table.isEmpty()) return;
    if (!isCount(table))
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(table.lobes) + " lobes")
                        .expected("1 to 3 tilted ones, or 1, 3, 5 or 7 about bent normals"));
    if (table.thetas < 2 || table.thetas > kMostKnots || table.azimuths < 1 ||
        table.azimuths > kMostKnots ||
        table.knots.size() !=
            static_cast<size_t>(table.thetas) * static_cast<size_t>(table.azimuths))
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(table.knots.size()) + " knots of lobes for " +
                          std::to_string(table.thetas) + " x " + std::to_string(table.azimuths))
                        .expected("as many, at least 2 and at most 1024 along theta_o"));
    const auto isError = [](double error) { return std::isfinite(error) && error >= 0.0; };
    if (!std::isfinite(table.spread) || !isError(table.error) ||
        !std::all_of(table.fewerErrors.begin(), table.fewerErrors.end(), isError))
        throw Error(
            ErrorKind::input, where,
            Found("a spread or an error of lobes that is no number").expected("finite ones"));
    // Draws have 1, 2 or all tilted lobes, or 1, 3 or all bent ones.
    const int fewer =
        table.axes == LobeAxes::tilted ? table.lobes - 1 : std::min(2, (table.lobes - 1) / 2);
    if (!table.fewerErrors.empty() && table.fewerErrors.size() != static_cast<size_t>(fewer))
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(table.fewerErrors.size()) + " errors of fewer lobes")
                        .expected(std::to_string(fewer) + ", or none"));
    for (size_t i = 0; i < table.knots.size(); ++i)
        if (!isKnot(table, table.knots[i]))
            throw Error(ErrorKind::input, where,
                        Found("knot " + std::to_string(i) + " of the lobes out of range")
                            .expected("weights of at least 0, levels of 0 to 6, finite tilts"));
}

template <class T>
LobeSum<T> lobesAt(const LobeTable& table, const Vec3<T>& wo)
{
    FBRDF_ASSERT(table.lobes, >=, 1);
    const auto theta = placeOf(thetaPosition(wo, table.thetas), table.thetas);
    const auto azimuth = table.azimuths > 1
                             ? placeOf(azimuthPosition(wo, table.azimuths), table.azimuths)
                             : KnotPlace<T>{0, T(0)};
    LobeSum<T> sum;
    sum.lobes = table.lobes;
    std::array<T, kMostLobes> tilts{};
    for (int j = 0; j < std::min(2, table.azimuths); ++j)
        for (int i = 0; i < 2; ++i) {
            const int knot = (azimuth.knot + j) * table.thetas + theta.knot + i;
            const T weight = (i ? theta.fraction : T(1) - theta.fraction) *
                             (j ? azimuth.fraction : T(1) - azimuth.fraction);
            add(sum, tilts, table.knots[static_cast<size_t>(knot)], weight);
        }
    for (int k = 0; k < table.lobes; ++k) {
        const auto at = static_cast<size_t>(k);
        sum.axis[at] = table.axes == LobeAxes::bent
                           ? bentAxis(table, wo, k)
                           : tiltedAxis(wo, tilts[at] * std::exp2(sum.level[at] - T(kCosineLevel)));
    }
    return sum;
}

template LobeSum<float> lobesAt(const LobeTable&, const Vec3<float>&);
template LobeSum<double> lobesAt(const LobeTable&, const Vec3<double>&);

}  // namespace fbrdf
