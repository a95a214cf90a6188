#include <fbrdf/base/Assert.h>
#include <fbrdf/truth/Deviation.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::truth {

std::vector<double> storedImage(std::vector<double> image, Transfer transfer, bool unorm)
{
    for (size_t i = 0; i < image.size(); ++i) {
        if (i % 4 == 3) continue;
        image[i] = transferred(transfer, 1.0, image[i]);
        if (unorm) image[i] = std::min(image[i], 1.0);
    }
    return image;
}

Deviation deviationOf(const std::vector<float>& found, const std::vector<double>& exact,
                      const ErrorBound& bound)
{
    FBRDF_ASSERT(found.size(), ==, exact.size());
    double total = 0.0;
    size_t lit = 0;
    for (const double value : exact) {
        total += std::abs(value);
        lit += value != 0.0 ? 1 : 0;
    }
    const double floor = 1e-2 * total / static_cast<double>(std::max<size_t>(lit, 1));
    Deviation worst;
    for (size_t i = 0; i < exact.size(); ++i) {
        const double off = std::abs(static_cast<double>(found[i]) - exact[i]),
                     magnitude = std::max(std::abs(exact[i]), floor);
        worst.relative = std::max(worst.relative, off / magnitude);
        worst.absolute = std::max(worst.absolute, off);
        worst.share = std::max(worst.share, off / (bound.relative * magnitude + bound.absolute));
    }
    return worst;
}

}  // namespace fbrdf::truth
