#include "Support.h"

namespace fbrdf {

void markUnsupported(Material& material, const Layout& layout, const std::vector<double>& support)
{
    for (size_t t = 0; t < material.tables.size(); ++t) {
        Table& table = material.tables[t];
        const int texels = texelCount(table.domain);
        table.unsupported.assign(static_cast<size_t>(texels), false);
        for (int i = 0; i < texels; ++i)
            table.unsupported[static_cast<size_t>(i)] =
                isReachable(table.domain, i) &&
                !(support[static_cast<size_t>(layout.unknownOf(t, i))] > kSupport);
    }
}

}  // namespace fbrdf
