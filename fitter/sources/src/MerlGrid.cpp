#include "MerlGrid.h"

#include "SampleRow.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

void addAngle(double angle, std::vector<double>& cosines, std::vector<double>& sines)
{
    cosines.push_back(std::cos(angle));
    sines.push_back(std::sin(angle));
}

size_t binOf(double position, int count)
{
    return static_cast<size_t>(std::clamp(static_cast<int>(position), 0, count - 1));
}

}  // namespace

MerlGrid::MerlGrid(std::array<int, 3> cells, double phiSpan) : cells_(cells), phiSpan_(phiSpan)
{
    for (int i = 0; i < cells[0]; ++i) {
        const double root = (i + 0.5) / cells[0];
        addAngle(root * root * kPi / 2, cos_h_, sin_h_);
    }
    for (int i = 0; i < cells[1]; ++i) addAngle((i + 0.5) / cells[1] * kPi / 2, cos_d_, sin_d_);
    for (int i = 0; i < cells[2]; ++i) addAngle((i + 0.5) / cells[2] * phiSpan, cos_p_, sin_p_);
}

std::string MerlGrid::key() const
{
    return "merl " + std::to_string(cells_[0]) + "x" + std::to_string(cells_[1]) + "x" +
           std::to_string(cells_[2]) + (phiSpan_ > kPi ? " full" : "");
}

DirectionPair<double> MerlGrid::pair(size_t cell) const
{
    const size_t p = cell % cos_p_.size();
    const size_t d = cell / cos_p_.size() % cos_d_.size();
    const size_t h = cell / cos_p_.size() / cos_d_.size();
    const double x = sin_d_[d] * cos_p_[p], y = sin_d_[d] * sin_p_[p], z = cos_d_[d];
    const double c = cos_h_[h], s = sin_h_[h];
    return {{-c * x + s * z, -y, s * x + c * z}, {c * x + s * z, y, -s * x + c * z}};
}

size_t MerlGrid::cellOf(const DirectionPair<double>& pair) const
{
    const HalfDifference angles = halfDifferenceFromPair(pair);
    const double phi = angles.phi_d < 0.0 ? angles.phi_d + phiSpan_ : angles.phi_d;
    const size_t h = binOf(std::sqrt(angles.theta_h / (kPi / 2)) * cells_[0], cells_[0]);
    const size_t d = binOf(angles.theta_d / (kPi / 2) * cells_[1], cells_[1]);
    const size_t p = binOf(phi / phiSpan_ * cells_[2], cells_[2]);
    return (h * cos_d_.size() + d) * cos_p_.size() + p;
}

SampleStream streamOnGrid(MerlGrid grid, BrdfFunction evaluate)
{
    SampleStream stream;
    stream.rows = grid.size();
    stream.geometry = grid.key();
    stream.read = [grid = std::move(grid), evaluate = std::move(evaluate)](
                      uint64_t first, size_t count, std::vector<Sample>& samples,
                      SampleReport& report) {
        for (size_t cell = size_t(first); cell < size_t(first) + count; ++cell) {
            const DirectionPair<double> pair = grid.pair(cell);
            addUnitRow({pair.wo, pair.wi, evaluate(pair.wo, pair.wi)}, samples, report);
        }
    };
    return stream;
}

}  // namespace fbrdf
