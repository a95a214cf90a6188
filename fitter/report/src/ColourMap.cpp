#include "ColourMap.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {

Vec3d viridis(double t)
{
    // Coefficients of t^0 .. t^6: M. Zucker 2019, "Approximate versions of matplotlib colormaps"
    // (CC0).
    static const std::array<Vec3d, 7> kCoefficients{{
        {0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
        {0.1050930431085774, 1.404613529898575, 1.384590162594685},
        {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
        {-4.634230498983486, -5.799100973351585, -19.33244095627987},
        {6.228269936347081, 14.17993336680509, 56.69055260068105},
        {4.776384997670288, -13.74514537774601, -65.35303263337234},
        {-5.435455855934631, 4.645852612178535, 26.3124352495832},
    }};
    const double x = std::clamp(t, 0.0, 1.0);
    Vec3d colour(0.0);
    for (auto c = kCoefficients.rbegin(); c != kCoefficients.rend(); ++c) colour = colour * x + *c;
    return glm::clamp(colour, 0.0, 1.0);
}

std::string hexColour(const Vec3d& colour)
{
    const auto code = [&](int c) {
        return static_cast<int>(std::lround(255.0 * std::clamp(colour[c], 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", code(0), code(1), code(2));
}

}  // namespace fbrdf
