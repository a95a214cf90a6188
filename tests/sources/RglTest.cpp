// Reference values of the real files: the data set's parse.py (numpy).
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <functional>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

struct Field {
    std::string name;
    std::vector<uint64_t> shape;
    int type;
    std::string data;
};

std::string floats(size_t count, const std::function<float(size_t)>& value)
{
    std::string bytes;
    for (size_t i = 0; i < count; ++i) append(bytes, value(i));
    return bytes;
}

Field floatField(const std::string& name, std::vector<uint64_t> shape,
                 const std::function<float(size_t)>& value)
{
    size_t count = 1;
    for (const uint64_t extent : shape) count *= extent;
    return {name, std::move(shape), 10, floats(count, value)};
}

std::string tensorFile(const std::vector<Field>& fields)
{
    size_t table = 18;
    for (const Field& field : fields) table += 2 + field.name.size() + 11 + 8 * field.shape.size();
    std::string head("tensor_file\0\1\0", 14), data;
    append(head, uint32_t(fields.size()));
    for (const Field& field : fields) {
        append(head, uint16_t(field.name.size()));
        head += field.name;
        append(head, uint16_t(field.shape.size()));
        append(head, uint8_t(field.type));
        append(head, uint64_t(table + data.size()));
        for (const uint64_t extent : field.shape) append(head, extent);
        data += field.data;
    }
    return head + data;
}

/// The content of a small file: P x T slices, rgb nodes by a function of (slice, channel, x, y).
struct Small {
    std::vector<float> phi{0.0f};
    std::vector<float> theta{0.0f, 0.8f, 1.57f};
    std::function<float(size_t slice, size_t channel, size_t x, size_t y)> value =
        [](size_t, size_t, size_t, size_t) { return 1.0f; };
    bool spectral = false;
};

constexpr size_t kSide = 4;

std::vector<Field> fieldsOf(const Small& small)
{
    const uint64_t p = small.phi.size(), t = small.theta.size(), bands = small.spectral ? 5 : 3;
    const auto one = [](size_t) { return 1.0f; };
    const auto node = [&](size_t i) {
        return small.value(i / (kSide * kSide) / bands, i / (kSide * kSide) % bands, i % kSide,
                           i / kSide % kSide);
    };
    std::vector<Field> fields = {
        floatField("phi_i", {p}, [&](size_t i) { return small.phi[i]; }),
        floatField("theta_i", {t}, [&](size_t i) { return small.theta[i]; }),
        floatField("ndf", {2, 3}, one),
        floatField("sigma", {2, 2}, one),
        floatField("vndf", {p, t, 3, 3}, one),
        floatField(small.spectral ? "spectra" : "rgb", {p, t, bands, kSide, kSide}, node),
        {"jacobian", {1}, 1, std::string(1, '\1')}};
    if (small.spectral)
        fields.push_back(
            floatField("wavelengths", {bands}, [](size_t i) { return 400.0f + 75.0f * float(i); }));
    return fields;
}

Source read(const std::string& bytes)
{
    const TempFolder folder;
    return openSource(folder.write("film.bsdf", bytes));
}

Source read(const Small& small)
{
    return read(tensorFile(fieldsOf(small)));
}

void expectRefused(const std::vector<Field>& fields, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("film.bsdf", tensorFile(fields)), part);
}

Field& named(std::vector<Field>& fields, const std::string& name)
{
    for (Field& field : fields)
        if (field.name == name) return field;
    throw std::logic_error(name);
}

const Vec3d kWo(0.0, 0.6, 0.8), kWi(0.6, 0.0, 0.8);
// kFloat: the file stores float.
constexpr double kFloat = 1e-6;

}  // namespace

TEST(Rgl, TakesTheCosineOut)
{
    const Source source = read(Small());
    EXPECT_EQ(source.format, "rgl");
    EXPECT_TRUE(source.isotropic);
    // rgb = ndf = sigma = 1: f cos(theta_o) = 1/4.
    EXPECT_NEAR(source.evaluate(kWo, kWi).y, 0.25 / 0.8, kFloat);
    EXPECT_NEAR(source.evaluate({0, 0, 1}, kWi).y, 0.25, kFloat);
    EXPECT_EQ(source.evaluate({0, 0.6, -0.8}, kWi), Vec3d(0.0));
}

TEST(Rgl, LooksUpTheHalfVectorRelativeToTheLight)
{
    Small small;  // with a constant vndf the warp is the identity: rgb is over (u, v)
    small.value = [](size_t, size_t channel, size_t x, size_t y) {
        return channel == 0 ? float(x) / (kSide - 1) : float(y) / (kSide - 1);
    };
    const Source source = read(small);
    const Vec3d h = glm::normalize(kWo + kWi);
    const double u = std::sqrt(2 * std::acos(h.z) / kPi);
    const double v = (std::atan2(h.y, h.x) + kPi) / (2 * kPi);  // phi_i = 0
    const Vec3d f = source.evaluate(kWo, kWi);
    EXPECT_NEAR(f.x, u * 0.25 / 0.8, kFloat);
    EXPECT_NEAR(f.y, v * 0.25 / 0.8, kFloat);
    // Turned about the normal by 90 degrees: nothing changes.
    const Vec3d turned = source.evaluate({-0.6, 0.0, 0.8}, {0.0, 0.6, 0.8});
    EXPECT_LT(glm::length(turned - f), kFloat);
}

TEST(Rgl, InterpolatesOverTheIncidentAngleAndClampsAtZero)
{
    Small small;
    small.value = [](size_t slice, size_t channel, size_t, size_t) {
        return channel == 2 ? -1.0f : float(slice);
    };
    const Source source = read(small);
    const Vec3d wi(std::sin(0.4), 0.0, std::cos(0.4));  // half-way between slices 0 and 1
    EXPECT_NEAR(source.evaluate({0, 0, 1}, wi).x, 0.25 * 0.5, kFloat);
    EXPECT_EQ(source.evaluate({0, 0, 1}, wi).z, 0.0);
    EXPECT_GT(reportOf(source).negative, 0u);  // the samples are as measured
}

TEST(Rgl, AnisotropicFilesDependOnTheAzimuth)
{
    Small small;
    small.phi = {float(-kPi), -1.5f, 0.0f, 1.5f, float(kPi)};
    small.value = [](size_t slice, size_t, size_t, size_t) { return float(slice / 3); };
    const Source source = read(small);
    EXPECT_FALSE(source.isotropic);
    const auto at = [&](double phi) {
        return source.evaluate({0, 0, 1}, {0.6 * std::cos(phi), 0.6 * std::sin(phi), 0.8}).x / 0.25;
    };
    EXPECT_NEAR(at(0.0), 2.0, 1e-5);
    EXPECT_NEAR(at(0.75), 2.5, 1e-5);
    EXPECT_NEAR(at(-1.5), 1.0, 1e-5);
    expectSound(source);
}

TEST(Rgl, HalfACircleIsTurnedIntoTheOther)
{
    Small small;
    small.phi = {float(-kPi), -1.5f, 0.0f};
    small.value = [](size_t slice, size_t, size_t, size_t) { return 1.0f + float(slice / 3); };
    const Source source = read(small);
    for (const double phi : {-2.5, -1.5, -0.3}) {
        const Vec3d wi(0.6 * std::cos(phi), 0.6 * std::sin(phi), 0.8), wo(0.1, 0.2, 0.97);
        const Vec3d turnedWi(-wi.x, -wi.y, wi.z), turnedWo(-wo.x, -wo.y, wo.z);
        EXPECT_LT(glm::length(source.evaluate(wo, wi) - source.evaluate(turnedWo, turnedWi)),
                  kFloat);
    }
}

TEST(Rgl, SpectraBecomeColours)
{
    Small small;
    small.spectral = true;
    const Vec3d f = read(small).evaluate(kWo, kWi);  // a flat spectrum is white
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], 0.25 / 0.8, kFloat);
}

TEST(Rgl, SamplesAreTheNodes)
{
    Small small;
    small.value = [](size_t slice, size_t channel, size_t x, size_t y) {
        return 1.0f + float(slice) + 0.1f * float(channel) + 0.2f * float(x) + 0.05f * float(y % 3);
    };
    const Source source = read(small);
    EXPECT_EQ(source.stream.rows, 3 * kSide * kSide);
    expectSound(source);
    for (const Sample& s : allSamples(source)) {
        const Vec3d f = source.evaluate(Vec3d(s.wo), Vec3d(s.wi));
        if (s.weight == 1.0f) {  // neither on the pole nor on the seam, where azimuths are two
            EXPECT_LT(glm::length(f - Vec3d(s.f)), 1e-3 * glm::length(f));
        }
    }
}

TEST(Rgl, RefusesFieldsThatAreNotThereOrOfTheWrongKind)
{
    std::vector<Field> fields = fieldsOf(Small());
    const auto with = [&](const std::string& name, const std::function<void(Field&)>& change) {
        std::vector<Field> changed = fields;
        change(named(changed, name));
        return changed;
    };
    expectRefused(with("ndf", [](Field& f) { f.name = "nix"; }), "no field 'ndf'");
    expectRefused(with("vndf", [](Field& f) { f.type = 5; }), "'vndf' of type 5");
    expectRefused(with("vndf", [](Field& f) { f.shape = {1, 3, 9, 1}; }), "of one node");
    expectRefused(with("rgb", [](Field& f) { f.shape = {1, 3, 6, 4, 2}; }), "shape [1, 3, 3, any");
    expectRefused(with("ndf", [](Field& f) { f.shape = {0, 3}; }), "shape [0, 3]");
    expectRefused(
        with("theta_i", [](Field& f) { f.data = floats(3, [](size_t) { return 1.0f; }); }),
        "theta_i that does not ascend");
    expectRefused(with("sigma", [](Field& f) { f.data = floats(4, [](size_t) { return NAN; }); }),
                  "not finite");
    expectRefused(with("vndf", [](Field& f) { f.data = floats(27, [](size_t) { return 0.0f; }); }),
                  "without a positive integral");
    expectRefused(with("rgb",
                       [](Field& f) {
                           f.shape = {1, uint64_t(1) << 40, 3, 4, 4};
                       }),
                  "beyond the end");
    expectRefused(with("rgb", [](Field& f) { f.shape = std::vector<uint64_t>(9, 1u << 30); }),
                  "beyond the end");
    expectRefused(with("rgb", [](Field& f) { f.type = 77; }), "type 77");
}

TEST(Rgl, RefusesOtherVersionsAndCounts)
{
    std::string bytes = tensorFile(fieldsOf(Small()));
    const TempFolder folder;
    bytes[12] = 2;
    expectInputError(folder.write("a.bsdf", bytes), "version 2.0");
    bytes[12] = 1;
    bytes[17] = '\x7f';
    expectInputError(folder.write("a.bsdf", bytes), "fields");
}

TEST(Rgl, ZeroSigmaGivesZeroAndNotInfinity)
{
    std::vector<Field> fields = fieldsOf(Small());
    named(fields, "sigma").data = floats(4, [](size_t) { return 0.0f; });
    EXPECT_EQ(read(tensorFile(fields)).evaluate(kWo, kWi), Vec3d(0.0));
}

TEST(Rgl, EveryPrefixIsRefused)
{
    const std::string bytes = tensorFile(fieldsOf(Small()));
    EXPECT_EQ(refusedPrefixes("a.bsdf", bytes, 3), (bytes.size() + 2) / 3);
    expectSurvivesDamage("a.bsdf", bytes.substr(0, 320));
    expectSurvivesDamage("a.bsdf", bytes, 11);
}

TEST(Rgl, AgreesWithTheReferenceEvaluator)
{
    FBRDF_NEEDS_DATA("rgl_iso_rgb/satin_rosaline_rgb.bsdf");
    constexpr double kReference = 1e-6;  // float tables here, double in the reference
    expectReference(openSource(dataPath("rgl_iso_rgb/cc_ibiza_sunset_rgb.bsdf")),
                    {{5.391604643e-02, 1.977079443e-02, 1.465221372e-02},
                     {1.208107292e-02, 4.723958224e-03, 2.520916084e-03},
                     {2.895923048e+00, 1.254203024e+00, 1.223354306e+00}},
                    kReference);
    const Source satin = openSource(dataPath("rgl_iso_rgb/satin_rosaline_rgb.bsdf"));
    expectReference(satin,
                    {{0.193864387, 0.227155325, 0.218210295},
                     {0.165995527, 0.216013869, 0.202711275},
                     {3.323166307, 2.125394015, 2.436405798}},
                    kReference);
    EXPECT_TRUE(satin.isotropic);
    EXPECT_EQ(satin.description.find("TeckWrap vinyl wrapping film (Rosaline"), 0u);
    expectSound(satin);
}
