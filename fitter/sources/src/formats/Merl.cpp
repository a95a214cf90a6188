// Merl.cpp - MERL .binary tables (Matusik, Pfister, Brand, McMillan 2003).
// Little endian: int32 counts of theta_h, theta_d, phi_d (90, 90, 180), then one plane of float64
// for R, G and B. A stored value times 1/1500, 1.15/1500, 1.66/1500 is f in 1/sr, without the
// cosine; a negative value in any channel means that the cell was not measured. wi is their `in`,
// the light: it makes no difference in tables of 180 phi_d cells, which take reciprocity for
// granted. Tables of 360 cells cover the full circle. Cells and look-up: MerlGrid.h.
// This follows the comments and code of BRDFRead.cpp, distributed with the database; full-circle
// tables from the notes of the perceptual-quality set of Lavoue et al. 2021.
//
// `evaluate` takes the nearest cell, as BRDFRead.cpp does, and where that cell is not valid the
// next valid one at smaller theta_d: cells at the horizon are often marked invalid although a part
// of them is above it. The samples are the centres of the cells.
#include "Formats.h"
#include "MerlGrid.h"
#include "SampleRow.h"

#include <fbrdf/base/Found.h>

#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kHeader = 3 * sizeof(int32_t);
constexpr std::array<double, 3> kScale = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
/// No table has more cells along an axis; the bound keeps the products below far from overflow.
constexpr int32_t kMostCells = 1 << 16;
constexpr int kFullCircle = 360;

struct MerlTable {
    MerlGrid grid;
    std::vector<Vec3f> f;      ///< for each cell; what evaluate returns where the cell is not valid
    std::vector<char> marked;  ///< for each cell: 1 where the file marks it as not measured
};

std::array<int32_t, 3> countsOf(const InputFile& file)
{
    std::array<int32_t, 3> counts{};
    if (file.size() >= kHeader) std::memcpy(counts.data(), file.bytes().data(), kHeader);
    return counts;
}

bool arePlausible(const std::array<int32_t, 3>& counts)
{
    for (const int32_t count : counts)
        if (count < 1 || count > kMostCells) return false;
    return true;
}

uint64_t fileSize(const std::array<int32_t, 3>& counts)
{
    return kHeader +
           uint64_t(counts[0]) * uint64_t(counts[1]) * uint64_t(counts[2]) * 3 * sizeof(double);
}

std::array<int32_t, 3> checkedCounts(const InputFile& file)
{
    const std::array<int32_t, 3> counts = countsOf(file);
    if (!arePlausible(counts))
        throw inputError(file, 0, Found("no table size").expected("90, 90, 180 as int32"));
    if (file.size() != fileSize(counts))
        throw inputError(
            file, Found(std::to_string(file.size()) + " bytes")
                      .expected(std::to_string(fileSize(counts)) + " for a table of " +
                                std::to_string(counts[0]) + " x " + std::to_string(counts[1]) +
                                " x " + std::to_string(counts[2])));
    return counts;
}

bool isUsable(const Vec3f& f)
{
    return std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z);
}

void readPlanes(const InputFile& file, MerlTable& table)
{
    const size_t cells = table.grid.size();
    table.f.resize(cells);
    table.marked.assign(cells, 0);
    for (int channel = 0; channel < 3; ++channel) {
        const char* plane =
            file.bytes().data() + kHeader + size_t(channel) * cells * sizeof(double);
        for (size_t cell = 0; cell < cells; ++cell) {
            double value;
            std::memcpy(&value, plane + cell * sizeof(double), sizeof value);
            table.marked[cell] |= value < 0.0;
            table.f[cell][channel] = static_cast<float>(value * kScale[size_t(channel)]);
        }
    }
}

/// The values that `evaluate` looks up: along each line of theta_d the last valid value is kept.
std::vector<Vec3f> filled(const MerlTable& table)
{
    std::vector<Vec3f> values = table.f;
    const size_t phis = size_t(table.grid.cells()[2]), line = size_t(table.grid.cells()[1]) * phis;
    for (size_t cell = 0; cell < values.size(); ++cell) {
        if (!table.marked[cell] && isUsable(values[cell])) continue;
        values[cell] = cell % line < phis ? Vec3f(0.0f) : values[cell - phis];
    }
    return values;
}

void readCells(const MerlTable& table, uint64_t first, size_t count, std::vector<Sample>& samples,
               SampleReport& report)
{
    for (size_t cell = size_t(first); cell < size_t(first) + count; ++cell) {
        const DirectionPair<double> pair = table.grid.pair(cell);
        const bool above = pair.wo.z >= kHorizonCosine && pair.wi.z >= kHorizonCosine;
        if (above && table.marked[cell])
            addInvalidRow(report);
        else
            addUnitRow({pair.wo, pair.wi, above ? Vec3d(table.f[cell]) : Vec3d(0.0)}, samples,
                       report);
    }
}

void requireValidCell(const InputFile& file, const MerlTable& table)
{
    for (size_t cell = 0; cell < table.f.size(); ++cell)
        if (!table.marked[cell] && isUsable(table.f[cell])) return;
    throw inputError(file, Found("no valid cell").expected("values of 0 or above"));
}

}  // namespace

bool isMerl(const InputFile& file)
{
    const std::array<int32_t, 3> counts = countsOf(file);
    return arePlausible(counts) && file.size() == fileSize(counts);
}

Source readMerl(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const std::array<int32_t, 3> counts = checkedCounts(file);
    const double span = counts[2] == kFullCircle ? 2 * kPi : kPi;
    auto table = std::make_shared<MerlTable>();
    table->grid = MerlGrid({counts[0], counts[1], counts[2]}, span);
    readPlanes(file, *table);
    requireValidCell(file, *table);
    Source source;
    source.isotropic = true;
    source.description = "MERL table, linear RGB, 1/sr; evaluated at the nearest cell";
    source.stream.rows = table->grid.size();
    source.stream.geometry = table->grid.key();
    source.stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                                 SampleReport& report) {
        readCells(*table, first, count, samples, report);
    };
    const auto values = std::make_shared<const std::vector<Vec3f>>(filled(*table));
    source.evaluate = [values, grid = table->grid](const Vec3d& wo, const Vec3d& wi) {
        if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
        return Vec3d((*values)[grid.cellOf({wo, wi})]);
    };
    return source;
}

}  // namespace fbrdf
