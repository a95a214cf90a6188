// Mbsdf.cpp - measured isotropic BSDFs of NVIDIA's Material Definition Language (.mbsdf; MDL
// specification, appendix on file formats), the reflection.
// "NVIDIA ARC MBSDF V1\n", perhaps lines of metadata, then blocks "MBSDF_DATA=\n" or
// "MBSDF_DATA_REFLECTION=\n" or "MBSDF_DATA_TRANSMISSION=\n", each followed by uint32 type (0: one
// number, 1: RGB), uint32 n_theta, uint32 n_phi, and float32 [theta_in][theta_out][phi][channel],
// little endian, in 1/sr without the cosine. The zenith angles divide [0, pi / 2] and the azimuths
// between light and view, where pi is the mirror, [0, pi] evenly. Values belong to the centres of
// bins: in measurements of car paint the peak lies between the bin of the mirror and its
// neighbours, on either side. Values below 0 are noise of the measurement.
#include "Formats.h"
#include "SampleRow.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <array>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr std::string_view kMbsdfMagic = "NVIDIA ARC MBSDF V1";
constexpr size_t kHeadNumbers = 3, kHeadBytesOfBlock = kHeadNumbers * sizeof(uint32_t);

struct MbsdfTable {
    std::shared_ptr<const InputFile> file;
    size_t start = 0;  ///< byte of the first value
    size_t channels = 1, thetas = 0, phis = 0;

    size_t size() const { return thetas * thetas * phis; }
    float value(size_t node, size_t channel) const
    {
        float f = 0.0f;
        std::memcpy(&f, file->bytes().data() + start + (node * channels + channel) * sizeof f,
                    sizeof f);
        return f;
    }
};

/// Byte after "KEY=\n" of the first of these keys, 0 where there is none.
size_t blockOf(std::string_view bytes)
{
    for (const std::string_view key : {"\nMBSDF_DATA_REFLECTION=\n", "\nMBSDF_DATA=\n"}) {
        const size_t found = bytes.find(key);
        if (found != std::string_view::npos) return found + key.size();
    }
    return 0;
}

/// A count whose product with others cannot overflow.
size_t dimension(const InputFile& file, size_t at, uint32_t value)
{
    constexpr uint32_t kMost = 100000;
    if (value < 1 || value > kMost)
        throw inputError(file, at, Found(std::to_string(value) + " bins").expected("1 to 100000"));
    return value;
}

MbsdfTable readMbsdfTable(const FileRequest& request)
{
    const InputFile& file = *request.file;
    MbsdfTable table;
    table.file = request.file;
    const size_t block = blockOf(file.bytes());
    if (block == 0)
        throw inputError(file, Found("no reflection").expected("MBSDF_DATA_REFLECTION="));
    std::array<uint32_t, kHeadNumbers> head{};
    if (file.size() - block < kHeadBytesOfBlock)
        throw inputError(file, block, Found("the end of the file").expected("type and sizes"));
    std::memcpy(head.data(), file.bytes().data() + block, kHeadBytesOfBlock);
    if (head[0] > 1)
        throw inputError(
            file, block,
            Found("type " + std::to_string(head[0])).expected("0 (scalar) or 1 (RGB)"));
    table.channels = head[0] == 1 ? 3 : 1;
    table.thetas = dimension(file, block + 4, head[1]);
    table.phis = dimension(file, block + 8, head[2]);
    table.start = block + kHeadBytesOfBlock;
    const size_t available = (file.size() - table.start) / sizeof(float) / table.channels;
    if (available / table.thetas / table.thetas < table.phis)
        throw inputError(
            file, table.start,
            Found(std::to_string(available) + " values")
                .expected(std::to_string(table.thetas) + "^2 x " + std::to_string(table.phis)));
    return table;
}

void readBins(const MbsdfTable& table, uint64_t first, size_t count, std::vector<Sample>& samples,
              SampleReport& report)
{
    const auto theta = [&](size_t bin) {
        return (double(bin) + 0.5) / double(table.thetas) * kPi / 2;
    };
    for (size_t node = size_t(first); node < size_t(first) + count; ++node) {
        const size_t p = node % table.phis, pair = node / table.phis;
        const double phi = (double(p) + 0.5) / double(table.phis) * kPi;
        Vec3d f(0.0);
        for (int c = 0; c < 3; ++c)
            f[c] = double(table.value(node, table.channels == 3 ? size_t(c) : 0));
        addUnitRow({directionFromAngles(theta(pair % table.thetas), phi),
                    directionFromAngles(theta(pair / table.thetas), 0.0), f},
                   samples, report);
    }
}

bool hasUsableBin(const MbsdfTable& table)
{
    std::vector<Sample> samples;
    SampleReport ignored;
    for (size_t node = 0; node < table.size() && samples.empty(); ++node)
        readBins(table, node, 1, samples, ignored);
    return !samples.empty();
}

}  // namespace

bool isMbsdf(const InputFile& file)
{
    return file.bytes().substr(0, kMbsdfMagic.size()) == kMbsdfMagic;
}

Source readMbsdf(const FileRequest& request)
{
    if (!isMbsdf(*request.file))
        throw inputError(*request.file, 0, Found("no 'NVIDIA ARC MBSDF V1'").expected("it"));
    const auto table = std::make_shared<const MbsdfTable>(readMbsdfTable(request));
    if (!hasUsableBin(*table))
        throw inputError(*request.file, Found("no finite value").expected("at least one"));
    Source source;
    source.isotropic = true;
    source.description = std::string("MDL measured BSDF, reflection, ") +
                         (table->channels == 3 ? "linear RGB" : "one channel") + ", 1/sr";
    source.assumptions = {"values belong to the centres of bins",
                          "azimuth 180 degrees is the mirror"};
    if (table->channels == 1) source.assumptions.emplace_back("one channel as grey");
    source.stream.rows = table->size();
    source.stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                                 SampleReport& report) {
        readBins(*table, first, count, samples, report);
    };
    return source;
}

}  // namespace fbrdf
