// Utia.cpp - UTIA's BRDF database in .bin files: float64 (as published) or float32, little endian,
// without a header, one plane of 288 x 288 cells for R, G and B; UtiaTable.h has the grid. wi is
// their i (light), wo their v (view), both away from the surface; linear RGB without the cosine.
// This follows the readers published with the database (TBDRF.cpp, by way of ALTA's plugin
// data_utia) and by Sztrajman (brdf_read.py). The scale is the database's own; no such file was at
// hand.
#include "Formats.h"
#include "formats/UtiaTable.h"

#include <fbrdf/base/Found.h>

#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kValues = 3 * kUtiaCells;

template <class T>
std::vector<Vec3f> readPlanes(std::string_view bytes)
{
    std::vector<Vec3f> cells(kUtiaCells);
    for (size_t i = 0; i < kValues; ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        cells[i % kUtiaCells][int(i / kUtiaCells)] = static_cast<float>(value);
    }
    return cells;
}

/// Anything else in a file of that size would read as numbers like 1e-200 and 1e250.
void requirePlausible(const InputFile& file, const std::vector<Vec3f>& cells)
{
    constexpr float kLargest = 1e6f;
    size_t plausible = 0;
    for (const Vec3f& f : cells) {
        const float sum = std::abs(f.x) + std::abs(f.y) + std::abs(f.z);
        plausible += sum > 0.0f && sum < kLargest;
    }
    if (plausible < cells.size() / 2)
        throw inputError(file, Found(std::to_string(plausible) + " of " +
                                     std::to_string(cells.size()) + " cells between 0 and 1e6")
                                   .expected("most"));
}

}  // namespace

bool isUtia(const InputFile& file)
{
    return file.size() == kValues * sizeof(double) || file.size() == kValues * sizeof(float);
}

Source readUtia(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isUtia(file))
        throw inputError(file, Found(std::to_string(file.size()) + " bytes")
                                   .expected(std::to_string(kValues * sizeof(double)) + " or " +
                                             std::to_string(kValues * sizeof(float)) +
                                             " (3 x 288 x 288 numbers)"));
    std::vector<Vec3f> cells = file.size() == kValues * sizeof(double)
                                   ? readPlanes<double>(file.bytes())
                                   : readPlanes<float>(file.bytes());
    requirePlausible(file, cells);
    return makeUtiaSource(std::move(cells));
}

}  // namespace fbrdf
