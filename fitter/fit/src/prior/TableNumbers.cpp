#include "prior/TableNumbers.h"

namespace fbrdf {

std::vector<size_t> unknownsInOrder(const Form& form, const Layout& layout)
{
    std::vector<size_t> order;
    std::vector<char> isMet(static_cast<size_t>(layout.unknowns()), false);
    for (size_t t = 0; t < form.tables.size(); ++t)
        for (int i = 0; i < texelCount(form.tables[t].domain); ++i) {
            const auto unknown = static_cast<size_t>(layout.unknownOf(t, i));
            if (isMet[unknown]) continue;
            isMet[unknown] = true;
            order.push_back(unknown);
        }
    return order;
}

}  // namespace fbrdf
