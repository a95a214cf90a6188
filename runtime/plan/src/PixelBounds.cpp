#include "LightReach.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/LightClusters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {

PixelRect pixelBounds(const LightVectors& light, const glm::dmat4& projection, int width,
                      int height)
{
    const PixelRect whole{0, 0, width, height};
    if (isUnlimited(light)) return whole;
    const Reach reach = reachOf(light);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::dvec4 clip = projection * glm::dvec4(reach.centre + reach.radius * sign, 1.0);
        if (!(clip.w > kNearest)) return whole;
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 size(width, height);
    const glm::dvec2 first = glm::clamp(glm::floor((low * 0.5 + 0.5) * size) - 1.0, {}, size),
                     last = glm::clamp(glm::ceil((high * 0.5 + 0.5) * size) + 1.0, {}, size);
    return {static_cast<int>(first.x), static_cast<int>(first.y),
            static_cast<int>(last.x - first.x), static_cast<int>(last.y - first.y)};
}

PixelRect enclosing(const PixelRect& a, const PixelRect& b)
{
    if (a.width == 0 || a.height == 0) return b;
    if (b.width == 0 || b.height == 0) return a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
            std::max(a.y + a.height, b.y + b.height) - y};
}

namespace {

/// A Morton code: the bits of two 16-bit numbers in turn (Morton 1966).
uint32_t interleaved(uint32_t x, uint32_t y)
{
    uint32_t code = 0;
    for (uint32_t bit = 0; bit < 16; ++bit)
        code |= ((x >> bit) & 1u) << (2u * bit) | ((y >> bit) & 1u) << (2u * bit + 1u);
    return code;
}

}  // namespace

std::vector<int> neighboursTogether(const std::vector<PixelRect>& rects)
{
    std::vector<std::pair<uint32_t, int>> codes;
    for (size_t i = 0; i < rects.size(); ++i) {
        const PixelRect& r = rects[i];
        FBRDF_ASSERT(r.x + r.width / 2, <, 1 << 16);
        FBRDF_ASSERT(r.y + r.height / 2, <, 1 << 16);
        codes.emplace_back(interleaved(static_cast<uint32_t>(r.x + r.width / 2),
                                       static_cast<uint32_t>(r.y + r.height / 2)),
                           static_cast<int>(i));
    }
    std::sort(codes.begin(), codes.end());
    std::vector<int> order;
    for (const auto& code : codes) order.push_back(code.second);
    return order;
}

}  // namespace fbrdf
