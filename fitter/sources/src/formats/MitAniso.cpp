// MitAniso.cpp - the anisotropic measurements of MIT CSAIL in binary .dat files (Ngan, Durand,
// Matusik 2005, "Experimental Analysis of BRDF Models": brushed aluminium, yellow satin, purple
// satin, red velvet).
// 16 int32, little endian: bins of theta_in, theta_out, phi_diff and phi_in; number 6 is the
// parameterisation (1: this one), 7 the binning (0: uniform), 9 is 1 where phi_diff goes over pi
// instead of 2 pi, 10 is the number of channels (3); the rest is reserved. Then float32, one plane
// a channel, theta_in slowest and phi_in fastest. theta goes over pi / 2, phi_in over 2 pi, phi_out
// = phi_in + phi_diff, both away from the surface; values are in 1/sr without the cosine and belong
// to the centres of bins. A bin below 0 was not measured. From the reader of Disney's BRDF
// Explorer, whose shader measures azimuths from the opposite side and draws ten times the value.
#include "Formats.h"
#include "SampleRow.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <array>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kNumbers = 16, kHeadBytes = kNumbers * sizeof(int32_t), kChannels = 3;
/// No goniometer has as many steps about one axis.
constexpr int32_t kMostBins = 100000;
enum Index : size_t { parameterisation = 6, binning = 7, halfData = 9, channels = 10 };
using Head = std::array<int32_t, kNumbers>;

struct AnisoGrid {
    std::shared_ptr<const InputFile> file;
    std::array<size_t, 4> bins{};  ///< theta_in, theta_out, phi_diff, phi_in
    double phiRange = 2.0 * kPi;   ///< of phi_diff

    size_t size() const { return bins[0] * bins[1] * bins[2] * bins[3]; }
    float value(size_t channel, size_t cell) const
    {
        float f = 0.0f;
        std::memcpy(&f, file->bytes().data() + kHeadBytes + (channel * size() + cell) * sizeof f,
                    sizeof f);
        return f;
    }
};

Head headOf(const InputFile& file)
{
    Head head{};
    if (file.size() >= kHeadBytes) std::memcpy(head.data(), file.bytes().data(), kHeadBytes);
    return head;
}

/// Bytes that the head asks for; 0 where it is none, so that nothing overflows.
uint64_t expectedBytes(const Head& head)
{
    uint64_t bytes = kChannels * sizeof(float);
    for (size_t i = 0; i < 4; ++i) {
        if (head[i] < 1 || head[i] > kMostBins || bytes > UINT64_MAX / kMostBins) return 0;
        bytes *= static_cast<uint64_t>(head[i]);
    }
    return bytes + kHeadBytes;
}

void readRows(const AnisoGrid& grid, uint64_t first, size_t count, std::vector<Sample>& samples,
              SampleReport& report)
{
    const auto centre = [](size_t bin, size_t bins, double range) {
        return (double(bin) + 0.5) / double(bins) * range;
    };
    for (size_t cell = size_t(first); cell < size_t(first) + count; ++cell) {
        const size_t in = cell % grid.bins[3], diff = cell / grid.bins[3] % grid.bins[2];
        const size_t pair = cell / grid.bins[3] / grid.bins[2];
        const double phi = centre(in, grid.bins[3], 2.0 * kPi);
        const Vec3d wi =
            directionFromAngles(centre(pair / grid.bins[1], grid.bins[0], kPi / 2), phi);
        const Vec3d wo = directionFromAngles(centre(pair % grid.bins[1], grid.bins[1], kPi / 2),
                                             phi + centre(diff, grid.bins[2], grid.phiRange));
        const Vec3f f(grid.value(0, cell), grid.value(1, cell), grid.value(2, cell));
        if (f.x < 0.0f || f.y < 0.0f || f.z < 0.0f)
            addInvalidRow(report);
        else
            addUnitRow({wo, wi, Vec3d(f)}, samples, report);
    }
}

bool hasMeasuredCell(const AnisoGrid& grid)
{
    for (size_t cell = 0; cell < grid.size(); ++cell) {
        bool measured = true;
        for (size_t c = 0; c < kChannels; ++c) {
            const float f = grid.value(c, cell);
            measured &= f >= 0.0f && f < 3e38f;
        }
        if (measured) return true;
    }
    return false;
}

}  // namespace

bool isMitAniso(const InputFile& file)
{
    const Head head = headOf(file);
    return expectedBytes(head) == file.size() && head[parameterisation] == 1 &&
           head[channels] == int32_t(kChannels);
}

Source readMitAniso(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const Head head = headOf(file);
    if (!isMitAniso(file)) throw inputError(file, 0, Found("no head of 16 numbers").expected("it"));
    if (head[binning] != 0)
        throw inputError(file, binning * sizeof(int32_t),
                         Found("binning " + std::to_string(head[binning])).expected("0 (uniform)"));
    if (head[halfData] != 0 && head[halfData] != 1)
        throw inputError(
            file, halfData * sizeof(int32_t),
            Found(std::to_string(head[halfData]) + " for half data").expected("0 or 1"));
    auto grid = std::make_shared<AnisoGrid>();
    grid->file = request.file;
    for (size_t i = 0; i < 4; ++i) grid->bins[i] = static_cast<size_t>(head[i]);
    if (head[halfData] == 1) grid->phiRange = kPi;
    if (!hasMeasuredCell(*grid))
        throw inputError(file, Found("no bin that was measured").expected("at least one"));
    Source source;
    source.description = "MIT anisotropic measurements, linear RGB, 1/sr";
    source.assumptions = {"values belong to the centres of bins", "azimuths as in the file",
                          "values in 1/sr, without the factor 10 of BRDF Explorer"};
    source.stream.rows = grid->size();
    source.stream.read = [grid](uint64_t first, size_t count, std::vector<Sample>& samples,
                                SampleReport& report) {
        readRows(*grid, first, count, samples, report);
    };
    return source;
}

}  // namespace fbrdf
