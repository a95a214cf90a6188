#include "CubeLayout.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kMostTexels = 1 << 24;
/// Far above any panorama.
constexpr int kLongestSide = 1 << 17;
constexpr float kLargestHalf = 65504.0f;

/// Texels on a side that become one: a common divisor of the sides of at most four times what is
/// needed, or 0.
int factorFor(int width, int height)
{
    const double pixels = double(width) * double(height);
    const int least = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostTexels))));
    for (int factor = least; factor <= 4 * least; ++factor)
        if (width % factor == 0 && height % factor == 0) return factor;
    return 0;
}

std::string counted(int64_t count, const char* what)
{
    return count > 0 ? "; " + std::to_string(count) + what : "";
}

}  // namespace

LightRows::LightRows(int width, int height, const std::string& where)
    : width_(width), height_(height)
{
    const std::string sides = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide)
        throw Error(ErrorKind::input, where, Found(sides).expected("1 to 131072 on each side"));
    if (layoutOf(width, height) == LightLayout::none)
        throw Error(ErrorKind::input, where,
                    Found(sides).expected("2:1 (lat-long), 4:3 or 3:4 (a cross of six faces), 6:1 "
                                          "or 1:6 (a strip of them), or 1:1 (one of six files)"));
    factor_ = factorFor(width, height);
    if (factor_ == 0)
        throw Error(ErrorKind::input, where,
                    Found(sides).expected("at most 2^24 pixels, or sides with a common divisor by "
                                          "which they can be made smaller (oiiotool IN --resize "
                                          "4096x2048 -o OUT)"));
}

/// Values of one texel as light. before: the one to the left, repaired.
Vec3f LightRows::repaired(const Vec3f& value, Vec3f& before)
{
    Vec3f result = value;
    for (int c = 0; c < 3; ++c) {
        if (std::isnan(value[c])) {
            ++missing_;
            result[c] = before[c];
        } else if (value[c] < 0.0f) {
            ++negative_;
            result[c] = 0.0f;
        } else if (std::isinf(value[c])) {
            ++infinite_;
            result[c] = kLargestHalf;
        }
    }
    return before = result;
}

void LightRows::add(const std::vector<Vec3f>& row)
{
    FBRDF_ASSERT(row.size(), ==, static_cast<size_t>(width_));
    FBRDF_ASSERT(rows_, <, height_);
    const auto factor = static_cast<size_t>(factor_);
    sums_.resize(row.size() / factor, Vec3d(0.0));
    Vec3f before(0.0f);
    for (size_t x = 0; x < row.size(); ++x) sums_[x / factor] += Vec3d(repaired(row[x], before));
    if (++rows_ % factor_ != 0) return;
    for (const Vec3d& sum : sums_) texels_.emplace_back(sum / (double(factor_) * double(factor_)));
    sums_.assign(sums_.size(), Vec3d(0.0));
}

LightPicture LightRows::picture()
{
    FBRDF_ASSERT(rows_, ==, height_);
    LightPicture result{width_ / factor_, height_ / factor_, std::move(texels_), ""};
    if (factor_ > 1)
        result.notes =
            "; averaged from " + std::to_string(width_) + " x " + std::to_string(height_);
    result.notes += counted(negative_, " negative values count as 0") +
                    counted(infinite_, " infinite values became 65504") +
                    counted(missing_, " values that were no number became the one to the left");
    return result;
}

}  // namespace fbrdf
