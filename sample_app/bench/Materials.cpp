#include "bench/Materials.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/AnalyticFactors.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/fit/Svd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <variant>

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

/// The factor of GGX that a table stands for. angles: of its arguments; of a disc the zenith angle.
Vec3d ofDirection(const Direction& direction, double theta)
{
    if (direction == Direction::h) return distribution(theta) * kF0;
    if (direction == Direction::d) return fresnel(theta) / kF0;
    // The square root of V at equal angles: exact on the diagonal.
    if (direction == Direction::wo || direction == Direction::wi)
        return Vec3d(std::sqrt(visibility(theta, theta)));
    return Vec3d(0.5 + 0.5 * std::cos(theta));  // a half vector near the normal: any smooth factor
}

Vec3d ofAngles(const std::vector<Angle>& names, const std::vector<double>& angles)
{
    if (names[0] == Angle::theta_h)
        return distribution(angles[0]) * (names.size() > 1 ? fresnel(angles[1]) : kF0);
    if (names[0] == Angle::theta_d) return fresnel(angles[0]) / kF0;
    if (names.size() > 1) return Vec3d(visibility(angles[0], angles[1]));
    return Vec3d(std::sqrt(visibility(angles[0], angles[0])));
}

TableFunction ggxFactor(const Argument& argument)
{
    if (const auto* direction = std::get_if<Direction>(&argument))
        return [d = *direction](const auto& angles) { return ofDirection(d, angles[0]); };
    return [names = std::get<std::vector<Angle>>(argument)](const auto& angles) {
        return ofAngles(names, angles);
    };
}

/// Of the first factor that looks the table up.
TableFunction functionOf(const Form& form, int table)
{
    for (size_t t = 0; t < form.terms.size(); ++t) {
        const auto& factors = form.terms[t].factors;
        const auto found = std::find_if(factors.begin(), factors.end(),
                                        [&](const Factor& f) { return f.table == table; });
        if (found == factors.end()) continue;
        if (form.terms.size() == 1 || t > 0) return ggxFactor(found->argument);
        const double share = 1.0 / static_cast<double>(factors.size());
        return [share](const auto&) { return glm::pow(kDiffuse / kPi, Vec3d(share)); };
    }
    throw Error(ErrorKind::usage, "form",
                Found("table '" + form.tables[static_cast<size_t>(table)].name + "' without a use")
                    .expected("one in a product"));
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

Material productMaterial(const std::string& form)
{
    Material material;
    material.form = makeForm(form);
    for (size_t k = 0; k < material.form.tables.size(); ++k)
        material.tables.push_back(
            filled(material.form.tables[k], functionOf(material.form, static_cast<int>(k))));
    material.scales.assign(material.form.terms.size(), Vec3f(1.0f));
    return material;
}

constexpr char kSvd[] = "svd", kAnalytic[] = "analytic:";

bool startsWith(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}

/// Throws Error(usage) where no number follows "svd".
Material svdOfGgx(const std::string& form)
{
    const std::string digits = form.substr(std::size(kSvd) - 1);
    const bool isNumber = !digits.empty() && digits.size() <= 2 &&
                          digits.find_first_not_of("0123456789") == std::string::npos;
    const int terms = isNumber ? std::stoi(digits) : 0;
    if (terms < 1 || terms > kMaxSvdTerms)
        throw Error(ErrorKind::usage, "form",
                    Found("'" + form + "'").expected("svd1 to svd" + std::to_string(kMaxSvdTerms)));
    const BrdfFunction ggx = [](const Vec3d& wo, const Vec3d& wi) {
        const auto angle = [](double cosine) { return std::acos(std::min(cosine, 1.0)); };
        const Vec3d h = glm::normalize(wo + wi);
        return distribution(angle(h.z)) * fresnel(angle(glm::dot(h, wi))) *
               visibility(angle(wi.z), angle(wo.z));
    };
    return svdMaterial(ggx, formSvd(terms, kSvdSize, true), 0);
}

Material modelMaterial(const std::string& form)
{
    constexpr int kTexels = 64;  // on a side of q, as the fit takes where nothing else is asked for
    const std::string model = form.substr(std::size(kAnalytic) - 1);
    const auto material = analyticFactors(model, kTexels, Storage::log8);
    if (material) return *material;
    throw Error(ErrorKind::usage, "form",
                Found("'" + form + "'").expected("analytic:ward or analytic:ashikhmin-shirley"));
}

}  // namespace

std::vector<std::string> allForms()
{
    std::vector<std::string> forms;
    for (const NamedForm& named : namedForms()) forms.push_back(named.name);
    for (const char* sum : {"io+hdio", "u+hdpu", "gg+pqpr"}) forms.push_back(sum);
    for (const char* terms : {"2", "4", "8"}) forms.push_back(kSvd + std::string(terms));
    for (const char* model : {"ward", "ashikhmin-shirley"})
        forms.push_back(kAnalytic + std::string(model));
    return forms;
}

Material benchMaterial(const std::string& form)
{
    Material material = startsWith(form, kSvd)        ? svdOfGgx(form)
                        : startsWith(form, kAnalytic) ? modelMaterial(form)
                                                      : productMaterial(form);
    material.name = form;
    validate(material, "benchmark");
    return material;
}

}  // namespace fbrdf::bench
