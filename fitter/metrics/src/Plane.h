// Plane.h - one channel of a picture, and its convolution with separable kernels.
#pragma once
#include <cstddef>
#include <vector>

namespace fbrdf {

struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;  ///< width x height, x contiguous

    Plane() = default;
    Plane(int w, int h)
        : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h), 0.0f)
    {
    }
    float* row(int y)
    {
        return values.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
    }
    const float* row(int y) const
    {
        return values.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
    }
};

/// 2 r + 1 weights for offsets -r .. r.
using Kernel = std::vector<float>;

/// sum over offsets of horizontal[i] vertical[j] plane(x + i, y + j); outside, the nearest pixel of
/// the border counts.
Plane convolved(const Plane& plane, const Kernel& horizontal, const Kernel& vertical);

/// exp(-x^2 / (2 sigma^2)) for offsets -radius .. radius, scaled to the sum 1.
Kernel gaussianKernel(double sigma, int radius);

}  // namespace fbrdf
