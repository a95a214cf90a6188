// SmoothSystem.h - the normal equations of the data with those of smoothness added, for any
// strength of it.
#pragma once
#include "solve/NormalSystem.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace fbrdf {

/// What is added to every diagonal, as a share of the mean diagonal of the data: it fixes the
/// gauge, the constants that can move between the factors of a term.
constexpr double kGaugeRidge = 1e-11;

/// Rows of smoothness, and how much a strength of 1 weighs in each table: the mean diagonal of the
/// data's matrix over the table's unknowns, so that one strength suits a form whose tables differ
/// in how many samples a texel sees.
struct Smoothness {
    std::vector<SmoothnessRow> rows;
    std::vector<std::vector<int>> unknowns;  ///< of each table, a mirrored texel's twice

    Smoothness(const Form& form, const Layout& layout);
    /// diagonal: unknowns, in the order of the layout.
    std::vector<double> scales(const std::vector<double>& diagonal) const;
};

class SmoothSystem {
public:
    /// `smoothness` must outlive the object, as must `workspace`, which the factors are made in and
    /// `data` is given back to.
    SmoothSystem(BorderedMatrix data, const Smoothness& smoothness, Workspace& workspace);
    SmoothSystem(const SmoothSystem&) = delete;
    ~SmoothSystem() { workspace_.giveBack(std::move(data_.values)); }

    /// The steps from x for the data's right-hand sides, both unknowns x columns, column
    /// contiguous. Throws Error(fit) naming `form` where the system is singular beyond repair.
    std::vector<double> step(std::vector<double> right, const double* x, size_t columns,
                             double strength, double damping, const std::string& form) const;
    /// From now on factorizations without damping are kept: for systems that many fits share.
    void keepFactors() { keeps_ = true; }

private:
    Cholesky factored(double strength, double damping) const;
    std::shared_ptr<const Cholesky> keptFactor(double strength) const;

    BorderedMatrix data_;
    const Smoothness& smoothness_;
    Workspace& workspace_;
    std::vector<double> scales_;
    double ridge_ = 0.0;
    bool keeps_ = false;
    mutable std::mutex mutex_;
    mutable std::map<double, std::shared_ptr<const Cholesky>> kept_;
};

}  // namespace fbrdf
