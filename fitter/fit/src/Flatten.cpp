#include "Flatten.h"

#include "Conserve.h"
#include "Quantize.h"
#include "Unsampled.h"

#include <fbrdf/base/Assert.h>

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace fbrdf {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double kGauge = 1e-9;  // holds texels that no row of smoothness leads to

/// The unknowns that may move, numbered.
struct FreeUnknowns {
    std::vector<int> place;  ///< of every unknown; -1: it stays
    int count = 0;

    FreeUnknowns(const Material& fitted, const Layout& layout)
        : place(static_cast<size_t>(layout.unknowns()), -1)
    {
        for (size_t t = 0; t < fitted.tables.size(); ++t) {
            const std::vector<bool>& unsupported = fitted.tables[t].unsupported;
            for (size_t i = 0; i < unsupported.size(); ++i) {
                int& at = place[static_cast<size_t>(layout.unknownOf(t, static_cast<int>(i)))];
                if (unsupported[i] && at < 0) at = count++;
            }
        }
    }
    int of(const SmoothnessRow& row, int k) const
    {
        return place[static_cast<size_t>(row.unknown[k])];
    }
};

// The free unknowns with the least squares of all rows of smoothness, whose first differences count
// `firstOrder` times as much as their second ones; the others as x has them.
State extended(const Form& form, const Layout& layout, const FreeUnknowns& free, double firstOrder,
               State x)
{
    const auto unknowns = static_cast<size_t>(layout.unknowns());
    const auto columns = static_cast<Eigen::Index>(x.size() / unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(free.count, columns);
    for (const SmoothnessRow& row : smoothnessRows(form, layout, firstOrder))
        for (int a = 0; a < row.count; ++a) {
            const int at = free.of(row, a);
            if (at < 0) continue;
            for (int b = 0; b < row.count; ++b) {
                const double product = row.weight[a] * row.weight[b];
                const int other = free.of(row, b);
                if (other >= 0) entries.emplace_back(at, other, product);
                for (Eigen::Index c = 0; other < 0 && c < columns; ++c)
                    right(at, c) -=
                        product *
                        x[static_cast<size_t>(c) * unknowns + static_cast<size_t>(row.unknown[b])];
            }
        }
    for (int u = 0; u < free.count; ++u) entries.emplace_back(u, u, kGauge);
    SparseMatrix matrix(free.count, free.count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd solution = Eigen::SimplicialLDLT<SparseMatrix>(matrix).solve(right);
    for (size_t u = 0; u < unknowns; ++u)
        for (Eigen::Index c = 0; free.place[u] >= 0 && c < columns; ++c)
            x[static_cast<size_t>(c) * unknowns + u] = solution(free.place[u], c);
    std::vector<double> weights(unknowns);
    for (size_t u = 0; u < unknowns; ++u) weights[u] = free.place[u] < 0 ? 1.0 : 0.0;
    extendHue(form, layout, weights, x);
    return x;
}

Material quantizedLike(const Material& fitted, const Layout& layout, const State& x,
                       Storage storage)
{
    Material material = quantize(fitted.form, layout, x, storage);
    for (size_t t = 0; t < material.tables.size(); ++t)
        material.tables[t].unsupported = fitted.tables[t].unsupported;
    return material;
}

struct Extension {
    State x;
    Material material;
    double albedo;
};

}  // namespace

void flattenGaps(const FitContext& context, Fitted& fitted)
{
    constexpr double kFirstOrders[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 50.0};  // 0.03 is that of fits
    constexpr double kNearLeast = 1.1;
    const FitOptions& options = context.options;
    State& x = fitted.solution.x;
    FBRDF_ASSERT(x.empty(), ==, false);
    const Layout layout(fitted.material.form, options.sharedShape);
    const FreeUnknowns free(fitted.material, layout);
    const double asFitted = largestAlbedo(fitted.material, options.threads);
    if (free.count == 0 || asFitted <= 1.0) return;
    std::vector<Extension> extensions{{x, fitted.material, asFitted}};
    for (const double firstOrder : kFirstOrders) {
        State next = extended(fitted.material.form, layout, free, firstOrder, x);
        Material material = quantizedLike(fitted.material, layout, next, options.storage);
        const double albedo = largestAlbedo(material, options.threads);
        extensions.push_back({std::move(next), std::move(material), albedo});
        if (albedo <= 1.0) break;
    }
    const auto byAlbedo = [](const Extension& a, const Extension& b) {
        return a.albedo < b.albedo;
    };
    const double least = std::min_element(extensions.begin(), extensions.end(), byAlbedo)->albedo;
    const auto chosen = std::find_if(extensions.begin(), extensions.end(), [&](const Extension& e) {
        return e.albedo <= std::max(1.0, kNearLeast * least);
    });
    x = std::move(chosen->x);
    fitted.material = std::move(chosen->material);
}

}  // namespace fbrdf
