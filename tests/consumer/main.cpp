// A host program: it owns the context, the target and the camera; fbrdf draws one object. The lines
// between the two marks are those of README.md; run.cmake compares them.
#include "support/gl/Gl.h"

// README begins
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/io/MaterialFile.h>

// Once, with your context current; `load` is yours: void* load(void* user, const char* name).
fbrdf::gl::Renderer makeRenderer(fbrdf::gl::LoadFunction load)
{
    fbrdf::gl::RendererOptions options;
    options.load = load;
    return fbrdf::gl::Renderer(options);
}

// Every frame: your framebuffer, your camera, your lights. item: what
// createMaterial(readMaterial(file)) and createMesh(triangles) gave, and a model matrix.
void drawFrame(fbrdf::gl::Renderer& renderer, const fbrdf::gl::Item& item,
               const fbrdf::gl::Target& target, const fbrdf::gl::View& view,
               const std::vector<fbrdf::Light>& lights)
{
    renderer.draw(target, view, {item}, lights);
}
// README ends

#include <cstdio>

namespace {

constexpr int kSize = 16;

// The host's own target: RGBA32F and depth.
GLuint makeFramebuffer(const GladGLContext& gl)
{
    GLuint framebuffer = 0, buffers[2] = {};
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.GenRenderbuffers(2, buffers);
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kSize, kSize);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return framebuffer;
}

fbrdf::gl::MeshData triangle()
{
    fbrdf::gl::MeshData mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    return mesh;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    try {
        const fbrdf::HeadlessContext context({});
        const GladGLContext gl = fbrdf::test::loadGl(context.loader());
        fbrdf::gl::Renderer renderer = makeRenderer(context.loader());
        const auto material = renderer.createMaterial(fbrdf::readMaterial(argv[1]));
        const auto mesh = renderer.createMesh(triangle());
        fbrdf::Light light;
        light.type = fbrdf::Light::Type::directional;
        light.position = {0, 0, 1};
        fbrdf::gl::View view;
        view.projection[2][2] = -1.0f;  // orthographic, looking along -z
        drawFrame(renderer, {material.get(), mesh.get()}, {makeFramebuffer(gl), kSize, kSize}, view,
                  {light});
        float pixel[4] = {};
        gl.ReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_FLOAT, pixel);
        std::printf("%g %g %g %g\n", double(pixel[0]), double(pixel[1]), double(pixel[2]),
                    double(pixel[3]));
        // A Lambertian of albedo 1/2 under irradiance 1: 0.5 / pi, to the 8 bits of its maps.
        return pixel[0] > 0.155f && pixel[0] < 0.163f && pixel[3] == 1.0f ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
