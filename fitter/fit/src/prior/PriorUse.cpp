#include "prior/PriorUse.h"

#include "forms/NamedForms.h"

namespace fbrdf {
namespace {

TablePrior priorOf(const FitOptions& options)
{
    return options.prior ? *options.prior : shippedTablePrior();
}

bool isWithinLimits(const Form& form, const FitOptions& options)
{
    return lookupsPerPass(form) <= options.lookups &&
           (options.maxBytes == 0 || formBytes(form, options.storage) <= options.maxBytes);
}

}  // namespace

bool mayUsePrior(const Dataset& dataset, const FitOptions& options)
{
    const bool isItsForm = !options.formData && (isSearched(options) || options.form == "hdio");
    const bool isFree = options.usePrior && !options.sharedShape && !options.smoothness &&
                        options.resolution == 0 && options.metric == Metric::log &&
                        options.ranks.count == 1;
    const bool isFew = !dataset.exact && dataset.rows < kSmallSet;
    return isItsForm && isFree && isFew && isWithinLimits(priorOf(options).form, options);
}

std::shared_ptr<const PriorCovariance> priorFor(const FitContext& context)
{
    if (!mayUsePrior(context.dataset, context.options)) return nullptr;
    return std::make_shared<PriorCovariance>(priorOf(context.options));
}

}  // namespace fbrdf
