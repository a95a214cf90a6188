#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Material.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Evaluation looks up a table's own domain with the form's arguments, so both must have one domain.
void validateTable(const Table& table, const TableSpec& spec, const std::string& where)
{
    const std::string name = "table '" + spec.name + "'";
    if (!sameDomain(table.domain, spec.domain))
        throw Error(ErrorKind::input, where,
                    Found(name + " over another domain").expected("the form's"));
    if (table.channels != 1 && table.channels != 3)
        throw Error(
            ErrorKind::input, where,
            Found(name + " of " + std::to_string(table.channels) + " channels").expected("1 or 3"));
    const size_t numbers =
        static_cast<size_t>(texelCount(table.domain)) * static_cast<size_t>(table.channels);
    if (table.texels.size() != numbers)
        throw Error(ErrorKind::input, where,
                    Found(name + " of " + std::to_string(table.texels.size()) + " numbers")
                        .expected(std::to_string(numbers)));
    if (!table.unsupported.empty() &&
        table.unsupported.size() != static_cast<size_t>(texelCount(table.domain)))
        throw Error(ErrorKind::input, where,
                    Found(name + " with " + std::to_string(table.unsupported.size()) + " marks")
                        .expected("one a texel or none"));
    for (const float texel : table.texels)
        if (!std::isfinite(texel))
            throw Error(
                ErrorKind::input, where,
                Found(name + " with a number that is not finite").expected("finite numbers"));
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(table.lower[c]) || !std::isfinite(table.upper[c]))
            throw Error(
                ErrorKind::input, where,
                Found(name + " with a range that is not finite").expected("finite numbers"));
}

template <class T>
Vec3<T> evaluateTerm(const Material& material, size_t index, const PairGeometry<T>& geometry)
{
    Vec3<T> logSum(T(0)), product(T(1));
    for (const Factor& factor : material.form.terms[index].factors) {
        const Table& table = material.tables[static_cast<size_t>(factor.table)];
        const Vec3<T> value = sample(table, texelPosition(table.domain, factor.argument, geometry));
        if (isLog(table.storage))
            logSum += value;
        else
            product *= value;
    }
    const Vec3<T> scale(material.scales[index]);
    for (int c = 0; c < 3; ++c) product[c] *= scale[c] * std::exp2(logSum[c]);
    return product;
}

}  // namespace

size_t materialBytes(const Material& material)
{
    size_t bytes = 0;
    for (const Table& table : material.tables) bytes += table.bytes();
    return bytes;
}

bool hasSigns(const Material& material)
{
    return std::any_of(material.tables.begin(), material.tables.end(),
                       [](const Table& table) { return table.storage == Storage::signedHalf; });
}

void validate(const Material& material, const std::string& where)
{
    validate(material.form, where);
    if (material.tables.size() != material.form.tables.size())
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(material.tables.size()) + " tables")
                        .expected("the form's " + std::to_string(material.form.tables.size())));
    if (material.scales.size() != material.form.terms.size())
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(material.scales.size()) + " scales")
                        .expected("one for each of " + std::to_string(material.form.terms.size()) +
                                  " terms"));
    for (const Vec3f& scale : material.scales)
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(scale[c]) || scale[c] < 0.0f)
                throw Error(ErrorKind::input, where,
                            Found("a scale that is negative or not finite")
                                .expected("finite numbers >= 0"));
    for (size_t k = 0; k < material.tables.size(); ++k)
        validateTable(material.tables[k], material.form.tables[k], where);
    validate(material.lobes, where);
}

template <class T>
Vec3<T> evaluate(const Material& material, const Vec3<T>& wo, const Vec3<T>& wi)
{
    FBRDF_ASSERT(material.tables.size(), ==, material.form.tables.size());
    FBRDF_ASSERT(material.scales.size(), ==, material.form.terms.size());
    Vec3<T> sum(T(0));
    if (!(wo.z > T(0)) || !(wi.z > T(0))) return sum;
    const PairGeometry<T> geometry(DirectionPair<T>{wo, wi});
    for (size_t t = 0; t < material.form.terms.size(); ++t)
        sum += evaluateTerm(material, t, geometry);
    return sum;
}

Vec3f diffuseAlbedo(const Material& material)
{
    // A grid of directions of light, even in cos^2 (so that each weighs the same under the cosine)
    // and in azimuth. 16 x 16 is within a few percent of the integral for all but mirrors.
    constexpr int kGrid = 16;
    const Vec3f wo(std::sqrt(0.5f), 0.0f, std::sqrt(0.5f));
    Vec3f sum(0.0f);
    for (int i = 0; i < kGrid; ++i)
        for (int j = 0; j < kGrid; ++j) {
            const float square = (static_cast<float>(i) + 0.5f) / kGrid;
            const float phi =
                2.0f * static_cast<float>(kPi) * (static_cast<float>(j) + 0.5f) / kGrid;
            const float sine = std::sqrt(1.0f - square);
            sum += evaluate<float>(material, wo,
                                   {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(square)});
        }
    Vec3f albedo;
    for (int c = 0; c < 3; ++c)
        albedo[c] = std::clamp(sum[c] * static_cast<float>(kPi) / (kGrid * kGrid), 0.0f, 1.0f);
    return albedo;
}

template Vec3<float> evaluate(const Material&, const Vec3<float>&, const Vec3<float>&);
template Vec3<double> evaluate(const Material&, const Vec3<double>&, const Vec3<double>&);

}  // namespace fbrdf
