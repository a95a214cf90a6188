// GLSL grants its functions errors that llvmpipe does not make, and leaves some results open: such
// drivers are played by changing the text of shaders, and pictures stay within their bounds.
#include <fbrdf/shaders/ShaderSource.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"
#include "support/gl/ShaderRewriter.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

/// Functions of one argument, each off by `ulps` (an expression of x) units in the last place of y.
std::string offBy(const std::string& function, const std::string& ulps, int sign)
{
    std::string text;
    for (const std::string type : {"float", "vec2", "vec3"})
        text += type + " fbrdfGranted_" + function + "(" + type + " x)\n{\n    " + type +
                " y = " + function + "(x);\n    return y + " + std::to_string(sign) + ".0 * (" +
                ulps + ") * exp2(floor(log2(abs(y))) - 23.0);\n}\n";
    return text;
}

/// Puts the functions of `definitions`, fbrdfGranted_x, in the place of those of GLSL.
ShaderRewriter replacing(const std::string& definitions)
{
    return [definitions](const std::string& text) {
        const std::string end = "#define FBRDF_TEXTURE_PRECISE fbrdfFiltered\n";
        const size_t at = text.find(end);
        if (at == std::string::npos) return text;
        std::string rest = text.substr(at + end.size());
        const std::regex defined("fbrdfGranted_(\\w+)\\(");
        for (std::sregex_iterator i(definitions.begin(), definitions.end(), defined), none;
             i != none; ++i)
            rest =
                std::regex_replace(rest, std::regex("\\b" + (*i)[1].str() + "\\("), (*i)[0].str());
        return text.substr(0, at + end.size()) + definitions + rest;
    };
}

/// Exponents far from 0 that the scale brings back, where exp2 may be off by most.
Material withFarExponents(const Form& form)
{
    Material material = noiseMaterial(form, Storage::float32);
    constexpr float kShift = 110.0f;  // floats end at 2^-126 and 2^128
    const auto factors = static_cast<float>(form.terms[0].factors.size());
    for (Table& table : material.tables)
        for (float& texel : table.texels) texel -= kShift / factors;
    material.scales[0] *= std::exp2(kShift);
    return material;
}

class GrantedErrors : public GlTest {
protected:
    struct Share {
        double ofBound = 0.0, ofNearExact = 0.0;  ///< the latter: without what exp2 is granted
    };
    Share worst(const std::string& definitions)
    {
        const gl::MeshData sphere = sphereMesh(16);
        Offscreen floats = makeOffscreen(kSize);
        const GeometryBuffer geometry =
            geometryBuffer(gl(), floats, sphere, glm::mat4(1.0f), perspectiveView());
        gl::RendererOptions options = rendererOptions();
        options.load = rewritingShaders(context().options().backend, replacing(definitions));
        gl::Renderer renderer(options);
        const auto mesh = renderer.createMesh(sphere);
        Share share;
        for (const Form& form : {formHdio({16, 8, 8}), formPqp(16, 0.5), formPqpr(16, 0.5, 6)})
            for (const Technique technique : {Technique::single, Technique::twoLookup}) {
                const Material material = withFarExponents(form);
                const auto gpu = renderer.createMaterial(material);
                Offscreen offscreen = makeOffscreen(kSize);
                const auto lights = testLights(3);
                const auto stats =
                    renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                  {{gpu.get(), mesh.get()}}, lights, {technique});
                const auto exact = referenceImage(material, geometry, lights, perspectiveView());
                const auto pixels = offscreen.readPixels();
                share.ofBound =
                    std::max(share.ofBound, deviationOf(pixels, exact, stats.error).share);
                ErrorBound less = stats.error;
                const int values = technique == Technique::single ? 1 : 2;  // each with an exp2
                less.relative -= values * (3.0 + 2.0 * stats.error.maps.exponent) * 0x1p-23;
                share.ofNearExact =
                    std::max(share.ofNearExact, deviationOf(pixels, exact, less).share);
            }
        return share;
    }
};

// GLSL 4.60, 4.7.1: 2 for inversesqrt, and sqrt is granted that of 1 / inversesqrt, 2 + 2.5.
std::string offRoots(int sign)
{
    return offBy("inversesqrt", "2.0", sign) + offBy("sqrt", "4.5", sign);
}

TEST_P(GrantedErrors, OfRootsAreInTheBound)
{
    for (const int sign : {-1, 1}) EXPECT_LE(worst(offRoots(sign)).ofBound, 1.0) << sign;
}

// 3 + 2 |x| for exp2.
TEST_P(GrantedErrors, OfExponentialsAreInTheBoundToo)
{
    double withoutExponentials = 0.0;
    for (const int roots : {-1, 1})
        for (const int sign : {-1, 1}) {
            const Share share = worst(offRoots(roots) + offBy("exp2", "3.0 + 2.0 * abs(x)", sign));
            EXPECT_LE(share.ofBound, 1.0) << roots << " " << sign;
            withoutExponentials = std::max(withoutExponentials, share.ofNearExact);
        }
    EXPECT_GT(withoutExponentials, 1.0) << "the tester";
}

// GLSL 4.60, 8.1: atan(0, 0) may be anything. Normal incidence has an azimuth all the same.
TEST_P(GrantedErrors, AzimuthsAtNormalIncidenceAreNumbers)
{
    Offscreen offscreen = makeOffscreen(1);
    const auto drawn = [&](const std::string& expression) {
        const GLuint program = linkProgram(
            gl(),
            "#version 140\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
            "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
            "#version 140\nuniform float zero;\nfloat openAtan(float y, float x)\n{\n    return y "
            "== 0.0 && x == 0.0 ? sqrt(-1.0 - zero) : atan(y, x);\n}\n#define atan openAtan\n" +
                std::string(shaderSnippet("lobes.glsl")) +
                "out vec4 result;\nvoid main() { result = vec4(" + expression + "); }\n");
        GLuint array = 0;
        gl().GenVertexArrays(1, &array);
        gl().BindVertexArray(array);
        gl().BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
        gl().Viewport(0, 0, 1, 1);
        gl().UseProgram(program);
        gl().DrawArrays(GL_TRIANGLES, 0, 3);
        gl().UseProgram(0);
        gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl().BindVertexArray(0);
        gl().DeleteVertexArrays(1, &array);
        gl().DeleteProgram(program);
        return offscreen.readPixels()[0];
    };
    EXPECT_TRUE(std::isnan(drawn("atan(zero, zero)"))) << "the tester";
    EXPECT_EQ(drawn("fbrdfAzimuthPosition(vec2(zero), 3.0)"), 0.0f);
    EXPECT_NEAR(drawn("fbrdfAzimuthPosition(vec2(zero, 0.5), 3.0)"), 3.0f, 1e-5f);
    EXPECT_NEAR(drawn("fbrdfAzimuthPosition(vec2(0.5, 0.5), 3.0)"), 1.5f, 1e-5f);
}

INSTANTIATE_TEST_SUITE_P(Backends, GrantedErrors, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
