// Leading singular vectors by orthogonal iteration (Halko, Martinsson, Tropp 2011, Algorithm 4.4),
// then alternating least squares over the cells that have a value: a third of the matrix is below
// the horizon, and a fit of what was filled in there would cost terms (Srebro and Jaakkola 2003,
// "Weighted Low-Rank Approximations").
#include <fbrdf/fit/Svd.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/Metrics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace fbrdf {
namespace {

// Cosine below which a pair counts as below the horizon: values that grow without end there would
// take every term.
constexpr double kHorizon = 0.03;
// The weight of a cell without a value, which decides only where nothing else does.
constexpr double kFilledWeight = 1e-4;
constexpr int kIterations = 8, kSpare = 8;  // of the start: vectors beside those asked for
constexpr int kSweeps = 24;                 // of the alternating least squares
constexpr double kDiscGamma = 0.5;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Axis cosineAxis(int size, double exponent)
{
    return {size, {AxisMap::From::oneMinusCosine, exponent}};
}

Axis halfAxis(int size)
{
    return cosineAxis(size, 0.25);
}

std::vector<Axis> differenceAxes(int size)
{
    return {cosineAxis(std::max(2, size / 4), 0.5), cosineAxis(size / 8 + 1, 0.5)};
}

DiscDomain discOf(int size)
{
    return DiscDomain::fitting(size / 2, kDiscGamma);
}

// A vector by its angles from a pole.
struct Polar {
    double theta, phi;
};

Polar polarAt(const Domain& domain, int texel)
{
    if (const auto* disc = std::get_if<DiscDomain>(&domain)) {
        const Vec3d v =
            directionFromDiscPosition(*disc, Vec2<double>(texel % disc->size, texel / disc->size));
        return {std::acos(std::min(v.z, 1.0)), std::atan2(v.y, v.x)};
    }
    const auto& axes = std::get<GridDomain>(domain).axes;
    const auto angleAt = [&](size_t axis, int knot) {
        return angleFromAxisCoordinate(axes[axis].map,
                                       static_cast<double>(knot) / (axes[axis].size - 1));
    };
    return {angleAt(0, texel % axes[0].size),
            axes.size() > 1 ? angleAt(1, texel / axes[0].size) : 0.0};
}

// The matrix of one function: its cells' values, a channel each, and what they weigh.
struct Resampled {
    std::array<Matrix, 3> values;
    Matrix weights;
};

// A cell below the horizon takes the pair of a cell before it, in the same column or in the same
// row. The first row and column are above: h or d is the normal there.
std::vector<Sample> pairsOf(const Domain& rows, const Domain& columns, Matrix& weights)
{
    const Eigen::Index n = texelCount(rows), m = texelCount(columns);
    std::vector<Sample> pairs(static_cast<size_t>(n * m));
    weights = Matrix::Constant(n, m, kFilledWeight);
    Sample above{Vec3f(0.0f, 0.0f, 1.0f), Vec3f(0.0f, 0.0f, 1.0f), Vec3f(0.0f)};
    for (Eigen::Index column = 0; column < m; ++column) {
        const Polar d = polarAt(columns, static_cast<int>(column));
        for (Eigen::Index row = 0; row < n; ++row) {
            const Polar h = polarAt(rows, static_cast<int>(row));
            const auto pair = pairFromHalfDifference({h.theta, h.phi, d.theta, d.phi});
            const bool isAbove = pair.wo.z > kHorizon && pair.wi.z > kHorizon;
            if (isAbove) above = {Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(0.0f)};
            if (isAbove && isReachable(rows, static_cast<int>(row)) &&
                isReachable(columns, static_cast<int>(column)))
                weights(row, column) = 1.0;
            pairs[static_cast<size_t>(column * n + row)] = above;
        }
    }
    return pairs;
}

Resampled resampled(const BrdfFunction& brdf, const Form& form, int threads)
{
    Resampled result;
    const Domain &rows = form.tables[0].domain, &columns = form.tables[1].domain;
    const std::vector<Vec3f> values =
        evaluateAt(brdf, pairsOf(rows, columns, result.weights), threads);
    for (size_t c = 0; c < 3; ++c) {
        Matrix& matrix = result.values[c];
        matrix.resize(result.weights.rows(), result.weights.cols());
        for (size_t i = 0; i < values.size(); ++i)
            matrix.data()[i] = static_cast<double>(values[i][static_cast<int>(c)]);
    }
    return result;
}

Matrix orthonormal(const Matrix& matrix)
{
    const Eigen::HouseholderQR<Matrix> qr(matrix);
    return qr.householderQ() * Matrix::Identity(matrix.rows(), matrix.cols());
}

// Columns that span the leading right singular vectors.
Matrix leadingSpace(const Matrix& matrix, Eigen::Index terms)
{
    const Eigen::Index count = std::min(terms + kSpare, std::min(matrix.rows(), matrix.cols()));
    // Cosines of every order: any start that is orthogonal to nothing.
    Matrix space(matrix.cols(), count);
    for (Eigen::Index k = 0; k < count; ++k)
        for (Eigen::Index i = 0; i < space.rows(); ++i)
            space(i, k) = std::cos(kPi * (static_cast<double>(i) + 0.5) * static_cast<double>(k) /
                                   static_cast<double>(space.rows()));
    for (int i = 0; i < kIterations; ++i)
        space = orthonormal(matrix.transpose() * orthonormal(matrix * orthonormal(space)));
    const Eigen::JacobiSVD<Matrix> svd(matrix * space, Eigen::ComputeThinV);
    return space * svd.matrixV().leftCols(terms);
}

// Row i of the result makes row i of `matrix` best from the columns of `other`.
Matrix bestRows(const Matrix& matrix, const Matrix& weights, const Matrix& other)
{
    constexpr double kRidge = 1e-10;  // relative: rows that fewer cells than terms decide
    Matrix best(matrix.rows(), other.cols());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        const Vector w = weights.row(i).transpose();
        const Matrix weighted = w.asDiagonal() * other;
        Matrix normal = other.transpose() * weighted;
        normal.diagonal().array() += kRidge * (normal.trace() + kRidge);
        best.row(i) =
            normal.ldlt().solve(weighted.transpose() * matrix.row(i).transpose()).transpose();
    }
    return best;
}

// matrix ~ u diag(s) v^T with orthonormal u and v, s falling.
struct Terms {
    Matrix u, v;
    Vector s;
};

Terms termsOf(const Matrix& matrix, const Matrix& weights, Eigen::Index terms)
{
    const Matrix transposed = matrix.transpose(), transposedWeights = weights.transpose();
    Matrix v = leadingSpace(matrix, terms), u;
    for (int i = 0; i < kSweeps; ++i) {
        u = orthonormal(bestRows(matrix, weights, v));
        v = bestRows(transposed, transposedWeights, u);
    }
    const Eigen::JacobiSVD<Matrix> svd(v, Eigen::ComputeThinU | Eigen::ComputeThinV);
    return {u * svd.matrixV(), svd.matrixU(), svd.singularValues()};
}

// Column k as channel c of a table, scaled to a largest magnitude of 1; returns the scale.
double put(Table& table, int c, const Matrix& columns, Eigen::Index k)
{
    const double largest = columns.col(k).cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < columns.rows(); ++i)
        table.texels[static_cast<size_t>(3 * i + c)] = static_cast<float>(columns(i, k) / largest);
    return largest;
}

Material emptyMaterial(const Form& form)
{
    Material material;
    material.form = form;
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.storage = Storage::signedHalf;
        table.texels.resize(static_cast<size_t>(3 * texelCount(spec.domain)));
        material.tables.push_back(std::move(table));
    }
    material.scales.resize(form.terms.size());
    return material;
}

void checkTerms(const Form& form)
{
    const int most = std::min(
        {kMaxSvdTerms, texelCount(form.tables[0].domain), texelCount(form.tables[1].domain)});
    const auto terms = static_cast<int>(form.terms.size());
    if (terms < 1 || terms > most)
        throw Error(ErrorKind::usage, "form",
                    Found("svd of " + std::to_string(terms) + " terms")
                        .expected("1 to " + std::to_string(most)));
}

void roundToHalf(Table& table)
{
    for (float& texel : table.texels) texel = floatFromHalf(halfFromFloat(texel));
}

}  // namespace

Form formSvd(int terms, int size, bool isotropic)
{
    FBRDF_ASSERT(size, >=, 4);
    Form form;
    form.name = "svd" + std::to_string(terms);
    const Argument half = isotropic ? Argument(std::vector<Angle>{Angle::theta_h}) : Direction::h;
    const Argument difference =
        isotropic ? Argument(std::vector<Angle>{Angle::theta_d, Angle::phi_d}) : Direction::d;
    const Domain rows = isotropic ? Domain(GridDomain{{halfAxis(size)}}) : discOf(size);
    const Domain columns = isotropic ? Domain(GridDomain{differenceAxes(size)}) : discOf(size);
    for (int k = 0; k < terms; ++k) {
        const std::string number = std::to_string(k + 1);
        form.tables.push_back({"u" + number, rows});
        form.tables.push_back({"v" + number, columns});
        form.terms.push_back({{{2 * k, half}, {2 * k + 1, difference}}});
    }
    return form;
}

Form formSvdGrid(int size)
{
    std::vector<Axis> axes = differenceAxes(size);
    axes.insert(axes.begin(), halfAxis(size));
    return {"svd-grid",
            {{"V", GridDomain{axes}}},
            {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d, Angle::phi_d}}}}}};
}

Material svdMaterial(const BrdfFunction& brdf, const Form& form, int threads)
{
    checkTerms(form);
    const Resampled grid = resampled(brdf, form, threads);
    Material material = emptyMaterial(form);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<size_t>(c);
        const Terms found = termsOf(grid.values[channel], grid.weights,
                                    static_cast<Eigen::Index>(form.terms.size()));
        for (size_t k = 0; k < form.terms.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            const double scale = put(material.tables[2 * k], c, found.u, column) *
                                 put(material.tables[2 * k + 1], c, found.v, column);
            material.scales[k][c] = static_cast<float>(scale * found.s[column]);
        }
    }
    for (Table& table : material.tables) roundToHalf(table);
    return material;
}

}  // namespace fbrdf
