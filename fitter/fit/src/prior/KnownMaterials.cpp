// What is seen of a table: pixels of the standard sphere are sums of f over lights, so the
// derivative of a pixel by a log2 texel is ln 2 times the sum of f weight b over its terms.
#include <fbrdf/fit/LearnPrior.h>

#include "forms/NamedForms.h"
#include "prior/PriorCovariance.h"
#include "prior/PriorSample.h"
#include "prior/TableNumbers.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/metrics/StandardSphere.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

using Index = Eigen::Index;

constexpr int kHalves = 90, kDifferences = 30, kAzimuths = 24;  // of the grid that is fitted to
constexpr int kSphere = 64;                                     // pixels on a side
constexpr int kEveryPixel = 3;                                  // of which one is looked at
constexpr double kSmooth = 3e-3, kRidge = 1e-6;

/// Pairs of directions, each with the unknowns that it mixes, and what it counts.
struct PairRows {
    std::vector<DirectionPair<double>> pairs;
    std::vector<int> unknown;
    std::vector<float> weight;
    size_t width = 0;
};

PairRows rowsAt(std::vector<DirectionPair<double>> pairs, const RowMaker& maker)
{
    PairRows rows;
    rows.width = static_cast<size_t>(maker.width());
    rows.pairs = std::move(pairs);
    rows.unknown.resize(rows.pairs.size() * rows.width);
    rows.weight.resize(rows.unknown.size());
    for (size_t i = 0; i < rows.pairs.size(); ++i)
        maker.make({Vec3f(rows.pairs[i].wo), Vec3f(rows.pairs[i].wi), {}},
                   &rows.unknown[i * rows.width], &rows.weight[i * rows.width]);
    return rows;
}

// The centres of cells as files of MERL have them (Matusik et al. 2003), fewer of theta_d and
// phi_d.
std::vector<DirectionPair<double>> gridPairs()
{
    std::vector<DirectionPair<double>> pairs;
    const double least = std::sin(kMinElevation);
    for (int h = 0; h < kHalves; ++h)
        for (int d = 0; d < kDifferences; ++d)
            for (int p = 0; p < kAzimuths; ++p) {
                const double u = (h + 0.5) / kHalves;
                const auto pair = pairFromHalfDifference({u * u * kPi / 2.0, 0.0,
                                                          (d + 0.5) / kDifferences * kPi / 2.0,
                                                          (p + 0.5) / kAzimuths * kPi});
                if (pair.wo.z > least && pair.wi.z > least) pairs.push_back(pair);
            }
    return pairs;
}

std::vector<Vec3d> valuesOf(const Source& source, const PairRows& rows, int threads)
{
    std::vector<Vec3d> values(rows.pairs.size());
    parallelFor(values.size(), threads, [&](size_t i) {
        values[i] = glm::max(source.evaluate(rows.pairs[i].wo, rows.pairs[i].wi), Vec3d(0.0));
    });
    return values;
}

void addRow(const PairRows& rows, size_t i, double weight, PriorMatrix& normal)
{
    const int* unknown = &rows.unknown[i * rows.width];
    const float* share = &rows.weight[i * rows.width];
    for (size_t a = 0; a < rows.width; ++a)
        for (size_t b = 0; b < rows.width; ++b)
            normal(unknown[a], unknown[b]) +=
                weight * static_cast<double>(share[a]) * static_cast<double>(share[b]);
}

// The constant that can move between the tables, so that two materials compare: the mean of the
// second is 0.
void fixGauge(PriorMatrix& x, const Layout& layout, const Form& form)
{
    const std::vector<size_t> order = unknownsInOrder(form, layout);
    const auto first = static_cast<size_t>(texelCount(form.tables[0].domain));
    for (Index c = 0; c < x.cols(); ++c) {
        double mean = 0.0;
        for (size_t i = first; i < order.size(); ++i) mean += x(static_cast<Index>(order[i]), c);
        mean /= static_cast<double>(order.size() - first);
        for (size_t i = 0; i < order.size(); ++i)
            x(static_cast<Index>(order[i]), c) += i < first ? mean : -mean;
    }
}

// log2 texels of the three channels: unknowns x 3.
PriorMatrix fitted(const PairRows& rows, const std::vector<Vec3d>& values,
                   const PriorMatrix& smooth)
{
    PriorMatrix normal = kSmooth * smooth;
    normal.diagonal().array() += kRidge;
    PriorMatrix right = PriorMatrix::Zero(normal.rows(), 3);
    for (size_t i = 0; i < values.size(); ++i) {
        const double weight = weightOfPriorSample((values[i].x + values[i].y + values[i].z) / 3.0);
        addRow(rows, i, weight, normal);
        for (size_t a = i * rows.width; a < (i + 1) * rows.width; ++a)
            for (int c = 0; c < 3; ++c)
                right(rows.unknown[a], c) +=
                    weight * static_cast<double>(rows.weight[a]) * log2OfPriorSample(values[i][c]);
    }
    return Eigen::LLT<PriorMatrix>(normal).solve(right);
}

/// The terms of some pixels of the sphere.
struct SeenPixels {
    PairRows rows;
    std::vector<double> weight;  ///< of green
    std::vector<size_t> end;     ///< one past the last term of each pixel
};

SeenPixels seenPixels(const RowMaker& maker)
{
    SeenPixels pixels;
    std::vector<DirectionPair<double>> pairs;
    int last = -1;
    for (const SphereTerm& term : standardSphereTerms(kSphere)) {
        if (term.pixel % kEveryPixel != 0) continue;
        if (term.pixel != last && last >= 0) pixels.end.push_back(pairs.size());
        last = term.pixel;
        pairs.push_back(term.pair);
        pixels.weight.push_back(term.weight.y);
    }
    pixels.end.push_back(pairs.size());
    pixels.rows = rowsAt(std::move(pairs), maker);
    return pixels;
}

// J^T J of a material, trace 1.
PriorMatrix seenOf(const SeenPixels& pixels, const std::vector<Vec3d>& values, Index unknowns)
{
    PriorMatrix jacobian = PriorMatrix::Zero(static_cast<Index>(pixels.end.size()), unknowns);
    size_t term = 0;
    for (size_t p = 0; p < pixels.end.size(); ++p) {
        double pixel = 0.0;
        auto row = jacobian.row(static_cast<Index>(p));
        for (; term < pixels.end[p]; ++term) {
            const Vec3d& f = values[term];
            const double share = pixels.weight[term] * (f.x + f.y + f.z) / 3.0;
            pixel += share;
            for (size_t a = term * pixels.rows.width; a < (term + 1) * pixels.rows.width; ++a)
                row(pixels.rows.unknown[a]) += share * static_cast<double>(pixels.rows.weight[a]);
        }
        if (pixel >= 1.0) row.setZero();
    }
    PriorMatrix seen = PriorMatrix::Zero(unknowns, unknowns);
    seen.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
    const double trace = seen.trace();
    return seen / (trace > 0.0 ? trace : 1.0);
}

std::vector<double> numbersOf(const PriorMatrix& matrix)
{
    return {matrix.data(), matrix.data() + matrix.size()};
}

}  // namespace

KnownMaterials knownMaterials(const std::vector<Source>& functions, int threads)
{
    if (functions.empty())
        throw Error(ErrorKind::usage, "prior", Found("no material").expected("at least one"));
    for (const Source& source : functions)
        if (!source.evaluate)
            throw Error(ErrorKind::fit, source.name, Found("samples").expected("a function"));
    KnownMaterials known;
    known.form = makeForm("hdio");
    const Layout layout(known.form);
    const RowMaker maker(known.form, layout);
    const PairRows grid = rowsAt(gridPairs(), maker);
    const SeenPixels pixels = seenPixels(maker);
    const PriorMatrix smooth = roughness(known.form, layout);
    known.tables.resize(3 * functions.size());
    std::vector<PriorMatrix> parts(functions.size());
    parallelTasks(functions.size(), threads, [&](size_t k) {
        PriorMatrix x = fitted(grid, valuesOf(functions[k], grid, 1), smooth);
        fixGauge(x, layout, known.form);
        for (size_t c = 0; c < 3; ++c)
            known.tables[3 * k + c] = numbersOf(x.col(static_cast<Index>(c)));
        parts[k] = seenOf(pixels, valuesOf(functions[k], pixels.rows, 1), layout.unknowns());
    });
    PriorMatrix seen = PriorMatrix::Zero(layout.unknowns(), layout.unknowns()), sampled = seen;
    for (const PriorMatrix& part : parts) seen += part / static_cast<double>(parts.size());
    for (size_t i = 0; i < grid.pairs.size(); ++i) addRow(grid, i, 1.0, sampled);
    known.seen = numbersOf(seen);
    known.sampled = numbersOf(sampled / sampled.trace());
    return known;
}

}  // namespace fbrdf
