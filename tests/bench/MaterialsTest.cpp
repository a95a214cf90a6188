// The materials that the benchmark draws: every form of the fitter has one, near GGX where the form
// can follow it.
#include "bench/Materials.h"

#include "bench/Accuracy.h"
#include "bench/LightCost.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/fit/Fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::bench {
namespace {

bool isKnown(const std::string& form)
{
    const auto forms = allForms();
    return std::count(forms.begin(), forms.end(), form) == 1;
}

TEST(BenchMaterials, AreThereInEveryForm)
{
    for (const NamedForm& named : namedForms()) EXPECT_TRUE(isKnown(named.name)) << named.name;
    for (const char* form :
         {"io+hdio", "u+hdpu", "svd4", "analytic:ward", "analytic:ashikhmin-shirley"})
        EXPECT_TRUE(isKnown(form)) << form;
    const auto accuracy = accuracyForms();
    for (const std::string& form : allForms())
        EXPECT_EQ(std::count(accuracy.begin(), accuracy.end(), form), 1) << form;
    for (const NamedForm& direct : directForms()) {
        const auto forms = allForms();
        EXPECT_TRUE(std::any_of(forms.begin(), forms.end(), [&](const std::string& form) {
            return form.compare(0, direct.name.size(), direct.name) == 0;
        })) << direct.name;
    }
    for (const std::string& form : allForms()) {
        const Material material = benchMaterial(form);
        EXPECT_EQ(material.name, form);
        EXPECT_EQ(material.tables.size(), material.form.tables.size()) << form;
    }
}

TEST(BenchMaterials, OfOtherNamesAreRefused)
{
    for (const char* form : {"hidio", "svd", "svd0", "svd33", "svd4x", "svd444",
                             "analytic:", "analytic:ggx", "io+", ""})
        EXPECT_THROW(benchMaterial(form), Error) << form;
}

/// GGX of Materials.h where light and view lie at `theta` on both sides of the normal.
Vec3d ggxInMirrorDirection(double theta)
{
    const double c = std::cos(theta), s = std::sin(theta);
    const Vec3d fresnel = kF0 + (Vec3d(1.0) - kF0) * std::pow(1.0 - c, 5.0);
    // D(0) = 1 / (pi alpha^2), V = 1 / (4 cos |o|)
    return fresnel / (kPi * kAlpha * kAlpha) / (4.0 * c * std::hypot(kAlpha * s, c));
}

TEST(BenchMaterials, AreGgxInMirrorDirections)
{
    constexpr double kTables = 0.04;  // 8 bits over the range of a logarithm, and linear filtering
    for (const char* form :
         {"pqpr", "pqtr", "pqpd", "hdio", "hdg", "hdpio", "hdpu", "hdsu", "hdau", "qdio", "qdg"})
        for (const double theta : {0.2, 0.6, 1.0}) {
            const Vec3d wo(std::sin(theta), 0.0, std::cos(theta)), wi(-wo.x, 0.0, wo.z),
                found = evaluate<double>(benchMaterial(form), wo, wi),
                exact = ggxInMirrorDirection(theta);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c], exact[c], kTables * exact[c]) << form << " at " << theta;
        }
}

TEST(BenchMaterials, OfSumsHaveALambertianTerm)
{
    constexpr double kTables = 0.02;
    const Vec3d wo(0.6, 0.0, 0.8), wi(0.0, 0.28, 0.96);
    for (const char* form : {"io+hdio", "gg+hdio", "u+hdio"}) {
        const Vec3d lambertian = evaluate<double>(benchMaterial(form), wo, wi) -
                                 evaluate<double>(benchMaterial("hdio"), wo, wi);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(lambertian[c], kDiffuse[c] / kPi, kTables * kDiffuse[c] / kPi) << form;
    }
}

TEST(BenchMaterials, OfSingularValuesComeNearerWithTerms)
{
    const Material exact = benchMaterial("hdio");
    double last = 1e9;
    for (const char* form : {"svd1", "svd2", "svd4", "svd8"}) {
        const Material material = benchMaterial(form);
        EXPECT_TRUE(hasSigns(material));
        double error = 0.0;
        for (int i = 0; i < 200; ++i) {
            const double theta = 0.3 + 0.005 * (i % 17), phi = 0.0314 * i;
            const Vec3d wo(std::sin(0.5), 0.0, std::cos(0.5)),
                wi(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                   std::cos(theta));
            error +=
                glm::distance(evaluate<double>(material, wo, wi), evaluate<double>(exact, wo, wi));
        }
        EXPECT_LT(error, last) << form;
        last = error;
    }
}

/// Bytes that the look-ups of a form read for one light: four half texels of a plane, eight of a
/// volume.
double bytesByTheForm(const Form& form)
{
    double bytes = 0.0;
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors) {
            const TableSpec& table = form.tables[static_cast<size_t>(factor.table)];
            if (table.uniform || !dependsOnLight(factor)) continue;
            bytes += 3.0 * 2.0 * (dimensionCount(table.domain) == 3 ? 8.0 : 4.0);
        }
    return bytes;
}

Capabilities usual()
{
    Capabilities capabilities;
    capabilities.glsl = 330;
    capabilities.maxTextureUnits = 32;
    capabilities.maxUniformVectors = 1024;
    capabilities.framebufferObjects = capabilities.floatTextures = capabilities.floatTargets = true;
    return capabilities;
}

TEST(LightCost, OfEveryFormIsThatOfItsTables)
{
    for (const std::string& form : allForms()) {
        const Material material = benchMaterial(form);
        const auto cost = [&](int lights) {
            PlanRequest request;
            request.lights = lights;
            return runtimeCost(uploadedMaterial(material, {}, usual()), request, usual());
        };
        const LightCost three = cost(3), two = cost(2);
        EXPECT_NEAR(3.0 * three.bytes - 2.0 * two.bytes, bytesByTheForm(material.form), 1e-9)
            << form;
        EXPECT_GT(3.0 * three.multiplyAdds - 2.0 * two.multiplyAdds, 20.0) << form;
        EXPECT_GT(3.0 * three.specials - 2.0 * two.specials, 1.0) << form;
    }
}

TEST(LightCost, OfAVolumeIsTwiceThatOfAPlane)
{
    const auto bytes = [&](const char* form, bool precise) {
        PlanRequest request;
        request.lights = 1;
        gl::MaterialOptions options;
        options.precise = precise;
        return runtimeCost(uploadedMaterial(benchMaterial(form), options, usual()), request,
                           usual())
            .bytes;
    };
    EXPECT_EQ(bytes("hdio", false), 2 * 4 * 6.0);
    EXPECT_EQ(bytes("hdpio", false), (8 + 4) * 6.0);
    EXPECT_EQ(bytes("hdpu", false), (8 + 4) * 6.0);
    // The shader fetches the same texels one by one.
    EXPECT_EQ(bytes("hdpio", true), bytes("hdpio", false));
}

TEST(LightCost, IsKnownInEveryTechnique)
{
    for (const std::string& form : allForms())
        for (const Technique technique : allTechniques()) {
            PlanRequest request;
            request.lights = 5;
            request.technique = technique;
            const Material material = benchMaterial(form);
            const LightCost cost =
                runtimeCost(uploadedMaterial(material, {}, usual()), request, usual());
            EXPECT_GT(cost.multiplyAdds, 20.0) << form << " " << techniqueName(technique);
            EXPECT_GE(cost.bytes, bytesByTheForm(material.form) - 1e-9)
                << form << " " << techniqueName(technique);
        }
}

}  // namespace
}  // namespace fbrdf::bench
