// Fourier BSDFs of layerlab and pbrt-v3, as written by this test from closed forms.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <functional>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

/// Coefficients of f |mu_i| for each channel: channels x orders.
using Series = std::function<std::vector<std::vector<float>>(double mu_i, double mu_o)>;

struct Head {
    uint32_t flags = 1, channels = 1, bases = 1, parameters = 0;
};

/// Cosines of both sides, with the pole of each and 0 twice, as layerlab writes them.
std::vector<float> cosines()
{
    std::vector<float> mu;
    for (int i = -10; i <= 10; ++i) {
        mu.push_back(float(i) / 10.0f);
        if (i == 0) mu.push_back(0.0f);
    }
    return mu;
}

std::string fourierFile(const Series& series, const Head& head = {},
                        const std::string& metadata = "")
{
    const std::vector<float> mu = cosines();
    std::string table, coefficients;
    uint32_t count = 0, longest = 0;
    for (const float mu_o : mu)
        for (const float mu_i : mu) {
            const auto channels = series(double(mu_i), double(mu_o));
            const auto length = static_cast<uint32_t>(channels.front().size());
            append(table, count);
            append(table, length);
            longest = std::max(longest, length);
            for (const std::vector<float>& channel : channels)
                for (const float a : channel) append(coefficients, a), ++count;
        }
    std::string bytes = "SCATFUN\x01";
    for (const uint32_t field : {head.flags, uint32_t(mu.size()), count, longest, head.channels,
                                 head.bases, uint32_t(metadata.size()), head.parameters, 0u})
        append(bytes, field);
    for (const float field : {1.5f, 0.1f, 0.1f, 0.0f, 0.0f}) append(bytes, field);
    for (const float m : mu) append(bytes, m);
    bytes.append(4 * mu.size() * mu.size(), '\0');
    return bytes + table + coefficients + metadata;
}

bool reflects(double mu_i, double mu_o)
{
    return mu_i < 0.0 && mu_o > 0.0;
}

/// A series that f |mu_i| has at reflecting pairs alone; transmission is there to be ignored.
Series reflecting(const std::function<std::vector<double>(double mu_i, double mu_o)>& f)
{
    return [f](double mu_i, double mu_o) -> std::vector<std::vector<float>> {
        if (mu_i == 0.0 || mu_o == 0.0) return {{}};
        if (!reflects(mu_i, mu_o)) return {{9.0f}};
        std::vector<float> a;
        for (const double value : f(mu_i, mu_o)) a.push_back(float(value * std::abs(mu_i)));
        return {a};
    };
}

Source read(const std::string& bytes)
{
    const TempFolder folder;
    return openSource(folder.write("layers.bsdf", bytes));
}

constexpr double kFloatTable = 1e-6;  // coefficients are float32

}  // namespace

TEST(Fourier, ALambertianIsThatFromEveryDirection)
{
    const Source source =
        read(fourierFile(reflecting([](double, double) { return std::vector<double>{0.25}; })));
    EXPECT_EQ(source.format, "fourier");
    EXPECT_TRUE(source.isotropic);
    expectSound(source);
    // Catmull-Rom splines reproduce straight lines: |mu_i| / 4 everywhere above the lowest cosine,
    // where the series of transmission beyond 0 are next.
    for (const double theta_i : {0.0, 20.0, 50.0, 80.0})
        for (const double theta_o : {0.0, 35.0, 70.0})
            EXPECT_NEAR(source
                            .evaluate(directionFromAngles(theta_o * kDegree, 0.3),
                                      directionFromAngles(theta_i * kDegree, 2.0))
                            .y,
                        0.25, kFloatTable);
    EXPECT_EQ(source.evaluate({0, 0, 1}, {0, 0.6, -0.8}), Vec3d(0.0));
}

TEST(Fourier, AzimuthZeroIsTheMirrorDirection)
{
    const Source source = read(fourierFile(reflecting([](double mu_i, double mu_o) {
        return std::vector<double>{1.0, 0.5, 0.25 * mu_o, -0.125 * mu_i};
    })));
    const Vec3d wi = directionFromAngles(1.0, 0.7);
    for (const double phi : {0.0, 0.4, 1.5, 3.0}) {  // from the mirror direction
        const Vec3d wo = directionFromAngles(0.8, 0.7 + kPi + phi);
        EXPECT_NEAR(source.evaluate(wo, wi).x,
                    1.0 + 0.5 * std::cos(phi) + 0.25 * wo.z * std::cos(2 * phi) +
                        0.125 * wi.z * std::cos(3 * phi),
                    2e-3)  // the product of mu_i and its slope is a parabola to the spline
            << phi;
    }
}

TEST(Fourier, ThreeChannelsAreLuminanceRedAndBlue)
{
    const Vec3d rgb(0.1, 0.2, 0.3);
    const double luminance = 0.212671 * rgb.x + 0.715160 * rgb.y + 0.072169 * rgb.z;
    Head head;
    head.channels = 3;
    const std::string bytes = fourierFile(
        [&](double mu_i, double mu_o) -> std::vector<std::vector<float>> {
            if (mu_i == 0.0 || mu_o == 0.0) return {{}, {}, {}};
            const double m = std::abs(mu_i);
            return {{float(luminance * m)}, {float(rgb.x * m)}, {float(rgb.z * m)}};
        },
        head, "made by a test");
    const Source source = read(bytes);
    EXPECT_LT(glm::length(source.evaluate({0.6, 0, 0.8}, {0, -0.6, 0.8}) - rgb), kFloatTable);
    EXPECT_EQ(source.assumptions.size(), 1u);
}

TEST(Fourier, RefusesWhatIsNotReadAndWhatDoesNotAddUp)
{
    const Series grey = reflecting([](double, double) { return std::vector<double>{0.25, 0.1}; });
    const auto refused = [](const std::string& bytes, const std::string& part) {
        const TempFolder folder;
        expectInputError(folder.write("layers.bsdf", bytes), part);
    };
    refused(fourierFile(grey, {3, 1, 1, 0}), "without harmonic extrapolation");
    refused(fourierFile(grey, {1, 2, 1, 0}), "expected 1 or 3");
    refused(fourierFile(grey, {1, 1, 2, 0}), "expected 1: no parameters from textures");
    refused(fourierFile(grey, {1, 1, 1, 1}), "expected 0: none from textures");
    const std::string good = fourierFile(grey);
    const auto with = [&](size_t at, uint32_t value) {
        std::string bytes = good, raw;
        append(raw, value);
        return bytes.replace(at, 4, raw);
    };
    refused(good + "x", "by the head");
    refused(with(12, 0xffffffff), "expected 4 to 65536");
    refused(with(12, 65536), "by the head");
    refused(with(16, 0xffffffff), "by the head");
    refused(with(64, 0x7fc00000), "ascending ones from -1 to 1");
    const size_t n = cosines().size();
    refused(with(64 + 4 * (n + n * n) + 4, 3), "a series of 3 from coefficient 0");
    refused(with(64 + 4 * (n + n * n), 0xffffffff), "expected one within the file");
    refused(with(good.size() - 4, 0x7f800000), "not finite");
}

TEST(Fourier, EveryPrefixIsRefusedAndDamageSurvived)
{
    const std::string bytes = fourierFile(reflecting([](double, double) {
        return std::vector<double>{0.25, 0.1};
    }));
    const size_t step = 37;
    EXPECT_EQ(refusedPrefixes("layers.bsdf", bytes, step), (bytes.size() + step - 1) / step);
    EXPECT_EQ(refusedPrefixes("layers.bsdf", bytes.substr(0, 200)), 200u);
    expectSurvivesDamage("layers.bsdf", bytes, 53);
}
