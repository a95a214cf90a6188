#include <fbrdf/peers/LinearMaps.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fbrdf {
namespace {

// Texels of a channel below the scale: all of them, or all but the few brightest.
constexpr double kQuantiles[] = {1.0, 0.98, 0.9, 0.75, 0.5};

float quantileOf(const Table& table, int channel, double quantile)
{
    std::vector<float> values;
    for (int i = 0; i < texelCount(table.domain); ++i) values.push_back(table.texel(i, channel));
    const auto rank =
        static_cast<std::ptrdiff_t>(quantile * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<size_t>(rank)];
}

// The table (log2 texels) divided by its scale, which goes to the term as often as it is used.
Table scaledTable(const Material& material, size_t index, double quantile, Vec3f& logScale)
{
    Table table = material.tables[index];
    int uses = 0;
    for (const Factor& factor : material.form.terms[0].factors)
        uses += factor.table == static_cast<int>(index) ? 1 : 0;
    for (int c = 0; c < 3; ++c) {
        const float level = quantileOf(material.tables[index], c, quantile);
        for (int i = 0; i < texelCount(table.domain); ++i)
            table.texels[static_cast<size_t>(3 * i + c)] -= level;
        logScale[c] += static_cast<float>(uses) * level;
    }
    return quantized(table, Storage::linear8);
}

Material scaledBy(const Material& material, const std::vector<double>& quantiles)
{
    Material scaled = material;
    Vec3f logScale(0.0f);
    for (size_t t = 0; t < scaled.tables.size(); ++t)
        scaled.tables[t] = scaledTable(material, t, quantiles[t], logScale);
    for (int c = 0; c < 3; ++c) scaled.scales[0][c] *= std::exp2(logScale[c]);
    return scaled;
}

// The next combination of quantiles; false after the last.
bool advance(std::vector<size_t>& choice)
{
    for (size_t& digit : choice) {
        if (++digit < std::size(kQuantiles)) return true;
        digit = 0;
    }
    return false;
}

}  // namespace

Material linearMaps(const Material& material, const MaterialError& errorOf)
{
    if (material.form.terms.size() != 1)
        throw Error(ErrorKind::usage, "linear maps",
                    Found(std::to_string(material.form.terms.size()) + " terms").expected("one"));
    Material best;
    double bestError = std::numeric_limits<double>::infinity();
    std::vector<size_t> choice(material.tables.size(), 0);
    do {
        std::vector<double> quantiles;
        for (const size_t digit : choice) quantiles.push_back(kQuantiles[digit]);
        const Material scaled = scaledBy(material, quantiles);
        const double error = errorOf(scaled);
        if (error < bestError) {
            bestError = error;
            best = scaled;
        }
    } while (advance(choice));
    return best;
}

}  // namespace fbrdf
