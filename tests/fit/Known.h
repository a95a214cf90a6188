// Known.h - functions and samples whose best fit is known.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Source.h>

#include <cmath>

namespace fbrdf::test {

/// A smooth positive material of any form: every log2 texel a slow wave over its table, other for
/// each channel.
inline Material waveMaterial(const Form& form)
{
    Material material;
    material.form = form;
    for (size_t t = 0; t < form.tables.size(); ++t) {
        Table table;
        table.name = form.tables[t].name;
        table.domain = form.tables[t].domain;
        const auto size = domainSize(table.domain);
        const auto* grid = std::get_if<GridDomain>(&table.domain);
        const bool symmetric = grid && grid->symmetric;
        for (int i = 0; i < texelCount(table.domain); ++i) {
            const double x = double(i % size[0]) / size[0], y = double(i / size[0]) / size[0];
            const double a = symmetric ? x + y : x, b = symmetric ? x * y : y;
            for (int c = 0; c < 3; ++c)
                table.texels.push_back(float(std::sin(2.0 * a + double(c) + double(t)) +
                                             0.5 * std::cos(3.0 * b - double(c))));
        }
        material.tables.push_back(table);
    }
    material.scales.assign(form.terms.size(), Vec3f(0.5f, 0.3f, 0.2f));
    return material;
}

inline Source sourceOf(const Material& material)
{
    Source source;
    source.name = "wave";
    source.format = "material";
    source.isotropic = isIsotropic(material.form);
    source.evaluate = [material](const Vec3d& wo, const Vec3d& wi) {
        return evaluate(material, wo, wi);
    };
    return source;
}

/// A grey GGX metal or plastic; height-correlated Smith (Heitz 2014, Eq. 99), Schlick Fresnel.
struct Ggx {
    double alphaX, alphaY, f0, kd;

    Vec3d operator()(const Vec3d& wo, const Vec3d& wi) const
    {
        if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
        const Vec3d h = glm::normalize(wo + wi);
        const double e = h.x * h.x / (alphaX * alphaX) + h.y * h.y / (alphaY * alphaY) + h.z * h.z;
        const double d = 1.0 / (kPi * alphaX * alphaY * e * e);
        const double g = 1.0 / (1.0 + lambda(wo) + lambda(wi));
        const double fresnel = f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(h, wi), 5.0);
        return Vec3d(kd / kPi + d * g * fresnel / (4.0 * wo.z * wi.z));
    }

    double lambda(const Vec3d& v) const
    {
        const double a = alphaX * v.x, b = alphaY * v.y;
        return 0.5 * (std::sqrt(1.0 + (a * a + b * b) / (v.z * v.z)) - 1.0);
    }
};

inline Source sourceOf(const Ggx& ggx)
{
    Source source;
    source.name = "ggx";
    source.format = "model";
    source.isotropic = ggx.alphaX == ggx.alphaY;
    source.evaluate = ggx;
    return source;
}

/// The source as scattered samples at `count` pairs.
inline Source scattered(const Source& source, size_t count, uint64_t seed)
{
    Source result;
    result.name = source.name + " samples";
    result.format = "csv";
    result.isotropic = source.isotropic;
    result.samples = samplesAt(source, uniformPairs(count, seed), 1);
    result.report.given = result.samples.size();
    return result;
}

}  // namespace fbrdf::test
