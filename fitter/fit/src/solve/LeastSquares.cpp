#include "solve/LeastSquares.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/fit/FormKey.h>

namespace fbrdf {
namespace {

std::string keyOf(const Dataset& dataset, const Form& form, const LeastSquaresOptions& options,
                  int threads)
{
    if (!options.cache || options.sharedShape) return {};
    const std::string geometry = geometryOf(dataset, threads);
    return geometry.empty() ? geometry : geometry + "|" + formKey(form);
}

std::shared_ptr<const RowGeometries> knownRows(const std::string& key,
                                               const LeastSquaresOptions& options)
{
    return key.empty() ? nullptr : options.cache->rows(key);
}

}  // namespace

LeastSquares::LeastSquares(Form form, Dataset dataset, const DataStatistics& statistics,
                           uint64_t seed, int threads, const LeastSquaresOptions& options)
    : form_(std::move(form)),
      dataset_(std::move(dataset)),
      statistics_(statistics),
      options_(options),
      layout_(form_, options.sharedShape),
      maker_(form_, layout_),
      smoothness_(form_, layout_),
      seed_(seed),
      threads_(threads),
      cacheKey_(keyOf(dataset_, form_, options, threads)),
      store_(std::make_unique<RowStore>(maker_, dataset_, statistics_, threads,
                                        knownRows(cacheKey_, options)))
{
    if (!cacheKey_.empty() && store_->geometry())
        options.cache->keepRows(cacheKey_, store_->geometry());
}

LeastSquares LeastSquares::thinned(size_t rows, int excludedFold) const
{
    Dataset thin = datasetInMemory(
        someSamples(dataset_, FoldChoice::allBut(excludedFold), rows, seed_, threads_));
    thin.exact = dataset_.exact;
    LeastSquaresOptions options = options_;
    options.ranks = {};  // small enough for each process to solve it by itself
    return LeastSquares(form_, std::move(thin), statistics_, seed_, threads_, options);
}

bool LeastSquares::hasWholeNoise() const
{
    constexpr size_t kManyRows = 20000;
    return statistics_.unclipped && dataset_.rows >= kManyRows;
}

LeastSquares LeastSquares::withForm(const Form& form) const
{
    LeastSquaresOptions options = options_;
    options.solver = SystemSolver::automatic;
    return LeastSquares(form, dataset_, statistics_, seed_, threads_, options);
}

State LeastSquares::flatState() const
{
    const size_t n = unknowns();
    State x(columns() * n, 0.0);
    std::vector<size_t> lastTerm(form_.tables.size(), 0);
    for (size_t t = 0; t < form_.terms.size(); ++t)
        for (const Factor& factor : form_.terms[t].factors)
            lastTerm[static_cast<size_t>(factor.table)] = t;
    const auto levelOf = [this](size_t term) {
        return term + 1 == form_.terms.size() ? statistics_.level : statistics_.low;
    };
    if (layout_.sharedShape()) {
        for (size_t t = 0; t < form_.terms.size(); ++t)
            for (int c = 0; c < 3; ++c)
                x[static_cast<size_t>(layout_.levelOf(t, c))] = static_cast<double>(levelOf(t)[c]);
        return x;
    }
    for (size_t table = 0; table < form_.tables.size(); ++table) {
        const size_t t = lastTerm[table];
        const Vec3f level = levelOf(t) / static_cast<float>(form_.terms[t].factors.size());
        for (int i = 0; i < texelCount(form_.tables[table].domain); ++i)
            for (size_t c = 0; c < 3; ++c)
                x[c * n + static_cast<size_t>(layout_.unknownOf(table, i))] =
                    static_cast<double>(level[static_cast<int>(c)]);
    }
    return x;
}

}  // namespace fbrdf
