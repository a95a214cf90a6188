// Npf.cpp - non-parametric factor tables of MERL materials (Bagher, Snyder, Nowrouzezahrai 2016).
// Little endian float32 [256][512][3]: a row a material, RGB contiguous; columns 0 rhoD, 1 rhoS,
// 2..91 D, 92..181 G1, 182..271 F, each table 90 bins. D is over sqrt(theta_h / (pi/2)), F over
// theta_d, G1 over theta_i and theta_o, both linear; values at bin centres; bin 0 of G1 and F is
// not used.
//   f = (rhoD + rhoS D(theta_h) F(theta_d) G1(theta_i) / cos theta_i G1(theta_o) / cos theta_o) /
//   pi
// The published tables leave out the division by pi, which makes f 1/sr in the units of
// BRDFRead.cpp (the ratio was measured against the neural fits of the same materials: 3.17 in the
// median). Layout from the README of the data set. FILE.bin#name or #row; the samples are f on the
// MERL grid.
#include "Collection.h"
#include "MerlGrid.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kRows = 256, kColumns = 512, kBins = 90;
constexpr size_t kNpfRowBytes = kColumns * 3 * sizeof(float);
constexpr size_t kDiffuse = 0, kSpecular = 1, kD = 2, kG = 92, kF = 182, kUsed = 272;

using NpfRow = std::array<Vec3d, kUsed>;

/// Linear between bin centres; `u` in [0, 1] over the 90 bins, bins below `first` are not used.
Vec3d lookUp(const NpfRow& row, size_t table, double u, double first)
{
    const double position = u * double(kBins) - 0.5;
    const double lower = std::clamp(std::floor(position), first, double(kBins - 2));
    const double blend = std::clamp(position - lower, 0.0, 1.0);
    const size_t bin = table + size_t(lower);
    return row[bin] * (1.0 - blend) + row[bin + 1] * blend;
}

double angleShare(double cosine)
{
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / (kPi / 2);
}

Vec3d evaluateNpf(const NpfRow& row, const Vec3d& wo, const Vec3d& wi)
{
    const Vec3d h = glm::normalize(wi + wo);
    const Vec3d d = lookUp(row, kD, std::sqrt(angleShare(h.z)), 0.0);
    const Vec3d f = lookUp(row, kF, angleShare(glm::dot(wi, h)), 1.0);
    const Vec3d gi = lookUp(row, kG, angleShare(wi.z), 1.0) / wi.z;
    const Vec3d go = lookUp(row, kG, angleShare(wo.z), 1.0) / wo.z;
    return (row[kDiffuse] + row[kSpecular] * d * f * gi * go) / kPi;
}

NpfRow readNpfRow(const InputFile& file, size_t row)
{
    std::array<float, 3 * kUsed> stored{};
    std::memcpy(stored.data(), file.bytes().data() + row * kNpfRowBytes, sizeof stored);
    NpfRow table{};
    for (size_t i = 0; i < stored.size(); ++i) {
        constexpr float kLargest = 1e9f;
        if (!(stored[i] >= 0.0f && stored[i] < kLargest))
            throw inputError(file, row * kNpfRowBytes + i * sizeof(float),
                             Found(numberText(double(stored[i]))).expected("a factor >= 0"));
        table[i / 3][int(i % 3)] = double(stored[i]);
    }
    if (std::all_of(stored.begin(), stored.end(), [](float value) { return value == 0.0f; }))
        throw inputError(file, row * kNpfRowBytes, Found("an empty row").expected("a material"));
    return table;
}

}  // namespace

bool isNpf(const InputFile& file)
{
    return file.extension() == "bin" && file.size() == kRows * kNpfRowBytes;
}

// Rows after the last material are zero.
size_t npfRows(const InputFile& file)
{
    const std::string_view bytes = file.bytes();
    const size_t last = bytes.find_last_not_of('\0');
    return last == std::string_view::npos ? 0 : last / kNpfRowBytes + 1;
}

Source readNpf(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const Chosen chosen = chosenMaterial(request, kRows);
    const auto row = std::make_shared<const NpfRow>(readNpfRow(file, chosen.row));
    Source source;
    source.name = chosen.name;
    source.isotropic = true;
    source.description = "non-parametric factors (Bagher et al. 2016), linear RGB, MERL's units";
    source.evaluate = [row](const Vec3d& wo, const Vec3d& wi) {
        if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
        return evaluateNpf(*row, wo, wi);
    };
    source.exact = true;
    source.stream = streamOnGrid(MerlGrid(), source.evaluate);
    return source;
}

}  // namespace fbrdf
