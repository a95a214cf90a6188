// Tables over all four angles, or a part of them: UTIA's files, and OpenEXR images.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <OpenImageIO/imageio.h>

#include <functional>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr size_t kSide = 288, kCells = kSide * kSide;
constexpr double kFloat = 1e-5;  // tables store float, and four angles are mixed

Vec3d at(double theta, double phi)
{
    return directionFromAngles(theta * kDegree, phi * kDegree);
}

/// A cell of the synthetic UTIA table: linear in both zenith angles, a step in the azimuths.
double utiaValue(size_t light, size_t view, size_t channel)
{
    return 1.0 + double(light / 48) + 0.5 * double(view / 48) + 0.01 * double(light % 48) +
           0.001 * double(view % 48) + 10.0 * double(channel);
}

template <class T>
std::string utiaBytes()
{
    std::string bytes;
    bytes.reserve(3 * kCells * sizeof(T));
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < kCells; ++i) append(bytes, T(utiaValue(i / kSide, i % kSide, c)));
    return bytes;
}

Source read(const std::string& bytes, const std::string& name)
{
    const TempFolder folder;
    return openSource(folder.write(name, bytes));
}

using Pixel = std::function<float(int x, int y, int channel)>;

/// Writes an OpenEXR image with the given string attributes.
std::string writeExr(const TempFolder& folder, int width, int height, int channels,
                     const Pixel& pixel, const std::string& layout = "",
                     const std::string& angles = "", const std::vector<std::string>& names = {})
{
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeFloat);
    if (!names.empty()) spec.channelnames = names;
    if (!layout.empty()) spec.attribute("fbrdf:layout", layout);
    if (!angles.empty()) spec.attribute("fbrdf:theta_i", angles);
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) pixels.push_back(pixel(x, y, c));
    const std::string path = folder.path("table.exr");
    const auto output = OIIO::ImageOutput::create(path);
    output->open(path, spec);
    output->write_image(OIIO::TypeFloat, pixels.data());
    output->close();
    return path;
}

std::string bytesOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expectUtia(const Source& source)
{
    EXPECT_FALSE(source.isotropic);
    // Light at 30 degrees and azimuth 15 (cell 2, 2), view at 45 degrees and azimuth 90 (3, 12).
    EXPECT_NEAR(source.evaluate(at(45, 90), at(30, 15)).x, utiaValue(98, 156, 0), kFloat);
    EXPECT_NEAR(source.evaluate(at(45, 90), at(30, 15)).z, utiaValue(98, 156, 2), 10 * kFloat);
    // Half-way in every angle: the values are linear there.
    const double expected = 1 + 2.5 + 0.5 * 3.5 + 0.01 * 2.5 + 0.001 * 12.5;
    EXPECT_NEAR(source.evaluate(at(52.5, 93.75), at(37.5, 18.75)).x, expected, kFloat);
    // Values are interpolated across azimuth 0 and constant beyond 75 degrees.
    const double across = 0.5 * (utiaValue(96 + 47, 0, 0) + utiaValue(96, 0, 0));
    EXPECT_NEAR(source.evaluate(at(0, 0), at(30, -3.75)).x, across, kFloat);
    EXPECT_NEAR(source.evaluate(at(0, 0), at(85, 0)).x, utiaValue(240, 0, 0), kFloat);
    EXPECT_EQ(source.evaluate({0, 0, -1}, {0, 0, 1}), Vec3d(0.0));
}

}  // namespace

TEST(Utia, ReadsDoubleAndFloatPlanes)
{
    const Source doubles = read(utiaBytes<double>(), "m001.bin");
    EXPECT_EQ(doubles.format, "utia");
    expectUtia(doubles);
    expectUtia(read(utiaBytes<float>(), "m001.bin"));
}

TEST(Utia, EncodingAndWhatIsBeyondTheTableAreChoices)
{
    const TempFolder folder;
    const std::string path = folder.write("m001.bin", utiaBytes<double>());
    const Vec3d wo = at(0, 0), wi = at(85, 0);
    const double last = utiaValue(240, 0, 0), before = utiaValue(192, 0, 0);
    EXPECT_NEAR(openSource(path + "@extrapolated").evaluate(wo, wi).x,
                last + (last - before) * 10.0 / 15.0, 10 * kFloat);
    const double decoded = std::pow((last + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(openSource(path + "@srgb").evaluate(wo, wi).x, decoded, 1e-6 * decoded);
    EXPECT_EQ(openSource(path + "@srgb/extrapolated").assumptions,
              (std::vector<std::string>{"beyond 75 degrees f goes on linearly",
                                        "R, G, B are encoded as sRGB"}));
    EXPECT_EQ(openSource(path).assumptions.size(), 2u);
    EXPECT_EQ(outcomeOf(path + "@linear").kind, static_cast<int>(ErrorKind::usage));
}

TEST(Utia, SamplesAreTheCellsAndTheNormalWeighsOnce)
{
    const Source source = read(utiaBytes<float>(), "m001.bin");
    EXPECT_EQ(source.stream.rows, kCells);
    EXPECT_EQ(source.stream.geometry, "utia");
    std::vector<Sample> samples;
    SampleReport report;
    source.stream.read(98 * kSide, kSide, samples, report);
    ASSERT_EQ(samples.size(), kSide);
    EXPECT_LT(glm::length(Vec3d(samples[156].wo) - at(45, 90)), 1e-6);
    EXPECT_LT(glm::length(Vec3d(samples[156].wi) - at(30, 15)), 1e-6);
    EXPECT_FLOAT_EQ(samples[156].f.x, float(utiaValue(98, 156, 0)));
    EXPECT_FLOAT_EQ(samples[156].weight, 1.0f);
    EXPECT_FLOAT_EQ(samples[7].weight, 1.0f / 48.0f);  // a view along the normal
    expectSound(source);
}

TEST(Utia, RefusesOtherSizesAndContents)
{
    const TempFolder folder;
    const std::string bytes = utiaBytes<float>();
    for (const size_t length : {size_t(1), size_t(4), bytes.size() / 2, bytes.size() - 1})
        expectInputError(folder.write("m.bin", bytes.substr(0, length)), "3 x 288 x 288");
    expectInputError(folder.write("m.bin", std::string(bytes.size(), '\xff')), "0 of 82944 cells");
    expectInputError(folder.write("m.bin", std::string(bytes.size(), '\0')), "0 of 82944 cells");
}

TEST(Utia, NegativeAndNotFiniteCellsAreCounted)
{
    std::string bytes = utiaBytes<float>();
    const float bad[2] = {-5.0f, std::nanf("")};
    std::memcpy(&bytes[(98 * kSide + 156) * 4], bad, sizeof bad);
    const Source source = read(bytes, "m.bin");
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.negative, 1u);
    EXPECT_EQ(report.nonFinite, 1u);
    EXPECT_EQ(source.evaluate(at(45, 90), at(30, 15)).x, 0.0);
    expectSound(source);
}

TEST(ExrTable, An288ImageIsUtias)
{
    const TempFolder folder;
    const std::string path = writeExr(folder, 288, 288, 3, [](int x, int y, int c) {
        return float(utiaValue(size_t(y), size_t(x), size_t(c)));
    });
    expectUtia(openSource(path));
    EXPECT_EQ(openSource(path).format, "exr");
}

TEST(ExrTable, ASliceHasThetaHToTheRightAndThetaDUpwards)
{
    const TempFolder folder;
    const Source source = openSource(writeExr(
        folder, 10, 8, 3, [](int x, int y, int c) { return c == 0 ? float(x) : float(y); }));
    EXPECT_TRUE(source.isotropic);
    EXPECT_EQ(reportOf(source).given, 80u);
    expectSound(source);
    for (const Sample& s : allSamples(source)) {
        const HalfDifference a = halfDifferenceFromPair({Vec3d(s.wo), Vec3d(s.wi)});
        EXPECT_NEAR(a.theta_h, (double(s.f.x) + 0.5) / 10 * kPi / 2, 1e-5);
        EXPECT_NEAR(a.theta_d, (1 - (double(s.f.y) + 0.5) / 8) * kPi / 2, 1e-5);
        EXPECT_NEAR(std::cos(a.phi_d), 0.0, 1e-5);
    }
}

TEST(ExrTable, LatLongTilesAreViewHemispheres)
{
    const TempFolder folder;
    const Source source = openSource(writeExr(
        folder, 12, 8, 1, [](int x, int y, int) { return float(x + 100 * y); }, "latlong",
        "0, 40"));
    EXPECT_EQ(allSamples(source).size(), 96u);
    const Sample s = allSamples(source).at(5 * 12 + 3);  // tile 1, line 1, column 3
    EXPECT_LT(glm::length(Vec3d(s.wi) - at(40, 0)), 1e-6);
    EXPECT_LT(glm::length(Vec3d(s.wo) - at(1.5 / 4 * 90, 3.5 / 12 * 360)), 1e-6);
    EXPECT_EQ(s.f, Vec3f(503.0f));
    EXPECT_FLOAT_EQ(s.weight, float(std::sin(1.5 / 4 * 90 * kDegree)));
}

TEST(ExrTable, ChannelsAreFoundByName)
{
    const TempFolder folder;
    const auto colourOf = [&](const std::vector<std::string>& names,
                              const std::vector<float>& values) {
        const auto pixel = [&](int, int, int c) { return values[size_t(c)]; };
        const std::string path = writeExr(folder, 4, 4, int(names.size()), pixel, "", "", names);
        return allSamples(openSource(path)).at(0).f;
    };
    const std::vector<float> d65 = {0.3f * 0.95047f, 0.3f, 0.3f * 1.08883f};
    for (const std::string& layer : {std::string(), std::string("utia."), std::string("a.b.")}) {
        const Vec3f white = colourOf({layer + "X", layer + "Y", layer + "Z"}, d65);
        EXPECT_LT(glm::length(white - Vec3f(0.3f)), 1e-3f) << layer;
        EXPECT_EQ(colourOf({layer + "R", layer + "G", layer + "B"}, {0.1f, 0.2f, 0.3f}),
                  Vec3f(0.1f, 0.2f, 0.3f));
    }
    EXPECT_EQ(colourOf({"B", "R", "G", "A"}, {0.3f, 0.1f, 0.2f, 1.0f}), Vec3f(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(colourOf({"red", "green", "blue", "Z"}, {0.1f, 0.2f, 0.3f, 9.0f}),
              Vec3f(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(colourOf({"Y", "A"}, {0.25f, 1.0f}), Vec3f(0.25f));
    // Channels of two layers make no colour.
    const auto one = [](int, int, int) { return 1.0f; };
    expectInputError(writeExr(folder, 4, 4, 3, one, "", "", {"a.R", "a.G", "b.B"}),
                     "found the channels a.G, a.R, b.B");
    expectInputError(writeExr(folder, 4, 4, 3, one, "", "", {"RY", "Y", "BY"}),
                     "found the channels");
}

TEST(ExrTable, RefusesLayoutsThatDoNotFit)
{
    const TempFolder folder;
    const auto one = [](int, int, int) { return 1.0f; };
    expectInputError(writeExr(folder, 4, 4, 3, one, "cube"), "fbrdf:layout 'cube'");
    expectInputError(writeExr(folder, 4, 4, 3, one, "utia"), "expected 288 x 288");
    expectInputError(writeExr(folder, 4, 4, 3, one, "latlong"), "fbrdf:theta_i ''");
    expectInputError(writeExr(folder, 4, 4, 3, one, "latlong", "0,x"), "fbrdf:theta_i '0,x'");
    expectInputError(writeExr(folder, 4, 4, 3, one, "latlong", "0,1,2"), "3 tiles");
    expectInputError(writeExr(folder, 4, 4, 3, one, "latlong", "90,95,100,110"),
                     "no usable sample");
    expectInputError(writeExr(folder, 4, 4, 2, one), "found the channels");
    expectInputError(writeExr(folder, 4, 4, 3, [](int, int, int) { return NAN; }),
                     "no usable sample");
}

TEST(ExrTable, EveryPrefixIsSoundOrRefused)
{
    const TempFolder folder;
    const std::string bytes = bytesOf(
        writeExr(folder, 6, 5, 3, [](int x, int y, int c) { return 0.1f * float(x + y + c); }));
    EXPECT_GT(refusedPrefixes("a.exr", bytes, 3), 50u);
    expectSurvivesDamage("a.exr", bytes, 5);
}
