#include "prior/PriorUse.h"

namespace fbrdf {

std::shared_ptr<const PriorCovariance> priorFor(const FitContext& context)
{
    const FitOptions& options = context.options;
    const bool isItsForm = !options.formData && (isSearched(options) || options.form == "hdio");
    const bool isFree = options.usePrior && !options.sharedShape && !options.smoothness &&
                        options.resolution == 0 && options.metric == Metric::log &&
                        options.ranks.count == 1;
    const bool isFew = !context.dataset.exact && context.dataset.rows < kSmallSet;
    if (!isItsForm || !isFree || !isFew) return nullptr;
    return std::make_shared<PriorCovariance>(options.prior ? *options.prior : shippedTablePrior());
}

}  // namespace fbrdf
