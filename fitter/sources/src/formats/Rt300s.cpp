// Rt300s.cpp - CSV of the J&C RT-300S scatterometer, University of Arizona LOFT group.
// Comment line, then columns stage_deg, theta_i_deg (I), A_deg, R_deg, .., brdf in 1/sr without the
// cosine. In the machine's frame wi = (-sin I, 0, cos I) and wo = (-sin A sin R, -cos A sin R,
// cos R); both are turned by -stage about the normal into the frame of the sample. Negative values
// lie below the noise floor. From the comment line of the files and the group's bsdf-tools.
// Where the detector is within 7.5 degrees of the source its arm shadows the beam (the measured
// value falls to about 0): those rows count as invalid.
#include "Formats.h"
#include "NamedTable.h"
#include "NumberRows.h"
#include "SampleRow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

const std::vector<std::string> kScopeColumns = {"stage_deg", "theta_i_deg", "a_deg", "r_deg",
                                                "brdf"};

Vec3d turnedAboutNormal(const Vec3d& w, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

bool isShadowed(const Vec3d& wo, const Vec3d& wi)
{
    return glm::dot(wo, wi) > std::cos(7.5 * kDegree);
}

}  // namespace

bool isRt300s(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    const std::vector<std::string> names = columnNamesOf(file.bytes().substr(0, 8192));
    return std::all_of(kScopeColumns.begin(), kScopeColumns.end(), [&](const std::string& column) {
        return std::count(names.begin(), names.end(), column) == 1;
    });
}

Source readRt300s(const FileRequest& request)
{
    const InputFile& file = *request.file;
    NamedTable table(file);
    std::array<size_t, 5> columns{};
    for (size_t i = 0; i < columns.size(); ++i) columns[i] = table.column(kScopeColumns[i]);
    Source source;
    source.samples.reserve(mostRows(file, columns.size()));
    while (table.next()) {
        const auto value = [&](size_t i) { return table.number(columns[i]); };
        const double incident = value(1) * kDegree, a = value(2) * kDegree, r = value(3) * kDegree;
        const Vec3d wi(-std::sin(incident), 0.0, std::cos(incident));
        const Vec3d wo(-std::sin(a) * std::sin(r), -std::cos(a) * std::sin(r), std::cos(r));
        const double back = -value(0) * kDegree;
        if (isShadowed(wo, wi))
            addInvalidRow(source.report);
        else
            addRow({turnedAboutNormal(wo, back), turnedAboutNormal(wi, back), Vec3d(value(4))},
                   source.samples, source.report);
    }
    source.assumptions.emplace_back("one channel as grey");
    source.description = "RT-300S scatterometer, one channel (650 nm), 1/sr";
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
