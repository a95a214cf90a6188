#include "bench/Materials.h"

#include <fbrdf/fit/Fit.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fbrdf::bench {
namespace {

/// F of a table at the angles of its arguments (radians), or at the zenith angle of a disc's
/// direction.
using TableFunction = std::function<Vec3d(const std::vector<double>& angles)>;

double distribution(double theta_h)
{
    const double c = std::cos(theta_h), a2 = kAlpha * kAlpha, sum = 1.0 + c * c * (a2 - 1.0);
    return a2 / (kPi * sum * sum);
}

/// |w| as ggx.glsl defines it.
double slopeLength(double theta)
{
    const double c = std::cos(theta), s = std::sin(theta);
    return std::sqrt(kAlpha * kAlpha * s * s + c * c);
}

/// 1 / (2 (NoL |o| + NoV |i|)).
double visibility(double theta_i, double theta_o)
{
    const double i = std::cos(theta_i), o = std::cos(theta_o);
    return 0.5 / (i * slopeLength(theta_o) + o * slopeLength(theta_i));
}

Vec3d fresnel(double theta_d)
{
    return kF0 + (Vec3d(1.0) - kF0) * std::pow(1.0 - std::cos(theta_d), 5.0);
}

/// The function in the table that a form calls `name`.
TableFunction functionOf(const std::string& name, bool isSum)
{
    if (name == "p")  // the square root of V at equal angles: exact on the diagonal
        return [](const auto& a) { return Vec3d(std::sqrt(visibility(a[0], a[0]))); };
    if (name == "q") return [](const auto& a) { return distribution(a[0]) * kF0; };
    if (name == "r") return [](const auto& a) { return fresnel(a[0]) / kF0; };
    if (name.rfind("T1", 0) == 0 || name.rfind("V", 0) == 0)
        return [](const auto& a) { return distribution(a[0]) * fresnel(a[1]); };
    if (isSum && name == "T2") return [](const auto&) { return kDiffuse / kPi; };
    return [](const auto& a) { return Vec3d(visibility(a[0], a[1])); };
}

std::vector<double> anglesAt(const Domain& domain, int texel)
{
    const auto size = domainSize(domain);
    const int x = texel % size[0], y = texel / size[0];
    if (const auto* disc = std::get_if<DiscDomain>(&domain))
        return {std::acos(directionFromDiscPosition(*disc, {x, y}).z)};
    std::vector<double> angles;
    int rest = texel;
    for (const Axis& axis : std::get<GridDomain>(domain).axes) {
        const int i = rest % axis.size;
        rest /= axis.size;
        angles.push_back(angleFromAxisCoordinate(axis.map, i / std::max(1.0, axis.size - 1.0)));
    }
    return angles;
}

fbrdf::Table filled(const TableSpec& spec, const TableFunction& function)
{
    constexpr double kNearHorizon = 89.0 / 180.0 * kPi;  // V has a pole at two grazing directions
    fbrdf::Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    for (int i = 0; i < texelCount(spec.domain); ++i) {
        auto angles = anglesAt(spec.domain, i);
        for (double& angle : angles) angle = std::min(angle, kNearHorizon);
        const Vec3d value = function(angles);
        for (int c = 0; c < 3; ++c) table.texels.push_back(static_cast<float>(std::log2(value[c])));
    }
    return quantized(table, Storage::log8);
}

}  // namespace

Material ggxMaterial(const std::string& form)
{
    Material material;
    material.form = makeForm(form);
    material.name = form;
    const bool isSum = material.form.terms.size() > 1;
    for (const TableSpec& spec : material.form.tables)
        material.tables.push_back(filled(spec, functionOf(spec.name, isSum)));
    material.scales.assign(material.form.terms.size(), Vec3f(1.0f));
    validate(material, "benchmark");
    return material;
}

}  // namespace fbrdf::bench
