// GLSL leaves open whether derivatives are those of the pixel (fine) or the same for 2 x 2 pixels
// (coarse). Drivers with coarse ones are played by changing the text of shaders. A triangle is flat
// and its texture coordinates are linear, so that derived tangents are the same with either.
#include "GeometryTest.h"
#include "support/gl/ShaderRewriter.h"

#include <string>
#include <utility>

namespace fbrdf::test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// Those of the first row and column of 2 x 2 pixels, whatever the driver has.
std::string coarse(std::string text)
{
    const std::string end = "#define FBRDF_TEXTURE_PRECISE fbrdfFiltered\n";
    const size_t at = text.find(end);
    if (at == std::string::npos || text.find("dFdx(") == std::string::npos) return text;
    std::string functions;
    for (const std::string type : {"float", "vec2", "vec3"})
        functions += type + " fbrdfCoarseX(" + type +
                     " v)\n{\n    return dFdx(v) - mod(floor(gl_FragCoord.y), 2.0) * "
                     "dFdy(dFdx(v));\n}\n" +
                     type + " fbrdfCoarseY(" + type +
                     " v)\n{\n    return dFdy(v) - mod(floor(gl_FragCoord.x), 2.0) * "
                     "dFdx(dFdy(v));\n}\n";
    const std::string rest = replaced(
        replaced(text.substr(at + end.size()), "dFdx(", "fbrdfCoarseX("), "dFdy(", "fbrdfCoarseY(");
    return text.substr(0, at + end.size()) + functions + rest;
}

/// Those of the driver.
std::string asItIs(std::string text)
{
    return text;
}

class Derivatives : public Geometry {
protected:
    /// As the renderer of a driver would that has such shaders.
    std::vector<float> drawnBy(const ShaderRewriter& rewrite, const Object& object,
                               const gl::View& view = perspectiveView())
    {
        gl::RendererOptions options = rendererOptions();
        options.load = rewritingShaders(context().options().backend, rewrite);
        gl::Renderer renderer(options);
        const auto gpu = exactMaterial(renderer, brushed());
        const auto mesh = renderer.createMesh(object.mesh);
        return drawItems(renderer, kSize, view,
                         {{gpu.get(), mesh.get(), object.model, object.hooks, object.normalMap}},
                         testLights(6), {})
            .pixels;
    }
};

gl::MeshData withoutTangents(gl::MeshData mesh)
{
    mesh.tangents.clear();
    mesh.handedness.clear();
    return mesh;
}

/// A plane that is seen aslant, which covers some of the picture, and a ball of few triangles.
std::vector<gl::MeshData> slantedMeshes()
{
    const glm::mat4 tilt = glm::rotate(glm::mat4(1.0f), 0.9f, Vec3f(1.0f, 0.5f, 0.0f));
    gl::MeshData ball = withoutTangents(sphereMesh(12));
    ball.textureCoordinates.clear();
    for (const Vec3f& p : ball.positions)
        ball.textureCoordinates.emplace_back(p.x + 0.3f * p.z, p.y - 0.2f * p.z);
    return {withoutTangents(transformed(planeMesh(0.5f, 1.0f), tilt)), ball};
}

TEST_P(Derivatives, OfEitherKindGiveTheSameTangents)
{
    for (const gl::MeshData& mesh : slantedMeshes()) {
        expectSame(drawnBy(coarse, {mesh}), drawnBy(asItIs, {mesh}), kDerived);
    }
}

TEST_P(Derivatives, OfEitherKindGiveTheSameNormalsOfAMap)
{
    Object plane{slantedMeshes()[0]};
    plane.normalMap = normalMap(bumps());
    expectSame(drawnBy(coarse, plane), drawnBy(asItIs, plane), kDerived);
}

// The testers: tangents that are across are seen, and so is in which row of 2 x 2 pixels one is.
TEST_P(Derivatives, ThatAreWrongAreNoticed)
{
    const gl::MeshData plane = slantedMeshes()[0];
    expectOther(drawnBy(
                    [](std::string text) {
                        return replaced(replaced(std::move(text), "dx = dFdx(", "dx = -dFdy("),
                                        "dy = dFdy(", "dy = dFdx(");
                    },
                    {plane}),
                drawnBy(asItIs, {plane}));
    const auto across = [&](std::string (*kind)(std::string)) {
        const auto derivative =
            afterMain("    fbrdfColour = vec4(dFdx(gl_FragCoord.x * gl_FragCoord.y));\n");
        const auto pixels =
            drawnBy([&](std::string text) { return kind(derivative(std::move(text))); },
                    {planeMesh(0.0f, 1.0f)}, mapView());
        const auto at = [&](int row) {
            return pixels[static_cast<size_t>(4 * (row * kSize + kSize / 2))];
        };
        return at(21) - at(20);
    };
    EXPECT_EQ(across(coarse), 0.0f);
    if (across(asItIs) == 0.0f) GTEST_SKIP() << "the driver's derivatives are coarse themselves";
    EXPECT_EQ(across(asItIs), 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Backends, Derivatives, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
