#include "Plane.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// out[x] += weight in[x]: the loop that the compiler vectorises.
void addScaled(float* out, const float* in, float weight, int count)
{
    for (int x = 0; x < count; ++x) out[x] += weight * in[x];
}

Plane convolvedRows(const Plane& plane, const Kernel& kernel)
{
    const auto radius = static_cast<int>(kernel.size() / 2);
    Plane result(plane.width, plane.height);
    std::vector<float> padded(static_cast<size_t>(plane.width + 2 * radius));
    for (int y = 0; y < plane.height; ++y) {
        const float* in = plane.row(y);
        const auto first = padded.begin() + radius;
        std::fill(padded.begin(), first, in[0]);
        std::copy(in, in + plane.width, first);
        std::fill(first + plane.width, padded.end(), in[plane.width - 1]);
        for (size_t k = 0; k < kernel.size(); ++k)
            addScaled(result.row(y), padded.data() + k, kernel[k], plane.width);
    }
    return result;
}

Plane convolvedColumns(const Plane& plane, const Kernel& kernel)
{
    const auto radius = static_cast<int>(kernel.size() / 2);
    Plane result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int k = -radius; k <= radius; ++k)
            addScaled(result.row(y), plane.row(std::clamp(y + k, 0, plane.height - 1)),
                      kernel[static_cast<size_t>(k + radius)], plane.width);
    return result;
}

}  // namespace

Plane convolved(const Plane& plane, const Kernel& horizontal, const Kernel& vertical)
{
    FBRDF_ASSERT(horizontal.size() % 2, ==, size_t{1});
    FBRDF_ASSERT(vertical.size() % 2, ==, size_t{1});
    return convolvedColumns(convolvedRows(plane, horizontal), vertical);
}

Kernel gaussianKernel(double sigma, int radius)
{
    FBRDF_ASSERT(sigma, >, 0.0);
    FBRDF_ASSERT(radius, >=, 0);
    std::vector<double> weights;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
        sum += weights.back();
    }
    Kernel kernel;
    for (const double w : weights) kernel.push_back(static_cast<float>(w / sum));
    return kernel;
}

}  // namespace fbrdf
