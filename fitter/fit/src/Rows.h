// Rows.h - one sample, one sparse row: the unknowns that a form mixes at a pair of directions.
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

/// Makes rows, one after the other. A row holds the entries of all terms, term after term;
/// termEnd[t] is one past the last entry of term t, and the last of them the width of every row.
class RowMaker {
public:
    RowMaker(const Form& form, const Layout& layout);
    int width() const { return termEnd_.back(); }
    const std::vector<int>& termEnd() const { return termEnd_; }
    /// unknown, weight: width() entries each. The weights of each factor sum to 1.
    void make(const Sample& sample, int* unknown, float* weight) const;

private:
    const Form& form_;
    const Layout& layout_;
    std::vector<int> termEnd_;
};

/// Smoothness: rows that are 0 where a table is linear along its axes.
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
