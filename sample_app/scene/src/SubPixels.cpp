#include <fbrdf/scene/SubPixels.h>

#include <cmath>

namespace fbrdf::scene {

/// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences": R2.
Vec2<double> subPixel(int i)
{
    constexpr double kX = 0.75487766624669276, kY = 0.56984029099805327;
    const auto within = [i](double step) { return std::fmod(0.5 + i * step, 1.0) - 0.5; };
    return {within(kX), within(kY)};
}

gl::View movedBy(gl::View view, const Vec2<double>& place, int width, int height)
{
    for (int column = 0; column < 4; ++column) {
        glm::vec4& c = view.projection[column];
        c.x -= static_cast<float>(2.0 * place.x / width) * c.w;
        c.y -= static_cast<float>(2.0 * place.y / height) * c.w;
    }
    return view;
}

}  // namespace fbrdf::scene
