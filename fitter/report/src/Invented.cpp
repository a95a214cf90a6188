#include "Invented.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Small enough that no pixel reaches 1, where a picture of the standard sphere ends.
constexpr double kDimmed = 0x1p-40;

double inventedWeight(const Table& table, const Vec3d& position)
{
    if (table.unsupported.empty()) return 0.0;
    const Stencil<double> stencil = stencilAt(table.domain, position);
    double weight = 0.0;
    for (size_t k = 0; k < static_cast<size_t>(stencil.count); ++k)
        if (table.unsupported[static_cast<size_t>(stencil.texel[k])]) weight += stencil.weight[k];
    return weight;
}

double inventedShareOf(const Material& material, const Term& term,
                       const PairGeometry<double>& geometry)
{
    double supported = 1.0;
    for (const Factor& factor : term.factors) {
        const Table& table = material.tables[static_cast<size_t>(factor.table)];
        supported *=
            1.0 - inventedWeight(table, texelPosition(table.domain, factor.argument, geometry));
    }
    return 1.0 - supported;
}

double magnitude(const Vec3d& value)
{
    return std::abs(value.x) + std::abs(value.y) + std::abs(value.z);
}

// The material with one of its terms alone.
std::vector<Material> termsOf(const Material& material)
{
    std::vector<Material> terms(material.form.terms.size(), material);
    for (size_t t = 0; t < terms.size(); ++t) {
        terms[t].form.terms = {material.form.terms[t]};
        terms[t].scales = {material.scales[t]};
    }
    return terms;
}

double inventedShare(const std::vector<Material>& terms, const Vec3d& wo, const Vec3d& wi)
{
    if (!(wo.z > 0.0) || !(wi.z > 0.0)) return 0.0;
    const PairGeometry<double> geometry(DirectionPair<double>{wo, wi});
    double invented = 0.0, all = 0.0;
    for (const Material& term : terms) {
        const double value = magnitude(evaluate<double>(term, wo, wi));
        invented += value * inventedShareOf(term, term.form.terms.front(), geometry);
        all += value;
    }
    return all > 0.0 ? invented / all : 0.0;
}

}  // namespace

bool hasInvented(const Material& material)
{
    return std::any_of(material.tables.begin(), material.tables.end(),
                       [](const Table& table) { return table.unsupportedCount() > 0; });
}

double inventedShare(const Material& material, const Vec3d& wo, const Vec3d& wi)
{
    return inventedShare(termsOf(material), wo, wi);
}

InventedSphere inventedSphere(const Material& material, int size)
{
    const std::vector<Material> terms = termsOf(material);
    const auto dimmed = [&](const Vec3d& wo, const Vec3d& wi) {
        return kDimmed * evaluate<double>(material, wo, wi);
    };
    const auto inventedPart = [&](const Vec3d& wo, const Vec3d& wi) {
        return inventedShare(terms, wo, wi) * dimmed(wo, wi);
    };
    const SphereImage all = renderStandardSphere(dimmed, size),
                      invented = renderStandardSphere(inventedPart, size);
    const auto brightness = [](const Vec3f& radiance) { return magnitude(Vec3d(radiance)); };
    InventedSphere sphere;
    double sumOfAll = 0.0, sumOfInvented = 0.0;
    for (size_t i = 0; i < all.radiance.size(); ++i) {
        const double of = brightness(all.radiance[i]), part = brightness(invented.radiance[i]);
        sphere.shares.push_back(of > 0.0 ? std::min(part / of, 1.0) : 0.0);
        sumOfAll += of;
        sumOfInvented += part;
    }
    if (sumOfAll > 0.0) sphere.total = std::min(sumOfInvented / sumOfAll, 1.0);
    return sphere;
}

}  // namespace fbrdf
