#include "NumberRows.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

void splitNumbers(std::string_view line, std::vector<std::string_view>& words)
{
    splitFields(line, separatorOfNumbers(line), words);
}

void parseNumbers(const InputFile& file, size_t line, const std::vector<std::string_view>& words,
                  std::vector<double>& numbers)
{
    numbers.resize(words.size());
    for (size_t i = 0; i < words.size(); ++i)
        if (!parseField(words[i], numbers[i]))
            throw lineError(file, line, Found(inQuotes(words[i])).expected("a number"));
}

size_t mostRows(const InputFile& file, size_t numbers)
{
    const std::string_view text = file.bytes();
    const auto lines = [&](char end) {
        return static_cast<size_t>(std::count(text.begin(), text.end(), end)) + 1;
    };
    return std::min(std::max(lines('\n'), lines('\r')), text.size() / (2 * numbers) + 1);
}

void AngleRows::add(double theta_i, double phi_i, double theta_o, double phi_o, const Vec3d& f)
{
    rows_.push_back({theta_i, phi_i, theta_o, phi_o, Vec3f(f)});
    for (const double theta : {theta_i, theta_o})
        if (std::isfinite(theta)) largest_ = std::max(largest_, std::abs(theta));
}

bool AngleRows::inDegrees() const
{
    constexpr double kRounding = 1e-3;  // pi written with few digits is still radians
    return degrees_ ? *degrees_ == 1.0 : largest_ > kPi + kRounding;
}

std::string AngleRows::assumption() const
{
    return std::string("angles in ") + (inDegrees() ? "degrees" : "radians") + ", by their size";
}

void AngleRows::addTo(Source& source) const
{
    const double unit = inDegrees() ? kPi / 180.0 : 1.0;
    source.samples.reserve(rows_.size());
    for (const Row& row : rows_)
        addRow({directionFromAngles(row.theta_o * unit, row.phi_o * unit),
                directionFromAngles(row.theta_i * unit, row.phi_i * unit), Vec3d(row.f)},
               source.samples, source.report);
}

}  // namespace fbrdf
