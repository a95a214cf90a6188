// Ansys Speos' text formats. The surface of the real file was written for Zemax as well.
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <map>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

using Value = std::function<double(double theta, double phi)>;

/// A table of 19 zenith angles and 13 azimuths.
std::string table(const Value& value)
{
    std::string text = "19\t13\n";
    for (int p = 0; p <= 360; p += 30) text += "\t" + std::to_string(p);
    for (int t = 0; t <= 90; t += 5) {
        text += "\n" + std::to_string(t);
        for (int p = 0; p <= 360; p += 30)
            text += "\t" + numberText(value(t * kDegree, p * kDegree), 9);
    }
    return text + "\n";
}

std::string head(const std::string& title, const std::string& type, const std::string& vector = "",
                 const std::string& sides = "1\t0")
{
    return "OPTIS - " + title + " v8.0\n0\na comment\n7\nmade\n12\n" + vector + sides + "\n" +
           type + "\n";
}

std::string brdf(const std::string& tables, const std::string& type = "1",
                 const std::string& wavelengths = "1\n", const std::string& list = "550\n")
{
    return head("brdf surface file", type) + "1\t" + wavelengths + "30\n" + list + tables;
}

Source read(const std::string& text, const std::string& name = "a.brdf")
{
    const TempFolder folder;
    return openSource(folder.write(name, text));
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("a.brdf", text), part);
}

double constant(double, double)
{
    return 0.25;
}

double cosine(double theta, double)
{
    return 7.0 * std::cos(theta);
}

/// A lobe towards azimuth 0.
double lobe(double theta, double phi)
{
    return 1.0 + std::sin(theta) * std::cos(phi);
}

void expectLambertian(const Source& source, const Vec3d& albedo)
{
    expectSound(source);
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_GT(samples.size(), 200u);
    for (const Sample& s : samples)  // the rule of the integral has steps of 5 degrees
        EXPECT_LT(glm::length(Vec3d(s.f) - albedo / kPi), 0.004 * glm::length(albedo));
}

}  // namespace

TEST(Speos, TheTotalSetsTheScaleOfEitherTypeOfValues)
{
    for (const auto& [type, value] :
         {std::pair<std::string, Value>{"1", constant}, {"0", cosine}}) {
        const Source source = read(brdf("40\n" + table(value), type));
        EXPECT_EQ(source.format, "speos");
        EXPECT_TRUE(source.isotropic);
        expectLambertian(source, Vec3d(0.4));
    }
}

TEST(Speos, AzimuthZeroIsTheMirrorAndPolesWeighOnce)
{
    const Source source = read(brdf("40\n" + table(lobe)));
    const std::vector<Sample> samples = allSamples(source);
    const Sample* most = samples.data();
    double pole = 0.0;
    for (const Sample& s : samples) {
        if (s.f.x > most->f.x) most = &s;
        if (s.wo.z > 0.9999f) pole += double(s.weight);
    }
    EXPECT_NEAR(most->wi.x, -0.5f, 1e-6);
    EXPECT_GT(most->wo.x, 0.99f);
    EXPECT_NEAR(pole, 1.0, 1e-5);
    EXPECT_NEAR(most->weight, 0.5f, 1e-6);  // azimuth 360 is the same direction
}

TEST(Speos, WavelengthsBecomeAColourOrAChoice)
{
    const std::string text =
        brdf("20\n" + table(constant) + "40\n" + table(constant) + "60\n" + table(constant), "1",
             "3\n", "450 550 650\n");
    const Vec3f rgb = allSamples(read(text)).at(20).f;
    EXPECT_GT(rgb.x, rgb.y);
    EXPECT_GT(rgb.y, rgb.z);
    const TempFolder folder;
    expectLambertian(openSource(folder.write("a.brdf", text) + "@650"), Vec3d(0.6));
}

TEST(Speos, AnisotropyTurnsTheSampleAndTheSpectrumHasAReference)
{
    // Incidence 20 reflects twice as much as 10, where the spectrum was measured.
    const auto twice = [](double theta, double phi) { return 2.0 * lobe(theta, phi); };
    const std::string text =
        head("Anisotropic BSDF surface file", "1", "0\t1\t0\n") +
        "2\n0.0\t90.0\n2\n10\t20\n2\n10\t20\n10\t0\nspectrum\n2\n350\t30\n850\t30\n" + table(lobe) +
        table(twice) + table(lobe) + table(twice);
    const Source source = read(text, "a.anisotropicbsdf");
    EXPECT_EQ(source.format, "speos");
    EXPECT_FALSE(source.description.empty());
    expectSound(source);
    const std::vector<Sample> samples = allSamples(source);
    const size_t rows = samples.size() / 4;
    for (size_t i = 0; i < rows; ++i) {
        EXPECT_NEAR(samples[rows + i].f.x, 2.0f * samples[i].f.x, 1e-5f);
        EXPECT_NEAR(samples[2 * rows + i].f.x, samples[i].f.x, 1e-6f);
        // Turned by 90 degrees about the normal: (x, y) becomes (-y, x).
        EXPECT_NEAR(samples[2 * rows + i].wo.x, -samples[i].wo.y, 1e-6f);
        EXPECT_NEAR(samples[2 * rows + i].wi.y, samples[i].wi.x, 1e-6f);
    }
    double albedo = 0.0;  // of incidence 10
    for (size_t t = 0; t < 18; ++t)
        for (size_t p = 0; p < 12; ++p) {
            const Sample& s = samples[t * 13 + p];
            albedo += double(s.f.x) * double(s.wo.z) *
                      std::sqrt(1.0 - double(s.wo.z) * double(s.wo.z)) * 5 * kDegree * 30 * kDegree;
        }
    EXPECT_NEAR(albedo, 0.3, 0.003);
}

TEST(Speos, RefusesWhatDoesNotAddUp)
{
    const std::string good = brdf("40\n" + table(constant));
    const auto replaced = [&](const std::string& part, const std::string& by) {
        return std::string(good).replace(good.find(part), part.size(), by);
    };
    expectRefused(replaced("v8.0\n0\n", "v8.0\n1\n"), "binary");
    expectRefused(replaced("1\t0\n", "0\t1\n"), "found transmission alone");
    expectRefused(replaced("19\t13", "19\t99999"), "expected as many of azimuths");
    expectRefused(replaced("19\t13", "19\t1"), "a count of azimuths");
    expectRefused(replaced("\t60\t", "\t20\t"), "expected ascending ones");
    expectRefused(replaced("1\t1\n30", "1\t99999\n30"), "a count of wavelengths");
    expectRefused(replaced("550", "5e9"), "wavelengths from");
    expectRefused(brdf("0\n" + table([](double, double) { return NAN; })), "no usable sample");
    EXPECT_GT(refusedPrefixes("a.brdf", good, 7), good.size() / 8);
    expectSurvivesDamage("a.brdf", good, 13);
}

TEST(Speos, TheRealFileAgreesWithItsTwinUpToAScale)
{
    const char* const speos = "speos/test_13_planesymmetric_brdf_speos_reference.anisotropicbsdf";
    FBRDF_NEEDS_DATA(speos);
    std::map<int, std::pair<double, double>> ratios;  // by incidence in degrees: least and most
    const std::vector<Sample> table = allSamples(openSource(dataPath(speos)));
    for (const Sample& z :
         allSamples(openSource(dataPath("speos/test_13_planesymmetric_brdf_zemax.bsdf"))))
        for (const Sample& s : table) {
            if (glm::length(z.wo - s.wo) + glm::length(z.wi - s.wi) > 1e-4f || z.wo.z < 0.3f ||
                s.f.x == 0.0f)  // the converter's zeros, from 80 degrees off the mirror on
                continue;
            const double ratio = double(s.f.x) / double(z.f.x);
            const int incidence = int(std::lround(std::acos(double(z.wi.z)) / kDegree));
            auto& [least, most] = ratios.try_emplace(incidence, ratio, ratio).first->second;
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
    EXPECT_EQ(ratios.size(), 13u);
    for (const auto& [incidence, range] : ratios) {
        EXPECT_LT(range.second / range.first, 1.01) << incidence;  // three digits of Zemax' values
        EXPECT_GT(range.first, 0.95) << incidence;
        EXPECT_LT(range.second, 1.25) << incidence;
    }
}

TEST(Speos, TheRealSpectralFileHasItsTotals)
{
    const char* const file = "speos/test_13_brdf_one_wavelength_speos.brdf";
    FBRDF_NEEDS_DATA(file);
    const Source source = openSource(dataPath(file));
    EXPECT_EQ(source.stream.rows, 4u * 91 * 361);
    expectSound(source);
    std::map<int, double> totals;
    for (const Sample& s : allSamples(source)) {
        const double area =
            std::sqrt(std::max(0.0, 1.0 - double(s.wo.z) * double(s.wo.z))) * kDegree * kDegree;
        const double share = s.wo.z > 0.99999f ? 0.0 : double(s.weight);
        totals[int(std::lround(std::acos(double(s.wi.z)) / kDegree * 10))] +=
            double(s.f.x) * double(s.wo.z) * area * share;
    }
    EXPECT_NEAR(totals[0], 0.023, 1e-4);
    EXPECT_NEAR(totals[225], 0.01932, 1e-4);
    EXPECT_NEAR(totals[450], 0.1366, 1e-4);
    EXPECT_NEAR(totals[675], 0.1828, 1e-4);
}
