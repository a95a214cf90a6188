// A cell is looked up in the mip level whose texels are as large, filtered linearly: what it adds
// to the lobe is a smooth spot, about a Gaussian. So the cells of a ring make a smooth ring, and
// the weights of the rings are those whose sum of smooth rings is nearest to the lobe. With the
// energy of the lobe in each ring instead, spots blur the lobe: twice to four times the error.
#include <fbrdf/base/Assert.h>
#include <fbrdf/environment/Prefilter.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// Between two angles from the axis.
struct Ring {
    double inner, outer, middle;  ///< half of the lobe's energy in the ring is within the middle
    int cells;
    double solidAngle;  ///< of a cell
};

/// Sides of cells: those of the first over the width of the lobe, and far out over the angle.
/// Narrow lobes are convolved at a million texels, wide ones at a thousand: these get more cells,
/// because a lamp shows there as spots over the whole sphere. Errors fall with the area of the
/// cells.
struct CellSides {
    double first, slope;
};
constexpr CellSides kCellSides[kLobeLevels] = {
    {0.2, 0.4}, {0.15, 0.3}, {0.12, 0.22}, {0.08, 0.16}, {0.06, 0.12}, {0.045, 0.09}, {0.03, 0.06}};

/// Variance of a spot over the solid angle of its cell: 1/12 + 1/6 of a texel as large and of
/// linear filtering, and some for the linear mixture of two levels. Within 0.25 to 0.32 errors are
/// alike.
constexpr double kSpotVariance = 0.28;
constexpr int kLobeSamples = 400;  // of the lobe, along the angle

/// Energy of the lobe within an angle: of the cosine it is sin^2 = t^2 / (1 + t^2) with t = tan,
/// and stretching moves t to s t.
double energyWithin(double angle, double width)
{
    const double s = std::sin(angle), c = width * std::cos(angle);
    return s * s / (s * s + c * c);
}

Ring ringBetween(double inner, double outer, double side, double width)
{
    const double half = 0.5 * (energyWithin(inner, width) + energyWithin(outer, width));
    const double around = 2.0 * kPi * std::sin(0.5 * (inner + outer)) / side;
    const int cells = inner > 0.0 ? std::max(3, static_cast<int>(std::lround(around))) : 1;
    const double zone = 2.0 * kPi * (std::cos(inner) - std::cos(outer));
    return {inner, outer, inner > 0.0 ? std::atan(width * std::sqrt(half / (1.0 - half))) : 0.0,
            cells, zone / cells};
}

/// One cell about the axis, then rings as wide as their cells, to 90 degrees.
std::vector<Ring> ringsOf(const CellSides& sides, double width)
{
    const double first = sides.first * width, end = 0.5 * kPi;
    std::vector<Ring> rings = {ringBetween(0.0, first / std::sqrt(kPi), first, width)};
    for (double inner = rings[0].outer; inner < end;) {
        const double side = std::hypot(first, sides.slope * (inner + 0.5 * first));
        // The last ring takes in a narrow remainder.
        const double outer = inner + 1.5 * side < end ? inner + side : end;
        rings.push_back(ringBetween(inner, outer, side, width));
        inner = outer;
    }
    return rings;
}

/// exp(-k) I_0(k) (Abramowitz and Stegun 1964, 9.8.1 and 9.8.2, errors below 2e-7).
double scaledBessel(double k)
{
    const double t = k / 3.75;
    if (k < 3.75) {
        const double u = t * t;
        return std::exp(-k) *
               (1.0 +
                u * (3.5156229 +
                     u * (3.0899424 +
                          u * (1.2067492 + u * (0.2659732 + u * (0.0360768 + u * 0.0045813))))));
    }
    const double u = 1.0 / t;
    const double tail =
        0.00916281 + u * (-0.02057706 + u * (0.02635537 + u * (-0.01647633 + u * 0.00392377)));
    return (0.39894228 + u * (0.01328592 + u * (0.00225319 + u * (-0.00157565 + u * tail)))) /
           std::sqrt(k);
}

/// A direction of the half sphere and beyond, and the solid angle of its zone over 2 pi.
struct Sample {
    double angle, zone;
};

/// Dense where the lobe is, to 2.2 rad: spots at the horizon reach below it.
std::vector<Sample> samplesOf(double width)
{
    const double unit = 0.2 * width, rate = std::log(1.0 + 2.2 / unit) / kLobeSamples;
    std::vector<Sample> samples;
    for (int i = 0; i < kLobeSamples; ++i) {
        const double grown = std::exp(rate * (i + 0.5)), angle = unit * (grown - 1.0);
        samples.push_back({angle, std::sin(angle) * unit * grown * rate});
    }
    return samples;
}

/// What a ring of weight 1 adds at each sample, in 1/sr: Gaussian spots all around.
std::vector<double> smoothRing(const Ring& ring, const std::vector<Sample>& samples)
{
    const double variance = kSpotVariance * ring.solidAngle;
    std::vector<double> values;
    double energy = 0.0;
    for (const Sample& at : samples) {
        const double between = std::sin(0.5 * (at.angle - ring.middle));
        const double value = std::exp(-2.0 * between * between / variance) *
                             scaledBessel(std::sin(at.angle) * std::sin(ring.middle) / variance);
        values.push_back(value);
        energy += 2.0 * kPi * at.zone * value;
    }
    for (double& value : values) value /= energy;
    return values;
}

/// Rows of n unknowns and the right side, solved by elimination with pivots.
std::vector<double> solved(std::vector<std::vector<double>> rows)
{
    const size_t count = rows.size();
    for (size_t k = 0; k < count; ++k) {
        const auto pivot = std::max_element(
            rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
            [k](const auto& a, const auto& b) { return std::abs(a[k]) < std::abs(b[k]); });
        std::swap(rows[k], *pivot);
        for (size_t i = 0; i < count; ++i) {
            if (i == k) continue;
            const double factor = rows[i][k] / rows[k][k];
            for (size_t j = k; j <= count; ++j) rows[i][j] -= factor * rows[k][j];
        }
    }
    std::vector<double> unknowns;
    for (size_t k = 0; k < count; ++k) unknowns.push_back(rows[k][count] / rows[k][k]);
    return unknowns;
}

/// The weights whose sum of smooth rings has the least squared difference from the lobe over the
/// sphere, with sum 1: normal equations and a multiplier.
std::vector<double> weightsOf(const std::vector<Ring>& rings, double width)
{
    const std::vector<Sample> samples = samplesOf(width);
    std::vector<std::vector<double>> smooth;
    for (const Ring& ring : rings) smooth.push_back(smoothRing(ring, samples));
    const size_t count = rings.size();
    std::vector<std::vector<double>> rows(count + 1, std::vector<double>(count + 2, 0.0));
    for (size_t k = 0; k < count; ++k) {
        for (size_t i = 0; i < samples.size(); ++i) {
            const double value = smooth[k][i] * samples[i].zone;
            for (size_t j = 0; j < count; ++j) rows[k][j] += value * smooth[j][i];
            rows[k][count + 1] += value * stretchedCosine(std::cos(samples[i].angle), width);
        }
    }
    const double scale = rows[0][0];
    for (size_t k = 0; k < count; ++k) rows[k][count] = rows[count][k] = scale;
    rows[count][count + 1] = scale;
    std::vector<double> weights = solved(std::move(rows));
    weights.pop_back();
    // A ring about the axis can come out a permille below 0.
    double sum = 0.0;
    for (double& weight : weights) sum += weight = std::max(weight, 0.0);
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace

std::vector<LobeCell> lobeCells(int level)
{
    FBRDF_ASSERT(level, >=, 0);
    FBRDF_ASSERT(level, <=, kCosineLevel);
    const double width = lobeWidth(level);
    const std::vector<Ring> rings = ringsOf(kCellSides[level], width);
    const std::vector<double> weights = weightsOf(rings, width);
    std::vector<LobeCell> cells;
    for (size_t k = 0; k < rings.size(); ++k)
        for (int i = 0; i < rings[k].cells; ++i) {
            const double turn = i + (k % 2 == 1 ? 0.5 : 0.0);  // every other ring by half a cell
            const double azimuth = 2.0 * kPi * turn / rings[k].cells, angle = rings[k].middle;
            const Vec3d direction(std::sin(angle) * std::cos(azimuth),
                                  std::sin(angle) * std::sin(azimuth), std::cos(angle));
            cells.push_back({Vec3f(direction), static_cast<float>(weights[k] / rings[k].cells),
                             static_cast<float>(rings[k].solidAngle)});
        }
    FBRDF_ASSERT(cells.size(), <=, size_t(kMostCells));
    return cells;
}

}  // namespace fbrdf
