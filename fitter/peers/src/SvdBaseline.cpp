#include <fbrdf/peers/SvdBaseline.h>

#include <fbrdf/brdf/Error.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/Metrics.h>

#include <algorithm>
#include <cmath>
#include <Eigen/SVD>

namespace fbrdf {
namespace {

constexpr double kHalfPi = kPi / 2;
constexpr size_t kBytesPerTexel = 2;  // as a half float
constexpr double kHorizon = 0.03;  // cosine below which a pair counts as below the horizon: values
                                   // that grow without end there would take every term

size_t rowsOf(const SvdGrid& grid)
{
    return static_cast<size_t>(grid.thetaH) * static_cast<size_t>(grid.phiH);
}

size_t columnsOf(const SvdGrid& grid)
{
    return static_cast<size_t>(grid.thetaD) * static_cast<size_t>(grid.phiD);
}

// Knots: theta = 0 and pi/2 are the first and the last; phi is periodic.
HalfDifference anglesAt(const SvdGrid& grid, size_t row, size_t column)
{
    const auto share = [](size_t i, int count) { return static_cast<double>(i) / count; };
    const auto thetaH = static_cast<size_t>(grid.thetaH), thetaD = static_cast<size_t>(grid.thetaD);
    const double root = share(row % thetaH, grid.thetaH - 1);
    HalfDifference angles{};
    angles.theta_h = root * root * kHalfPi;
    angles.phi_h = 2.0 * kPi * share(row / thetaH, grid.phiH);
    angles.theta_d = share(column % thetaD, grid.thetaD - 1) * kHalfPi;
    angles.phi_d = 2.0 * kPi * share(column / thetaD, grid.phiD);
    return angles;
}

using Matrix = Eigen::MatrixXd;

bool isAbove(const DirectionPair<double>& pair)
{
    return pair.wo.z > kHorizon && pair.wi.z > kHorizon;
}

// One pair a cell, row after row. A cell below the horizon takes the pair of the cell before it
// along theta_h, which leaves rows alike, as few terms want them; along theta_d where there is
// none.
std::vector<Sample> pairsOf(const SvdGrid& grid)
{
    const size_t columns = columnsOf(grid), thetaH = static_cast<size_t>(grid.thetaH);
    std::vector<Sample> pairs(rowsOf(grid) * columns);
    for (size_t i = 0; i < pairs.size(); ++i) {
        const size_t row = i / columns, column = i % columns;
        const auto pair = pairFromHalfDifference(anglesAt(grid, row, column));
        if (isAbove(pair)) {
            pairs[i].wo = Vec3f(pair.wo);
            pairs[i].wi = Vec3f(pair.wi);
        } else {
            pairs[i] = pairs[row % thetaH > 0 ? i - columns : i - 1];
        }
    }
    return pairs;
}

Matrix matrixOf(const std::vector<Vec3f>& values, const SvdGrid& grid, int channel)
{
    const size_t columns = columnsOf(grid);
    Matrix matrix(static_cast<Eigen::Index>(rowsOf(grid)), static_cast<Eigen::Index>(columns));
    for (size_t i = 0; i < values.size(); ++i)
        matrix(static_cast<Eigen::Index>(i / columns), static_cast<Eigen::Index>(i % columns)) =
            static_cast<double>(values[i][channel]);
    return matrix;
}

// Two neighbours along an axis and the weight of the second.
struct Between {
    size_t lower, upper;
    double blend;
};

Between clamped(double position, int size)
{
    const double x = std::clamp(position, 0.0, static_cast<double>(size - 1));
    const auto lower = std::min(static_cast<size_t>(x), static_cast<size_t>(std::max(0, size - 2)));
    const size_t upper = std::min(lower + 1, static_cast<size_t>(size - 1));
    return {lower, upper, x - static_cast<double>(lower)};
}

Between periodic(double angle, int size)
{
    const double turns = angle / (2.0 * kPi);
    const double x = (turns - std::floor(turns)) * size;
    const auto n = static_cast<size_t>(size);
    const auto lower = static_cast<size_t>(x) % n;
    return {lower, (lower + 1) % n, x - std::floor(x)};
}

double lookUp(const float* table, int width, const Between& x, const Between& y)
{
    const auto at = [&](size_t i, size_t j) {
        return static_cast<double>(table[j * static_cast<size_t>(width) + i]);
    };
    const double first = at(x.lower, y.lower) * (1.0 - x.blend) + at(x.upper, y.lower) * x.blend;
    const double second = at(x.lower, y.upper) * (1.0 - x.blend) + at(x.upper, y.upper) * x.blend;
    return first * (1.0 - y.blend) + second * y.blend;
}

void checkTerms(const SvdGrid& grid, int terms)
{
    const size_t most = std::min(rowsOf(grid), columnsOf(grid));
    if (terms < 1 || static_cast<size_t>(terms) > most)
        throw Error(
            ErrorKind::usage, "terms",
            "found " + std::to_string(terms) + ", expected between 1 and " + std::to_string(most));
}

}  // namespace

SvdModel fitSvd(const BrdfFunction& brdf, const SvdGrid& grid, int terms, int threads)
{
    checkTerms(grid, terms);
    SvdModel model;
    model.grid = grid;
    model.terms = terms;
    const std::vector<Vec3f> values = evaluateAt(brdf, pairsOf(grid), threads);
    for (size_t c = 0; c < 3; ++c) {
        const Eigen::BDCSVD<Matrix> svd(matrixOf(values, grid, static_cast<int>(c)),
                                        Eigen::ComputeThinU | Eigen::ComputeThinV);
        for (Eigen::Index k = 0; k < terms; ++k) {
            const double value = svd.singularValues()[k];
            for (Eigen::Index i = 0; i < svd.matrixU().rows(); ++i)
                model.u[c].push_back(static_cast<float>(value * svd.matrixU()(i, k)));
            for (Eigen::Index i = 0; i < svd.matrixV().rows(); ++i)
                model.v[c].push_back(static_cast<float>(svd.matrixV()(i, k)));
        }
    }
    return model;
}

Vec3d evaluate(const SvdModel& model, const Vec3d& wo, const Vec3d& wi)
{
    if (!(wo.z > 0.0 && wi.z > 0.0)) return Vec3d(0.0);
    const SvdGrid& grid = model.grid;
    const HalfDifference angles = halfDifferenceFromPair({wo, wi});
    const Between h = clamped(std::sqrt(angles.theta_h / kHalfPi) * (grid.thetaH - 1), grid.thetaH);
    const Between hPhi = periodic(angles.phi_h, grid.phiH);
    const Between d = clamped(angles.theta_d / kHalfPi * (grid.thetaD - 1), grid.thetaD);
    const Between dPhi = periodic(angles.phi_d, grid.phiD);
    const size_t rows = rowsOf(grid), columns = columnsOf(grid);
    Vec3d f(0.0);
    for (size_t c = 0; c < 3; ++c)
        for (size_t k = 0; k < static_cast<size_t>(model.terms); ++k)
            f[static_cast<int>(c)] += lookUp(&model.u[c][k * rows], grid.thetaH, h, hPhi) *
                                      lookUp(&model.v[c][k * columns], grid.thetaD, d, dPhi);
    return f;
}

size_t bytesOf(const SvdModel& model)
{
    return static_cast<size_t>(model.terms) * 3 * kBytesPerTexel *
           (rowsOf(model.grid) + columnsOf(model.grid));
}

}  // namespace fbrdf
