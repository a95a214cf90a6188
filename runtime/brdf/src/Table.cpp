#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/brdf/Table.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr int kLastCode = 255, kLastUnorm16 = 65535;
// Linear maps may contain 0, whose log2 does not exist: the smallest normal float stands for it.
constexpr float kSmallestLinear = 1.17549435e-38f;
// Range of log8 as a share of the largest magnitude in it, at least: 1/32 makes the 65535 steps of
// the range four times as wide as the spacing of floats, so that no two steps round to one number.
constexpr float kLeastRange = 1.0f / 32.0f;

float& texelOf(Table& table, int index, int channel)
{
    return table.texels[static_cast<size_t>(index) * static_cast<size_t>(table.channels) +
                        static_cast<size_t>(channel)];
}

// v of the texel before `index`: to the left, above in the first column, `start` for the first.
int previousUnorm16(const Table& table, int index, int channel)
{
    if (index == 0) return table.log8.start[static_cast<size_t>(channel)];
    const int width = domainSize(table.domain)[0];
    return unorm16Of(table, index % width != 0 ? index - 1 : index - width, channel);
}

void setRange(Table& table, int channel)
{
    float low = INFINITY, high = -INFINITY;
    for (int i = 0; i < texelCount(table.domain); ++i) {
        low = std::min(low, table.texel(i, channel));
        high = std::max(high, table.texel(i, channel));
    }
    // Rounding to half a stride, at most 259 of 65535, must not lead out of the range. A constant
    // is the lower end itself and needs no rounding.
    const float margin = high > low ? 0.004f : 0.0f;
    const float least = kLeastRange * std::max(std::abs(low), std::abs(high));
    const float range = std::max(high - low, least > 0.0f ? least : 1.0f);
    table.lower[channel] = low - margin * range;
    table.upper[channel] = low + (1.0f + margin) * range;
}

// Sets the smallest stride at which every difference fits 8 bits. Two codes are kept free because
// the difference is taken to a rounded neighbour, which is off by up to half a stride.
void setStride(Table& table, int channel)
{
    const auto c = static_cast<size_t>(channel);
    table.log8.start[c] = unorm16Of(table, 0, channel);
    int least = 0, most = 0;
    for (int i = 0; i < texelCount(table.domain); ++i) {
        const int difference = unorm16Of(table, i, channel) - previousUnorm16(table, i, channel);
        least = std::min(least, difference);
        most = std::max(most, difference);
    }
    const int stride = std::max(1, (most - least + kLastCode - 3) / (kLastCode - 2));
    table.log8.stride[c] = stride;
    table.log8.offset[c] = static_cast<int>(std::floor(static_cast<double>(least) / stride)) - 1;
}

// The mirror image of a texel in a symmetric table, or the texel itself in others.
int mirrorOf(const Domain& domain, int index)
{
    const auto* grid = std::get_if<GridDomain>(&domain);
    if (!grid || !grid->symmetric) return index;
    const int side = grid->axes[0].size;
    return index % side * side + index / side;
}

// A file may hold any texels, so those of a symmetric domain need not be symmetric.
bool isMirrored(const Table& table, int channel)
{
    for (int i = 0; i < texelCount(table.domain); ++i)
        if (table.texel(i, channel) != table.texel(mirrorOf(table.domain, i), channel))
            return false;
    return true;
}

// Closed loop: each code corrects the rounding of the texels before it, so errors do not add up.
// All texels of a channel lie on one lattice, a stride wide. A value half way between two of its
// points rounds either way depending on the texels before it, so the second texel of a mirrored
// pair copies the first.
void roundToLog8(Table& table)
{
    for (int channel = 0; channel < table.channels; ++channel) {
        setRange(table, channel);
        setStride(table, channel);
        const auto c = static_cast<size_t>(channel);
        const int stride = table.log8.stride[c], offset = table.log8.offset[c];
        const bool mirrored = isMirrored(table, channel);
        for (int i = 0; i < texelCount(table.domain); ++i) {
            const int wanted = unorm16Of(
                          table, mirrored ? std::min(i, mirrorOf(table.domain, i)) : i, channel),
                      previous = previousUnorm16(table, i, channel);
            const auto steps =
                static_cast<int>(std::lround(static_cast<double>(wanted - previous) / stride));
            const int code = std::clamp(steps - offset, 0, kLastCode);
            texelOf(table, i, channel) = texelFromCode(table, i, channel, code);
        }
    }
}

}  // namespace

const char* storageName(Storage storage)
{
    switch (storage) {
        case Storage::log8: return "log8";
        case Storage::half: return "half";
        case Storage::float32: return "float";
        case Storage::linear8: return "linear8";
        case Storage::signedHalf: return "signed";
    }
    return "?";
}

Storage storageFromName(const std::string& name)
{
    for (const Storage s : {Storage::log8, Storage::half, Storage::float32, Storage::linear8})
        if (name == storageName(s)) return s;
    throw Error(ErrorKind::usage, "storage",
                Found("'" + name + "'").expected("log8, half, float or linear8"));
}

int bytesPerChannel(Storage storage)
{
    switch (storage) {
        case Storage::half:
        case Storage::signedHalf: return 2;
        case Storage::float32: return 4;
        default: return 1;
    }
}

Table quantized(const Table& table, Storage storage)
{
    if (table.storage == storage && storage != Storage::float32) return table;
    Table result = table;
    if (isLog(table.storage) != isLog(storage))
        for (float& texel : result.texels)
            texel = isLog(storage) ? std::log2(std::max(texel, kSmallestLinear)) : std::exp2(texel);
    result.storage = storage;
    result.lower = Vec3f(0.0f);
    result.upper = Vec3f(1.0f);
    result.log8 = {};
    for (float& texel : result.texels) {
        if (storage == Storage::half || storage == Storage::signedHalf)
            texel = floatFromHalf(halfFromFloat(texel));
        if (storage == Storage::linear8)
            texel = std::round(std::clamp(texel, 0.0f, 1.0f) * static_cast<float>(kLastCode)) /
                    static_cast<float>(kLastCode);
    }
    if (storage == Storage::log8) roundToLog8(result);
    return result;
}

int unorm16Of(const Table& table, int index, int channel)
{
    const float lower = table.lower[channel], upper = table.upper[channel];
    if (!(upper > lower)) return 0;
    const float unit =
        std::clamp((table.texel(index, channel) - lower) / (upper - lower), 0.0f, 1.0f);
    return static_cast<int>(std::lround(unit * static_cast<float>(kLastUnorm16)));
}

float texelFromUnorm16(const Table& table, int channel, int value)
{
    return table.lower[channel] +
           (table.upper[channel] - table.lower[channel]) *
               (static_cast<float>(value) / static_cast<float>(kLastUnorm16));
}

int codeOf(const Table& table, int index, int channel)
{
    FBRDF_ASSERT(bytesPerChannel(table.storage), ==, 1);
    if (table.storage == Storage::linear8)
        return static_cast<int>(
            std::lround(table.texel(index, channel) * static_cast<float>(kLastCode)));
    const auto c = static_cast<size_t>(channel);
    return (unorm16Of(table, index, channel) - previousUnorm16(table, index, channel)) /
               table.log8.stride[c] -
           table.log8.offset[c];
}

float texelFromCode(const Table& table, int index, int channel, int code)
{
    FBRDF_ASSERT(bytesPerChannel(table.storage), ==, 1);
    if (table.storage == Storage::linear8)
        return static_cast<float>(code) / static_cast<float>(kLastCode);
    const auto c = static_cast<size_t>(channel);
    return texelFromUnorm16(table, channel,
                            previousUnorm16(table, index, channel) +
                                table.log8.stride[c] * (table.log8.offset[c] + code));
}

template <class T>
Vec3<T> sample(const Table& table, const Vec3<T>& position)
{
    const Stencil<T> stencil = stencilAt(table.domain, position);
    Vec3<T> sum(T(0));
    for (int k = 0; k < stencil.count; ++k) {
        const auto slot = static_cast<size_t>(k);
        for (int c = 0; c < 3; ++c)
            sum[c] += stencil.weight[slot] * static_cast<T>(table.texel(stencil.texel[slot], c));
    }
    return sum;
}

template Vec3<float> sample(const Table&, const Vec3<float>&);
template Vec3<double> sample(const Table&, const Vec3<double>&);

double contrast(const Table& table)
{
    const std::array<int, 3> size = domainSize(table.domain);
    double worst = 0.0;
    for (int c = 0; c < table.channels; ++c) {
        double sum = 0.0;
        int stride = 1;
        for (const int count : size) {
            float largest = 0.0f;
            for (int i = 0; i + stride < texelCount(table.domain); ++i)
                if (i / stride % count + 1 < count)
                    largest =
                        std::max(largest, std::abs(table.texel(i + stride, c) - table.texel(i, c)));
            sum += static_cast<double>(largest);
            stride *= count;
        }
        worst = std::max(worst, sum);
    }
    return worst;
}

}  // namespace fbrdf
