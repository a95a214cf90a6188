// CompareImages.h - how far two images are apart.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace fbrdf::test {

struct ImageDifference {
    double maxRelative = 0.0, meanRelative = 0.0;
    size_t worst = 0;  ///< index of the number that is furthest off
    double found = 0.0, expected = 0.0;
    bool comparable = true;  ///< equal sizes, nothing that is not a number
};

/// |found - expected| / max(|expected|, floor), where the floor is a share of the mean of what is
/// not 0: near the terminator only rounding is left to compare.
template <class A, class B>
ImageDifference compareImages(const std::vector<A>& found, const std::vector<B>& expected,
                              double share = 1e-3)
{
    ImageDifference d;
    d.comparable = found.size() == expected.size() && !found.empty();
    double total = 0.0;
    size_t lit = 0;
    for (const B value : expected) {
        total += std::abs(static_cast<double>(value));
        lit += value != B(0) ? 1 : 0;
    }
    const double floor = lit > 0 ? share * total / static_cast<double>(lit) : 1e-30;
    for (size_t i = 0; d.comparable && i < found.size(); ++i) {
        const double a = static_cast<double>(found[i]), b = static_cast<double>(expected[i]);
        const double relative = std::abs(a - b) / std::max(std::abs(b), floor);
        if (!std::isfinite(relative)) d.comparable = false;
        d.meanRelative += relative / static_cast<double>(found.size());
        if (relative <= d.maxRelative) continue;
        d.maxRelative = relative;
        d.worst = i;
        d.found = a;
        d.expected = b;
    }
    return d;
}

inline std::string describe(const ImageDifference& d)
{
    std::ostringstream text;
    if (!d.comparable) return "images of different sizes, or with a number that is not finite";
    text << "max relative " << d.maxRelative << ", mean " << d.meanRelative << ", worst at number "
         << d.worst << ": " << d.found << ", expected " << d.expected;
    return text.str();
}

}  // namespace fbrdf::test
