// Table.h - a small positive map: its domain, its texels, and the precision they are stored in.
#pragma once
#include <fbrdf/brdf/Projection.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace fbrdf {

/// What a stored texel is. The log storages hold log2 F, so factors add and one exp2 ends the sum;
/// linear8 holds F itself in [0, 1] (fixed-function hardware, the maps of 2001) and multiplies.
/// log8 keeps 8 bits a texel: the difference to the texel before it, see Log8. signedHalf holds F
/// itself, of either sign, as half floats, and multiplies: the terms of a singular value
/// decomposition (docs/method.md, Eq. 3).
enum class Storage { log8, half, float32, linear8, signedHalf };

const char* storageName(Storage storage);  ///< "log8", "half", "float", "linear8", "signed"
/// A storage that a fit can be asked for: all but "signed", which some forms imply. Throws
/// Error(usage).
Storage storageFromName(const std::string& name);
int bytesPerChannel(Storage storage);
inline bool isLog(Storage storage)
{
    return storage != Storage::linear8 && storage != Storage::signedHalf;
}

/// How 8-bit codes of log8 become 16-bit integers v, exactly what a UNORM16 texture holds:
///   v = v(previous texel) + stride (offset + code),   log2 F = lower + (upper - lower) v / 65535.
/// The previous texel is the one to the left, in the first column the one above, and `start` for
/// the first of all. A log map is smooth, so differences need a far smaller range than values: the
/// step is a tenth to a twentieth.
struct Log8 {
    std::array<int, 3> stride{257, 257, 257};  ///< per channel, >= 1
    std::array<int, 3> offset{0, 0, 0};
    std::array<int, 3> start{0, 0, 0};  ///< 0 .. 65535
};

struct Table {
    std::string name;  ///< as the form names it: "p", "q", "T1"
    Domain domain;
    Storage storage = Storage::float32;
    int channels = 3;  ///< 3, or 1 for a shape shared by R, G, B
    /// texelCount x channels, channel contiguous, then x, y, z. Decoded: log2 F (log storages) or F
    /// (linear8), exactly as the stored numbers say.
    std::vector<float> texels;
    /// Range of log8, per channel; {0, 1} for linear8, whose code k means k / 255; unused by half
    /// and float.
    Vec3f lower{0.0f}, upper{1.0f};
    Log8 log8;  ///< used by log8 alone
    /// Marks the texels that no sample of the fit supports: smoothness alone decided their values.
    /// One mark for each texel, or empty where support is unknown.
    std::vector<bool> unsupported{};

    float texel(int index, int channel) const
    {
        return texels[static_cast<size_t>(index) * static_cast<size_t>(channels) +
                      static_cast<size_t>(channels == 1 ? 0 : channel)];
    }
    size_t unsupportedCount() const
    {
        return static_cast<size_t>(std::count(unsupported.begin(), unsupported.end(), true));
    }
    /// texels x channels x bytes a channel: what the budgets of the fitter count.
    size_t bytes() const { return texels.size() * static_cast<size_t>(bytesPerChannel(storage)); }
};

/// The table with its texels rounded to what `storage` can hold (range and Log8 set for log8). A
/// table already of that storage is returned as it is. Between log and linear the texels are
/// converted; linear8 clamps to [0, 1].
Table quantized(const Table& table, Storage storage);

/// A texel as UNORM16 over [lower, upper]: exact for log8 and linear8.
int unorm16Of(const Table& table, int index, int channel);
/// The texel that a UNORM16 of 0..65535 stands for.
float texelFromUnorm16(const Table& table, int channel, int value);

/// 8-bit code of a texel, 0..255. Expects the storage log8 or linear8.
int codeOf(const Table& table, int index, int channel);
/// The texel that a code stands for at `index`; for log8 the texels before it must be decoded
/// already. Not clamped: a code that leads out of 0..65535 gives a value out of [lower, upper].
float texelFromCode(const Table& table, int index, int channel, int code);

/// Linearly filtered texels at a position, per channel, in the table's own terms (log2 F, or F).
template <class T>
Vec3<T> sample(const Table& table, const Vec3<T>& position);

/// The largest difference of neighbouring texels along each axis, summed over the axes, of the
/// channel where that is largest: a filter whose weights are off by w is off by at most w times
/// this.
double contrast(const Table& table);

}  // namespace fbrdf
