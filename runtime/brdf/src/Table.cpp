#include <fbrdf/brdf/Error.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/brdf/Table.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr float kCodes = 255.0f;
// Linear maps may hold 0, whose log2 does not exist: the smallest normal float stands for it.
constexpr float kSmallestLinear = 1.17549435e-38f;

// Components of x, y, z beyond the third channel do not exist; one channel uses x.
float& component(Vec3f& v, int channel)
{
    return v[channel];
}

float decoded(float lower, float upper, int code)
{
    return lower + (upper - lower) * (static_cast<float>(code) / kCodes);
}

int encoded(float lower, float upper, float value)
{
    if (upper <= lower) return 0;
    return static_cast<int>(
        std::lround(std::clamp((value - lower) / (upper - lower), 0.0f, 1.0f) * kCodes));
}

void setRange(Table& table)
{
    const auto channels = static_cast<size_t>(table.channels);
    for (size_t c = 0; c < channels; ++c) {
        float low = INFINITY, high = -INFINITY;
        for (size_t i = c; i < table.texels.size(); i += channels) {
            low = std::min(low, table.texels[i]);
            high = std::max(high, table.texels[i]);
        }
        component(table.lower, static_cast<int>(c)) = low;
        component(table.upper, static_cast<int>(c)) = high;
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
    }
    return "?";
}

Storage storageFromName(const std::string& name)
{
    for (const Storage s : {Storage::log8, Storage::half, Storage::float32, Storage::linear8})
        if (name == storageName(s)) return s;
    throw Error(ErrorKind::usage, "storage",
                "found '" + name + "', expected log8, half, float or linear8");
}

int bytesPerChannel(Storage storage)
{
    switch (storage) {
        case Storage::half: return 2;
        case Storage::float32: return 4;
        default: return 1;
    }
}

Table quantized(const Table& table, Storage storage)
{
    Table result = table;
    if (isLog(table.storage) != isLog(storage))
        for (float& texel : result.texels)
            texel = isLog(storage) ? std::log2(std::max(texel, kSmallestLinear)) : std::exp2(texel);
    result.storage = storage;
    result.lower = Vec3f(0.0f);
    result.upper = Vec3f(1.0f);
    if (storage == Storage::half)
        for (float& texel : result.texels) texel = floatFromHalf(halfFromFloat(texel));
    if (storage == Storage::log8) setRange(result);
    if (storage == Storage::log8 || storage == Storage::linear8) {
        const auto channels = static_cast<size_t>(result.channels);
        for (size_t i = 0; i < result.texels.size(); ++i) {
            const int c = static_cast<int>(i % channels);
            result.texels[i] = decoded(result.lower[c], result.upper[c],
                                       encoded(result.lower[c], result.upper[c], result.texels[i]));
        }
    }
    return result;
}

int codeOf(const Table& table, int index, int channel)
{
    return encoded(table.lower[channel], table.upper[channel], table.texel(index, channel));
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

}  // namespace fbrdf
