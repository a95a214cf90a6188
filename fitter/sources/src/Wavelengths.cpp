#include "Wavelengths.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Spectrum.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

constexpr double kMicrometre = 1e3, kMetre = 1e9;  // in nm
/// Half of the least difference between two laser lines in a table with three decimals of a um.
constexpr double kSameLine = 0.5;
constexpr double kFirstVisible = 380.0, kLastVisible = 780.0;
constexpr size_t kListed = 12;

bool allWithin(const std::vector<double>& values, double lower, double upper)
{
    return std::all_of(values.begin(), values.end(),
                       [&](double value) { return value >= lower && value < upper; });
}

}  // namespace

std::optional<double> nanometresInUnitOf(const std::vector<double>& wavelengths)
{
    if (wavelengths.empty()) return {};
    if (allWithin(wavelengths, 100.0, 1e6)) return 1.0;
    if (allWithin(wavelengths, 0.1, 100.0)) return kMicrometre;
    if (allWithin(wavelengths, 1e-8, 1e-4)) return kMetre;
    return {};
}

const char* nameOfWavelengthUnit(double nanometres)
{
    return nanometres == 1.0 ? "nm" : nanometres == kMicrometre ? "um" : "m";
}

double wavelengthNamed(const std::string& name)
{
    for (const auto& [unit, nanometres] :
         {std::pair<std::string_view, double>{"nm", 1.0}, {"um", 1e3}, {"\xC2\xB5m", 1e3}}) {
        double value = 0.0;
        const std::string lower = lowerCase(name);
        if (lower.size() <= unit.size() || lower.substr(lower.size() - unit.size()) != unit)
            continue;
        const std::string_view number = trimmed(lower).substr(0, lower.size() - unit.size());
        if (parseLocalNumber(trimmed(number), value)) return value * nanometres;
    }
    return 0.0;
}

BandColour::BandColour(const FileRequest& request, const std::vector<double>& wavelengths)
    : order_(wavelengths.size())
{
    const std::optional<double> unit = nanometresInUnitOf(wavelengths);
    if (!unit)
        throw inputError(
            *request.file,
            wavelengths.empty()
                ? Found("no wavelength").expected("at least one")
                : fmt::format(
                      Found("wavelengths from {:.6g} to {:.6g}")
                          .expected("all in nm (100 and more), um (below 100) or m (below 1e-4)"),
                      *std::min_element(wavelengths.begin(), wavelengths.end()),
                      *std::max_element(wavelengths.begin(), wavelengths.end())));
    unit_ = *unit;
    std::iota(order_.begin(), order_.end(), size_t(0));
    std::sort(order_.begin(), order_.end(),
              [&](size_t a, size_t b) { return wavelengths[a] < wavelengths[b]; });
    for (const size_t i : order_) wavelengths_.push_back(wavelengths[i] * unit_);
    if (std::adjacent_find(wavelengths_.begin(), wavelengths_.end()) != wavelengths_.end())
        throw inputError(*request.file, Found("a wavelength twice").expected("each once"));
    choose(request);
}

void BandColour::choose(const FileRequest& request)
{
    if (!request.choice.empty()) {
        std::vector<double> wanted(1);
        const bool read = parseLocalNumber(request.choice, wanted[0]);
        const double nm = wanted[0] * nanometresInUnitOf(wanted).value_or(0.0);
        for (size_t i = 0; read && i < order_.size(); ++i)
            if (std::abs(wavelengths_[i] - nm) <= kSameLine) {
                wavelengths_ = {wavelengths_[i]};
                chosen_ = order_[i];
                return;
            }
        throw Error(ErrorKind::usage, request.file->path(),
                    Found("the choice " + inQuotes(request.choice))
                        .expected("one of the wavelengths " + listed() + " nm"));
    }
    if (wavelengths_.size() == 1) return;
    if (wavelengths_.back() < kFirstVisible || wavelengths_.front() > kLastVisible)
        throw inputError(*request.file, Found("no visible wavelength among " + listed() + " nm")
                                            .expected("a choice of one: FILE@WAVELENGTH"));
    const SpectrumToRgb toRgb(wavelengths_);
    std::vector<double> unit(wavelengths_.size());
    weights_.resize(wavelengths_.size());
    for (size_t i = 0; i < order_.size(); ++i) {
        unit[i] = 1.0;
        weights_[order_[i]] = toRgb(unit.data());
        unit[i] = 0.0;
    }
}

Vec3d BandColour::operator()(const double* values) const
{
    if (weights_.empty()) return Vec3d(values[chosen_]);
    Vec3d rgb(0.0);
    for (size_t i = 0; i < weights_.size(); ++i) rgb += weights_[i] * values[i];
    return rgb;
}

std::string BandColour::listed() const
{
    std::string text;
    for (size_t i = 0; i < std::min(kListed, wavelengths_.size()); ++i)
        text += fmt::format("{}{:.6g}", i > 0 ? ", " : "", wavelengths_[i]);
    return wavelengths_.size() > kListed ? text + fmt::format(", ... {:.6g}", wavelengths_.back())
                                         : text;
}

std::string BandColour::description() const
{
    if (weights_.empty()) return fmt::format("one band, {:.6g} nm", wavelengths_.front());
    return fmt::format("{} wavelengths from {:.6g} to {:.6g} nm to linear sRGB (D65, CIE 1931)",
                       wavelengths_.size(), wavelengths_.front(), wavelengths_.back());
}

std::vector<std::string> BandColour::assumptions() const
{
    std::vector<std::string> found;
    if (unit_ != 1.0)
        found.push_back(std::string("wavelengths in ") + nameOfWavelengthUnit(unit_) +
                        ", by their size");
    if (weights_.empty()) found.emplace_back("one band as grey");
    return found;
}

}  // namespace fbrdf
