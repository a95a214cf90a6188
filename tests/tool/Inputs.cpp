#include "Inputs.h"

#include <fbrdf/base/Text.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace fbrdf::test {
namespace {

// Fractional parts of multiples of powers of 1 / x, x^5 = x + 1: Roberts 2018, "The unreasonable
// effectiveness of quasirandom sequences", d = 4.
double kronecker(size_t index, int dimension)
{
    constexpr double kRoot = 1.1673039782614187;
    const double step = std::pow(1.0 / kRoot, dimension + 1);
    const double value = 0.5 + step * static_cast<double>(index);
    return value - std::floor(value);
}

Vec3d direction(double u, double v)
{
    const double z = 0.05 + 0.95 * u, r = std::sqrt(1.0 - z * z), phi = 2.0 * kPi * v;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

float smoothTexel(int index, int channel)
{
    return -1.0f - 0.5f * std::sin(0.37f * static_cast<float>(index)) -
           0.25f * static_cast<float>(channel);
}

}  // namespace

std::vector<DirectionPair<double>> spreadPairs(size_t count)
{
    std::vector<DirectionPair<double>> pairs;
    pairs.reserve(count);
    for (size_t i = 0; i < count; ++i)
        pairs.push_back({direction(kronecker(i, 0), kronecker(i, 1)),
                         direction(kronecker(i, 2), kronecker(i, 3))});
    return pairs;
}

std::string pairText(const DirectionPair<double>& pair)
{
    return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", pair.wo.x, pair.wo.y,
                       pair.wo.z, pair.wi.x, pair.wi.y, pair.wi.z);
}

std::string pairsCsv(const std::vector<DirectionPair<double>>& pairs)
{
    std::string text = std::string(kPairHeader) + "\n";
    for (const auto& pair : pairs) text += pairText(pair) + "\n";
    return text;
}

Vec3d glossy(const Vec3d& wo, const Vec3d& wi)
{
    const double gloss = std::pow(glm::normalize(wo + wi).z, 20.0);
    return Vec3d(0.2, 0.1, 0.05) + Vec3d(1.0, 1.2, 1.8) * gloss;
}

std::string samplesCsv(size_t count, double factor)
{
    std::string text = std::string(kSampleHeader) + "\n";
    for (const auto& pair : spreadPairs(count)) {
        const Vec3d f = factor * glossy(pair.wo, pair.wi);
        text += pairText(pair) + fmt::format(",{},{},{}\n", f.x, f.y, f.z);
    }
    return text;
}

Material smallMaterial(const std::string& form)
{
    Material material;
    material.form = form == "pqp" ? formPqp(16, 1.0) : formHdio({12, 6, 6});
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        for (int i = 0; i < texelCount(spec.domain); ++i)
            for (int c = 0; c < 3; ++c) table.texels.push_back(smoothTexel(i, c));
        material.tables.push_back(table);
    }
    material.scales = {Vec3f(1.0f, 0.5f, 0.25f)};
    material.name = "small";
    return material;
}

std::vector<std::string> quickFit(const std::string& source, const std::string& output)
{
    return {"fit",
            source,
            "-o",
            output,
            "--form",
            "hdio",
            "--resolution",
            "16",
            "--smoothness",
            "0.001",
            "--plain",
            "--environment-lobes",
            "0"};
}

std::string smallSky()
{
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            for (const int byte : {200 - 40 * y, 180 - 30 * y, 150, 129})
                bytes += static_cast<char>(byte);
    return bytes;
}

std::vector<double> numbersOf(const std::string& line)
{
    std::vector<double> numbers;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');)
        EXPECT_TRUE(parseNumber(field, numbers.emplace_back())) << line;
    return numbers;
}

}  // namespace fbrdf::test
