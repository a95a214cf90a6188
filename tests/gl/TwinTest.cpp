#include "TwinTest.h"

#include "EmbeddedShaders.h"

#include <fbrdf/brdf/HalfDifference.h>

namespace fbrdf::test {
namespace {

std::string twinFragment(const std::string& statements)
{
    std::string text = "#version 140\n";
    for (const char* file :
         {"version.glsl", "frame.glsl", "angles.glsl", "projection.glsl", "lights.glsl",
          "cluster_geometry.glsl", "lobe_frame.glsl", "area.glsl", "transfer.glsl"})
        text += embeddedShader(file);
    // The output of these programs has another name.
    text += "#undef FBRDF_COLOUR_OUTPUT\n#define FBRDF_COLOUR_OUTPUT\n" +
            std::string(embeddedShader("prefilter.glsl"));
    return text +
           "uniform sampler2D inputs;\nout vec4 result;\nvoid main()\n{\n"
           "    vec4 a = texelFetch(inputs, ivec2(int(gl_FragCoord.x), 0), 0);\n"
           "    vec4 b = texelFetch(inputs, ivec2(int(gl_FragCoord.x), 1), 0);\n" +
           statements + "\n}\n";
}

}  // namespace

std::vector<Vec4> Twin::run(const std::string& statements, const std::vector<Inputs>& inputs)
{
    const auto& g = gl();
    const auto count = static_cast<GLsizei>(inputs.size());
    std::vector<Vec4> rows;
    for (const Inputs& i : inputs) rows.push_back(i.a);
    for (const Inputs& i : inputs) rows.push_back(i.b);
    GLuint texture = 0, array = 0;
    g.GenTextures(1, &texture);
    g.BindTexture(GL_TEXTURE_2D, texture);
    g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    g.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 2, 0, GL_RGBA, GL_FLOAT, rows.data());
    g.GenVertexArrays(1, &array);
    g.BindVertexArray(array);
    Offscreen offscreen(context().loader(), {count, 1, OffscreenFormat::rgba32f, false});
    g.BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
    g.Viewport(0, 0, count, 1);
    const GLuint program =
        linkProgram(g,
                    "#version 140\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
                    "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
                    twinFragment(statements));
    g.UseProgram(program);
    g.DrawArrays(GL_TRIANGLES, 0, 3);
    const auto pixels = offscreen.readPixels();
    g.UseProgram(0);
    g.DeleteProgram(program);
    g.DeleteTextures(1, &texture);
    g.BindVertexArray(0);
    g.DeleteVertexArrays(1, &array);
    g.BindFramebuffer(GL_FRAMEBUFFER, 0);
    std::vector<Vec4> results;
    for (size_t i = 0; i < inputs.size(); ++i)
        results.emplace_back(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2],
                             pixels[4 * i + 3]);
    return results;
}

std::vector<Inputs> pairs()
{
    std::vector<Inputs> result;
    for (const double theta_h : {0.0, 1e-4, 0.05, 0.4, 0.9, 1.4})
        for (const double theta_d : {0.0, 1e-3, 0.2, 0.8, 1.3})
            for (int i = 0; i < 8; ++i) {
                const auto pair = pairFromHalfDifference({theta_h, 0.7, theta_d, 0.8 * i});
                if (pair.wo.z <= 0.0 || pair.wi.z <= 0.0) continue;
                result.push_back({Vec4(pair.wo, 0.0), Vec4(pair.wi, 0.0)});
            }
    return result;
}

}  // namespace fbrdf::test
