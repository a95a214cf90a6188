#include "formats/RglWarp.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// The t in [0, 1] at which the integral of a density that goes linearly from `a` (t = 0) to `b`
/// (t = 1) reaches `integral`. The root is written so that a = b needs no special case.
double inverseOfLinear(double a, double b, double integral)
{
    const double root = std::sqrt(std::max(a * a + 2.0 * integral * (b - a), 0.0));
    const double denominator = a + root;
    return denominator > 0.0 ? std::clamp(2.0 * integral / denominator, 0.0, 1.0) : 0.0;
}

double integralOfLinear(double a, double b, double t)
{
    return t * (a + 0.5 * t * (b - a));
}

double mixed(double a, double b, double t)
{
    return a + t * (b - a);
}

}  // namespace

GridPosition gridPosition(double u, size_t size)
{
    const double position = std::clamp(u, 0.0, 1.0) * double(size - 1);
    const size_t at = std::min(static_cast<size_t>(position), size - 2);
    return {at, position - double(at)};
}

double bilinear(const float* image, size_t width, size_t height, double u, double v)
{
    const GridPosition x = gridPosition(u, width), y = gridPosition(v, height);
    const float* lower = image + y.at * width + x.at;
    const float* upper = lower + width;
    return mixed(mixed(double(lower[0]), double(lower[1]), x.blend),
                 mixed(double(upper[0]), double(upper[1]), x.blend), y.blend);
}

RglWarp::RglWarp(std::vector<float> density, size_t width, size_t height)
    : width_(width), height_(height), density_(std::move(density))
{
    const size_t count = density_.size() / (width * height);
    conditional_.resize(density_.size());
    marginal_.resize(count * height);
    total_.resize(count);
    std::vector<double> along(width * height), rows(height);
    for (size_t slice = 0; slice < count; ++slice) {
        float* nodes = density_.data() + row(slice, 0);
        for (size_t i = 0; i < along.size(); ++i)
            along[i] = i % width == 0
                           ? 0.0
                           : along[i - 1] + 0.5 * (double(nodes[i - 1]) + double(nodes[i]));
        for (size_t y = 1; y < height; ++y)
            rows[y] = rows[y - 1] + 0.5 * (along[y * width - 1] + along[(y + 1) * width - 1]);
        total_[slice] = rows.back();
        if (!isValid(slice)) continue;
        for (size_t i = 0; i < along.size(); ++i) {
            nodes[i] = static_cast<float>(double(nodes[i]) / rows.back());
            conditional_[row(slice, 0) + i] = static_cast<float>(along[i] / rows.back());
        }
        for (size_t y = 0; y < height; ++y)
            marginal_[slice * height + y] = static_cast<float>(rows[y] / rows.back());
    }
}

Vec2<double> RglWarp::invert(const SliceMix& mix, Vec2<double> position) const
{
    const GridPosition x = gridPosition(position.x, width_), y = gridPosition(position.y, height_);
    double left = 0.0, right = 0.0;  // density on the two sides of the cell, at row y
    double before = 0.0;             // integral along that row up to the cell
    double lower = 0.0, upper = 0.0, rows = 0.0;
    for (size_t i = 0; i < mix.slice.size(); ++i) {
        const double w = mix.weight[i];
        const size_t a = row(mix.slice[i], y.at), b = a + width_;
        const auto at = [&](const std::vector<float>& table, size_t column) {
            return w * mixed(double(table[a + column]), double(table[b + column]), y.blend);
        };
        left += at(density_, x.at);
        right += at(density_, x.at + 1);
        before += at(conditional_, x.at);
        lower += w * double(conditional_[a + width_ - 1]);
        upper += w * double(conditional_[b + width_ - 1]);
        rows += w * double(marginal_[mix.slice[i] * height_ + y.at]);
    }
    const double whole = mixed(lower, upper, y.blend);
    const double across = before + integralOfLinear(left, right, x.blend);
    return {whole > 0.0 ? across / whole : 0.0, rows + integralOfLinear(lower, upper, y.blend)};
}

Vec2<double> RglWarp::sample(size_t slice, Vec2<double> uniform) const
{
    const float* rows = marginal_.data() + slice * height_;
    const float* found = std::upper_bound(rows + 1, rows + height_ - 1, float(uniform.y));
    const size_t y = size_t(found - rows) - 1;
    const size_t a = row(slice, y), b = a + width_;
    const double lower = double(conditional_[b - 1]);
    const double upper = double(conditional_[b + width_ - 1]);
    const double blend = inverseOfLinear(lower, upper, uniform.y - double(rows[y]));

    const auto at = [&](const std::vector<float>& table, size_t column) {
        return mixed(double(table[a + column]), double(table[b + column]), blend);
    };
    const double target = uniform.x * mixed(lower, upper, blend);
    size_t x = 0;
    while (x + 2 < width_ && at(conditional_, x + 1) <= target) ++x;
    const double across =
        inverseOfLinear(at(density_, x), at(density_, x + 1), target - at(conditional_, x));
    return {(double(x) + across) / double(width_ - 1), (double(y) + blend) / double(height_ - 1)};
}

}  // namespace fbrdf
