#include "SampleRow.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

bool isFinite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// False for a direction that cannot be normalised. Where squares would be infinite or 0, as those
/// of 1e200 are, divides by the largest component first.
bool normalise(Vec3d& v)
{
    constexpr double kSmall = 1e-200, kLarge = 1e200;
    const double square = glm::dot(v, v);
    if (square > kSmall && square < kLarge) {
        v *= 1.0 / std::sqrt(square);
        return true;
    }
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0)) return false;
    v /= largest;
    v /= glm::length(v);
    return true;
}

/// NaN fails every comparison, so this is "finite, and small enough for float".
bool fitsFloat(const SampleRow& row)
{
    constexpr double kLargest = 3e38;
    const Vec3d size = glm::abs(row.f);
    return size.x < kLargest && size.y < kLargest && size.z < kLargest && row.weight >= 0.0 &&
           row.weight < kLargest;
}

}  // namespace

Vec3d directionFromDegrees(double theta, double phi)
{
    return directionFromAngles(theta * (kPi / 180.0), phi * (kPi / 180.0));
}

void addRow(const SampleRow& row, std::vector<Sample>& samples, SampleReport& report)
{
    SampleRow unit = row;
    if (isFinite(row.wo) && isFinite(row.wi) && normalise(unit.wo) && normalise(unit.wi)) {
        addUnitRow(unit, samples, report);
        return;
    }
    ++report.given;
    ++report.nonFinite;
}

void addUnitRow(const SampleRow& row, std::vector<Sample>& samples, SampleReport& report)
{
    ++report.given;
    if (!fitsFloat(row)) {
        ++report.nonFinite;
        return;
    }
    if (row.wo.z < kHorizonCosine || row.wi.z < kHorizonCosine) {
        ++report.belowHorizon;
        return;
    }
    const Vec3f f(row.f);
    report.negative += std::min({f.x, f.y, f.z}) < 0.0f;
    report.zero += f.x == 0.0f || f.y == 0.0f || f.z == 0.0f;
    samples.push_back({Vec3f(row.wo), Vec3f(row.wi), f, static_cast<float>(row.weight)});
}

void addInvalidRow(SampleReport& report)
{
    ++report.given;
    ++report.invalid;
}

std::string briefReport(const SampleReport& report)
{
    std::string text = std::to_string(report.given) + " rows";
    const auto add = [&](uint64_t count, const char* what) {
        if (count) text += ", " + std::to_string(count) + " " + what;
    };
    add(report.nonFinite, "not finite");
    add(report.belowHorizon, "below the horizon");
    add(report.invalid, "marked invalid");
    return text;
}

void requireSamples(const Source& source, const std::string& where)
{
    constexpr size_t kBlock = 1024;  // most streams have a usable row among the first
    std::vector<Sample> samples;
    SampleReport report = source.report;
    if (!source.samples.empty()) return;
    for (uint64_t first = 0; first < source.stream.rows; first += kBlock) {
        const uint64_t count = std::min<uint64_t>(kBlock, source.stream.rows - first);
        source.stream.read(first, static_cast<size_t>(count), samples, report);
        if (!samples.empty()) return;
    }
    throw Error(ErrorKind::input, where,
                Found("no usable sample (" + briefReport(report) + ")")
                    .expected("at least one that is finite and above the horizon"));
}

}  // namespace fbrdf
