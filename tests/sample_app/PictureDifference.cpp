#include "PictureDifference.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

bool covers(const Image& image, int x, int y)
{
    return x >= 0 && y >= 0 && x < image.width && y < image.height && image.pixel(x, y)[3] > 0.5f;
}

bool isAtEdge(const Image& image, int x, int y)
{
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (covers(image, x + dx, y + dy) != covers(image, x, y)) return true;
    return false;
}

double largest(const Image& image)
{
    double value = 0.0;
    for (size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3) value = std::max(value, double(std::abs(image.rgba[i])));
    return value;
}

/// NaN and infinity differ by infinity.
double relative(double value, double reference, double floor)
{
    const double difference = std::abs(value - reference) / std::max(std::abs(reference), floor);
    return std::isfinite(difference) ? difference : HUGE_VAL;
}

}  // namespace

PictureDifference compare(const Image& picture, const Image& reference)
{
    PictureDifference result;
    const double floor = std::max(1e-30, kFloorShare * largest(reference));
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            if (covers(picture, x, y) != covers(reference, x, y)) {
                ++result.coverageDiffers;
                result.edgesOnly &= isAtEdge(reference, x, y);
                continue;
            }
            if (!covers(reference, x, y)) continue;
            ++result.compared;
            for (int c = 0; c < 3; ++c) {
                const double difference = relative(double(picture.pixel(x, y)[c]),
                                                   double(reference.pixel(x, y)[c]), floor);
                result.mean += difference / 3.0;
                if (difference <= result.worst) continue;
                result.worst = difference;
                result.worstX = x;
                result.worstY = y;
            }
        }
    result.mean /= std::max(1, result.compared);
    return result;
}

}  // namespace fbrdf::scene
