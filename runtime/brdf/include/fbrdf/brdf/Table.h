// Table.h - a small positive map: its domain, its texels, and the precision they are stored in.
#pragma once
#include <fbrdf/brdf/Projection.h>

#include <string>
#include <vector>

namespace fbrdf {

/// What a stored texel is. The log storages hold log2 F, so factors add and one exp2 ends the sum;
/// linear8 holds F itself in [0, 1] (fixed-function hardware, the maps of 2001) and multiplies.
enum class Storage { log8, half, float32, linear8 };

const char* storageName(Storage storage);          ///< "log8", "half", "float", "linear8"
Storage storageFromName(const std::string& name);  ///< throws Error(usage)
int bytesPerChannel(Storage storage);
inline bool isLog(Storage storage)
{
    return storage != Storage::linear8;
}

struct Table {
    std::string name;  ///< as the form names it: "p", "q", "T1"
    Domain domain;
    Storage storage = Storage::float32;
    int channels = 3;  ///< 3, or 1 for a shape shared by R, G, B
    /// texelCount x channels, channel contiguous, then x, y, z. Decoded: log2 F (log storages) or F
    /// (linear8), exactly as the stored numbers say.
    std::vector<float> texels;
    /// Stored 8-bit code k means lower + (upper - lower) k / 255, per channel. {0, 1} for linear8;
    /// unused by half, float.
    Vec3f lower{0.0f}, upper{1.0f};

    float texel(int index, int channel) const
    {
        return texels[static_cast<size_t>(index) * static_cast<size_t>(channels) +
                      static_cast<size_t>(channels == 1 ? 0 : channel)];
    }
    /// texels x channels x bytes a channel: what the budgets of the fitter count.
    size_t bytes() const { return texels.size() * static_cast<size_t>(bytesPerChannel(storage)); }
};

/// The table with its texels rounded to what `storage` can hold (and range set for log8). Between
/// log and linear the texels are converted; linear8 clamps to [0, 1].
Table quantized(const Table& table, Storage storage);

/// 8-bit code of a texel, 0..255; only for log8 and linear8.
int codeOf(const Table& table, int index, int channel);

/// Linearly filtered texels at a position, per channel, in the table's own terms (log2 F, or F).
template <class T>
Vec3<T> sample(const Table& table, const Vec3<T>& position);

}  // namespace fbrdf
