#include "support/CommaLocale.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-12;  // an inverse of a well-conditioned 4 x 4 matrix

std::vector<TableEncoding> encodingsOf(const Form& form)
{
    return std::vector<TableEncoding>(form.tables.size(), TableEncoding{true, true});
}

ProgramSpec specOf(const Form& form, Technique technique, int lights, size_t pass = 0)
{
    PlanRequest request;
    request.technique = technique;
    request.lights = lights;
    Capabilities c;
    c.maxUniformVectors = 4096;
    c.framebufferObjects = c.floatTargets = true;
    return programSpec(planPasses(form, request, c).passes.at(pass), 2000);
}

std::string sourceOf(const Form& form, const ProgramSpec& spec, int glsl = 330)
{
    return fragmentSource(form, encodingsOf(form), spec, glsl);
}

TEST(ShaderSource, StartsWithTheVersion)
{
    for (const int glsl : {120, 140, 150, 330, 450}) {
        const std::string start = "#version " + std::to_string(glsl) + "\n";
        EXPECT_EQ(vertexSource(glsl).rfind(start, 0), 0u);
        EXPECT_EQ(sourceOf(formPqp(8, 0.5), specOf(formPqp(8, 0.5), Technique::single, 4), glsl)
                      .rfind(start, 0),
                  0u);
    }
}

TEST(ShaderSource, IsTheSameWhereTheDecimalSignIsAComma)
{
    const auto all = [] {
        std::string text = vertexSource(330);
        for (const Form& form : {formPqp(8, 0.5), formHdio({9, 7, 5}), formPqp(2048, 0.25)})
            for (const Technique technique : {Technique::single, Technique::batched})
                text += sourceOf(form, specOf(form, technique, 1234)) + describe(form);
        return text;
    };
    const std::string before = all();
    const test::CommaLocale comma;
    EXPECT_EQ(all(), before);
}

TEST(ShaderSource, RefusesOtherVersions)
{
    EXPECT_THROW(vertexSource(110), Error);
    EXPECT_THROW(vertexSource(310), Error);
    EXPECT_THROW(vertexSource(330, {true, false}), Error);  // gl_* are gone from there
}

TEST(ShaderSource, TakesBuiltInInputs)
{
    const std::string plain = vertexSource(120), builtIn = vertexSource(120, {true, false});
    EXPECT_EQ(plain.find("gl_ModelViewMatrix"), std::string::npos);
    EXPECT_NE(plain.find("uniform mat4 fbrdfModelView;"), std::string::npos);
    EXPECT_NE(builtIn.find("gl_ModelViewMatrix"), std::string::npos);
    EXPECT_EQ(builtIn.find("uniform mat4"), std::string::npos);
    EXPECT_NE(vertexSource(120, {true, true}).find("#define FBRDF_DERIVED_TANGENT\n"),
              std::string::npos);
}

// OpenSceneGraph puts declarations of its own after the last line of that kind.
TEST(ShaderSource, AsksForExtensionsOnlyWhereTheyAreNeeded)
{
    const std::string line = "#extension GL_OES_standard_derivatives";
    EXPECT_EQ(vertexSource(120, {true, true}).find("#extension"), std::string::npos);
    EXPECT_EQ(vertexSource(100, {false, false}).find("#extension"), std::string::npos);
    EXPECT_NE(vertexSource(100, {false, true}).find(line), std::string::npos);
}

TEST(ShaderSource, IsTheSameForPassesThatDifferInTheirLights)
{
    const Form form = formPqp(8, 0.5);
    const auto first = specOf(form, Technique::twoLookup, 9, 0),
               fifth = specOf(form, Technique::twoLookup, 9, 4);
    EXPECT_EQ(sourceOf(form, first), sourceOf(form, fifth));
    EXPECT_EQ(sourceOf(form, specOf(form, Technique::single, 9)),
              sourceOf(form, specOf(form, Technique::single, 60)));
}

TEST(ShaderSource, LightSlotsGrowInSteps)
{
    Pass pass;
    pass.parts = {{0, {0}, true}};
    const auto slots = [&pass](int lights, int most) {
        pass.lightCount = lights;
        return programSpec(pass, most).lightSlots;
    };
    EXPECT_EQ(slots(1, 2000), 1);
    EXPECT_EQ(slots(2, 2000), 8);
    EXPECT_EQ(slots(9, 2000), 64);
    EXPECT_EQ(slots(256, 2000), 512);
    EXPECT_EQ(slots(256, 300), 300);
    EXPECT_EQ(slots(2000, 2000), 2000);
}

TEST(ShaderSource, NeedsNoTangentFrameForAnIsotropicForm)
{
    const Form hdio = formHdio({8, 8, 8}), pqp = formPqp(8, 0.5);
    const auto mainOf = [](const std::string& text) { return text.substr(text.find("void main")); };
    EXPECT_EQ(mainOf(sourceOf(hdio, specOf(hdio, Technique::single, 4))).find("Tangent"),
              std::string::npos);
    EXPECT_NE(mainOf(sourceOf(pqp, specOf(pqp, Technique::single, 4))).find("Tangent"),
              std::string::npos);
}

TEST(ShaderSource, ComputesAnAxisOverTheViewOnce)
{
    const Form form = formHdio({16, 8, 8});
    const std::string text = sourceOf(form, specOf(form, Technique::single, 9));
    const size_t loop = text.find("for (int i");
    ASSERT_NE(loop, std::string::npos);
    EXPECT_LT(text.find("float theta_o1_1 = fbrdfAxisCoordinate("), loop);
    EXPECT_EQ(text.find("theta_o.x", loop), std::string::npos);
}

TEST(ShaderSource, TakesOneExponentialATermHoweverManyFactors)
{
    const Form form = formPqpr(8, 0.5, 16);
    const std::string text = sourceOf(form, specOf(form, Technique::single, 4));
    size_t count = 0;
    for (size_t at = text.find("exp2("); at != std::string::npos; at = text.find("exp2(", at + 1))
        ++count;
    EXPECT_EQ(count, 1u);
}

// Alpha of a resolved texel is the share of its samples that something was drawn to.
TEST(ShaderSource, DividesByTheShareOfSamplesOnlyWhereTexelsAreResolved)
{
    const Form form = formPqp(8, 0.5);
    PlanRequest request;
    request.technique = Technique::twoLookup;
    request.lights = 3;
    request.target = ColourFormat::rgba8;
    Capabilities c;
    c.maxUniformVectors = 4096;
    c.framebufferObjects = c.floatTargets = true;
    const Plan plan = planPasses(form, request, c);
    int reading = 0;
    for (const Pass& pass : plan.passes)
        for (const int glsl : kGlslVersions) {
            ProgramSpec spec = programSpec(pass, 2000);
            const std::string plain = sourceOf(form, spec, glsl);
            spec.resolved = true;
            const std::string resolved = sourceOf(form, spec, glsl);
            EXPECT_EQ(plain.find("read.a"), std::string::npos);
            EXPECT_EQ(resolved.find("total *= read.rgb / max(read.a, 0.001);") != std::string::npos,
                      spec.reads);
            EXPECT_EQ(resolved == plain, !spec.reads);
            EXPECT_EQ(countLookups(resolved, {"fbrdfRead"}).once, spec.reads ? 1 : 0);
            reading += spec.reads ? 1 : 0;
        }
    EXPECT_GT(reading, 0);
}

// Division need not be exact, so a quotient of whole numbers may be floored to the one before.
TEST(ShaderSource, TakesNoRemainders)
{
    for (const char* file : {"area.glsl", "clusters.glsl", "lobes.glsl", "prefilter_source.frag",
                             "samples.glsl", "sampling.glsl"}) {
        const std::string text(shaderSnippet(file));
        ASSERT_FALSE(text.empty()) << file;
        for (const char* name : {" mod(", "(mod(", "modf("})
            EXPECT_EQ(text.find(name), std::string::npos) << file;
    }
}

// That of a surface says what was drawn to, so no tint may change it.
TEST(ShaderSource, AlphaOfATintIsThatOfTargetsAlone)
{
    const Form form = formPqp(8, 0.5);
    SurfaceInputs inputs;
    inputs.tintHook = "vec4 fbrdfTint()\n{\n    return vec4(0.5);\n}\n";
    inputs.tintedTerms = {0};
    ProgramSpec spec = specOf(form, Technique::single, 4);
    EXPECT_FALSE(spec.toSurface);
    const std::vector<TableEncoding> encodings(form.tables.size());
    const std::string alpha = "vec4(total, fbrdfTinted.a)";
    EXPECT_NE(fragmentSource(form, encodings, spec, 330, inputs).find(alpha), std::string::npos);
    spec.toSurface = true;
    EXPECT_EQ(fragmentSource(form, encodings, spec, 330, inputs).find(alpha), std::string::npos);
}

TEST(ShaderSource, RefusesWhatDoesNotAgree)
{
    const Form form = formPqp(8, 0.5);
    ProgramSpec spec = specOf(form, Technique::single, 4);
    EXPECT_THROW(fragmentSource(form, {}, spec, 330), Error);
    spec.lightSlots = 0;
    EXPECT_THROW(sourceOf(form, spec), Error);
}

TEST(ShaderSource, RefusesToSampleWithoutLobesAndInEs100)
{
    const LobeLayout table{LobeAxes::tilted, 2, 24};
    EXPECT_THROW(samplingFunctions({}, 330), Error);
    EXPECT_THROW(samplingFunctions(table, 100), Error);
    EXPECT_THROW(samplingFunctions(table, 110), Error);
    EXPECT_NE(samplingFunctions(table, 120).find("uniform vec4 fbrdfLobes[96];"),
              std::string::npos);
}

TEST(CountLookups, TellsFetchesInTheLoopFromOthers)
{
    const Form form = formPqp(8, 0.5);
    const std::string text = sourceOf(form, specOf(form, Technique::single, 9));
    const LookupCount all = countLookups(text, {"fbrdfTable0", "fbrdfTable1"});
    EXPECT_EQ(all.once, 1);
    EXPECT_EQ(all.perLight, 2);
}

TEST(CountLookups, LeavesOutSamplersThatTheLinkerRemoved)
{
    const Form form = formPqp(8, 0.5);
    const std::string text = sourceOf(form, specOf(form, Technique::single, 9));
    const LookupCount some = countLookups(text, {"fbrdfTable1"});
    EXPECT_EQ(some.once, 0);
    EXPECT_EQ(some.perLight, 1);
    const LookupCount none = countLookups(text, {});
    EXPECT_EQ(none.once + none.perLight, 0);
}

TEST(CountLookups, SeesWhatIsWrittenByHand)
{
    const LookupCount count = countLookups(
        "void other() { FBRDF_TEXTURE2(a, x); }\n"
        "void main() { FBRDF_TEXTURE2(a, x); for (;;) { if (y) { FBRDF_TEXTURE3(b, x); } "
        "FBRDF_TEXTURE2(a, x); } FBRDF_TEXTURE2(a, z); }",
        {"a", "b"});
    EXPECT_EQ(count.once, 2);
    EXPECT_EQ(count.perLight, 2);
    EXPECT_EQ(countLookups("no main here", {"a"}).once, 0);
}

TEST(Eye, IsTheOriginOfAPerspective)
{
    for (const auto& p :
         {glm::perspective(0.6, 1.3, 0.1, 100.0), glm::frustum(-0.1, 0.3, -0.2, 0.1, 0.2, 50.0)}) {
        const glm::dvec4 eye = eyeFromProjection(p);
        EXPECT_NEAR(glm::length(eye - glm::dvec4(0.0, 0.0, 0.0, 1.0)), 0.0, kTight);
    }
}

TEST(Eye, IsBehindTheCameraOfAParallelProjection)
{
    const glm::dvec4 eye = eyeFromProjection(glm::ortho(-1.0, 2.0, -1.0, 1.0, 0.5, 20.0));
    EXPECT_EQ(eye.w, 0.0);
    EXPECT_NEAR(glm::length(glm::normalize(eye) - glm::dvec4(0.0, 0.0, 1.0, 0.0)), 0.0, kTight);
}

TEST(Eye, FollowsAnObliqueParallelProjection)
{
    // Rays along (0.3, 0, -1): x shifts with z.
    glm::dmat4 shear(1.0);
    shear[2][0] = 0.3;
    const glm::dvec4 eye =
        glm::normalize(eyeFromProjection(glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.5, 20.0) * shear));
    const glm::dvec4 expected = glm::normalize(glm::dvec4(-0.3, 0.0, 1.0, 0.0));
    EXPECT_NEAR(glm::length(eye - expected), 0.0, kTight);
}

}  // namespace
}  // namespace fbrdf
