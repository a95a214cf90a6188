// RglWarp.h - piecewise bilinear densities over the unit square, and the warp that makes them
// uniform: the parameterisation of Dupuy and Jakob 2018, section 4.2 ("An Adaptive Parameterization
// for Efficient Material Acquisition and Rendering").
// A density is given at the nodes of a width x height grid that spans the square, for each slice of
// one or two parameters (phi_i, theta_i); between slices everything is linear.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <vector>

namespace fbrdf {

/// The slices that are mixed at (phi_i, theta_i), and their weights, which sum to 1.
struct SliceMix {
    std::array<size_t, 4> slice{};
    std::array<double, 4> weight{};
};

/// Position between nodes: `at` is the lower node, in [0, size - 2].
struct GridPosition {
    size_t at = 0;
    double blend = 0.0;
};
/// `u` in [0, 1] (clamped) over `size` >= 2 nodes.
GridPosition gridPosition(double u, size_t size);

/// Bilinear value of a height x width image, width contiguous.
double bilinear(const float* image, size_t width, size_t height, double u, double v);

class RglWarp {
public:
    RglWarp() = default;
    /// `density` - slices x height x width, width contiguous, finite; width, height >= 2.
    RglWarp(std::vector<float> density, size_t width, size_t height);

    size_t slices() const { return total_.size(); }
    /// False for a slice that does not integrate to something above 0.
    bool isValid(size_t slice) const { return total_[slice] > 0.0; }

    /// Where the warp comes from: the point of the uniform square that lands at (u, v).
    Vec2<double> invert(const SliceMix& mix, Vec2<double> position) const;
    /// Where the warp of one slice takes a point of the uniform square. Inverse of invert.
    Vec2<double> sample(size_t slice, Vec2<double> uniform) const;

private:
    size_t row(size_t slice, size_t y) const { return (slice * height_ + y) * width_; }

    size_t width_ = 0, height_ = 0;
    std::vector<float> density_;      ///< normalised, slices x height x width
    std::vector<float> conditional_;  ///< integral along x up to each node, same shape
    std::vector<float> marginal_;     ///< integral over the rows up to each, slices x height
    std::vector<double> total_;       ///< before normalisation, slices
};

}  // namespace fbrdf
