// Rows.h - one sample, one sparse row: the unknowns that a form mixes at a pair of directions.
//
// Unknowns are log2 texels. A symmetric table's (i, j) and (j, i) are one unknown; a table that
// several factors use (p of pqp) is one set of unknowns, so reciprocity is exact. With a shared
// shape R, G and B have the same texels and differ by a level: three more unknowns a term.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/sources/Source.h>

#include <array>
#include <vector>

namespace fbrdf {

/// The place of each texel of each table in the vector of unknowns.
///
/// The unknowns of the largest table that one factor of one term alone looks up come first. A
/// sample couples neighbours of it only, so their block of the normal equations is banded
/// (NormalSystem.h): they are numbered along the shorter axes first, which keeps the band narrow.
class Layout {
public:
    explicit Layout(const Form& form, bool sharedShape = false);
    int unknowns() const { return count_; }
    int unknownOf(size_t table, int texel) const
    {
        return unknownOf_[table][static_cast<size_t>(texel)];
    }
    /// Levels of R, G, B of a term with a shared shape.
    bool sharedShape() const { return firstLevel_ < count_; }
    int levelOf(size_t term, int channel) const
    {
        return firstLevel_ + 3 * static_cast<int>(term) + channel;
    }
    /// Unknowns of the banded block, and how far apart two of them may lie that are coupled, by a
    /// sample or by smoothness.
    int banded() const { return banded_; }
    int bandwidth() const { return bandwidth_; }

private:
    int count_ = 0, firstLevel_ = 0, banded_ = 0, bandwidth_ = 0;
    std::vector<std::vector<int>> unknownOf_;
};

/// Makes rows, one after the other. A row has the entries of all terms, term after term;
/// termEnd[t] is one past the last entry of term t, and the last of them the width of every row.
/// Levels of a shared shape are no entries: their weight is always 1.
class RowMaker {
public:
    RowMaker(const Form& form, const Layout& layout);
    int width() const { return termEnd_.back(); }
    const std::vector<int>& termEnd() const { return termEnd_; }
    /// The entries of banded unknowns: [first, last) of every row.
    int bandedFirst() const { return bandedFirst_; }
    int bandedLast() const { return bandedLast_; }
    int bandwidth() const { return layout_.bandwidth(); }
    /// unknown, weight: width() entries each. The weights of each factor sum to 1.
    void make(const Sample& sample, int* unknown, float* weight) const;

private:
    const Form& form_;
    const Layout& layout_;
    std::vector<std::array<int, 3>> sizes_;  ///< domainSize of each table
    std::vector<int> termEnd_;
    int bandedFirst_ = 0, bandedLast_ = 0;
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
