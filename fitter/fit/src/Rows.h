// Rows.h - one sample, one sparse row: the unknowns that a term of a form mixes at a pair of
// directions.
//
// Unknowns are log2 texels. A symmetric table's (i, j) and (j, i) are one unknown; a table that
// several factors use (p of pqp) is one set of unknowns, so reciprocity is exact.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

/// Where each texel of each table sits in the vector of unknowns.
class Layout {
public:
    explicit Layout(const Form& form);
    int unknowns() const { return count_; }
    int unknownOf(size_t table, int texel) const
    {
        return unknownOf_[table][static_cast<size_t>(texel)];
    }

private:
    int count_ = 0;
    std::vector<std::vector<int>> unknownOf_;
};

/// The rows of one term at many samples: `width` entries each, contiguous.
struct RowSet {
    int width = 0;
    std::vector<int> unknown;   ///< samples x width
    std::vector<float> weight;  ///< samples x width; each factor's weights sum to 1
};

/// Entries a row of the term has.
int rowWidth(const Form& form, const Term& term);

RowSet makeRows(const Form& form, const Layout& layout, const Term& term,
                const std::vector<Sample>& samples, int threads);

/// Smoothness: rows that are 0 where a table is linear along its axes, three or two entries each.
struct SmoothnessRow {
    int count = 0;
    int unknown[3];
    double weight[3];
    int table;
};

/// Second differences along every axis of every table, and first differences `firstOrder` times as
/// strong: they decide only where no sample and no curvature does, and keep extrapolation from
/// running away.
std::vector<SmoothnessRow> smoothnessRows(const Form& form, const Layout& layout,
                                          double firstOrder);

}  // namespace fbrdf
