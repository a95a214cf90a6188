#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/shaders/ShaderSource.h>
#include <fbrdf/truth/Program.h>
#include <fbrdf/truth/Reference.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace fbrdf::truth {
namespace {

std::string geometryFragment(int glsl, const std::string& value)
{
    const bool old = glsl == 120;
    return "#version " + std::to_string(glsl) + "\n" + (old ? "varying" : "in") +
           " vec3 fbrdfPosition, fbrdfNormal;\n" + (old ? "varying" : "in") +
           " vec4 fbrdfTangent;\n" + (old ? "" : "out vec4 colour;\n") + "void main() { " +
           (old ? "gl_FragColor" : "colour") + " = vec4(" + value + ", 1.0); }\n";
}

struct Buffers {
    GLuint array = 0, names[4] = {};
};

Buffers upload(const GladGLContext& gl, const gl::MeshData& mesh)
{
    Buffers buffers;
    gl.GenVertexArrays(1, &buffers.array);
    gl.BindVertexArray(buffers.array);
    gl.GenBuffers(4, buffers.names);
    const std::vector<Vec3f>* const attributes[] = {&mesh.positions, &mesh.normals, &mesh.tangents};
    for (GLuint i = 0; i < 3; ++i) {
        gl.BindBuffer(GL_ARRAY_BUFFER, buffers.names[i]);
        gl.BufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(attributes[i]->size() * sizeof(Vec3f)),
                      attributes[i]->data(), GL_STATIC_DRAW);
        gl.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl.EnableVertexAttribArray(i);
    }
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.names[3]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);
    return buffers;
}

void setMatrices(const GladGLContext& gl, GLuint program, const glm::mat4& model,
                 const gl::View& view)
{
    const glm::dmat4 modelView = glm::dmat4(view.view) * glm::dmat4(model);
    const glm::mat4 rounded(modelView);
    const auto at = [&](const char* name) { return gl.GetUniformLocation(program, name); };
    gl.UniformMatrix4fv(at("fbrdfModelView"), 1, GL_FALSE, glm::value_ptr(rounded));
    gl.UniformMatrix4fv(at("fbrdfProjection"), 1, GL_FALSE, glm::value_ptr(view.projection));
}

Vec3d pixelOf(const std::vector<float>& image, size_t pixel)
{
    return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

struct Incident {
    Vec3d toLight, irradiance;
};

Incident incidentFrom(const Light& light, const glm::dmat4& view, const Vec3d& point)
{
    const bool hasPlace = light.type != Light::Type::directional;
    const Vec3d position(view * glm::dvec4(Vec3d(light.position), hasPlace ? 1.0 : 0.0));
    const Vec3d difference = hasPlace ? position - point : position;
    const double squared = glm::dot(difference, difference);
    const Vec3d toLight = glm::normalize(difference),
                inWorld(glm::transpose(glm::dmat3(view)) * toLight);
    const double factor = (hasPlace ? falloff(squared, static_cast<double>(light.radius)) : 1.0) *
                          coneFactor(light, inWorld);
    return {toLight, factor * Vec3d(light.intensity)};
}

}  // namespace

GeometryBuffer geometryBuffer(const GladGLContext& gl, Offscreen& offscreen,
                              const gl::MeshData& mesh, const glm::mat4& model,
                              const gl::View& view)
{
    const Buffers buffers = upload(gl, mesh);
    gl.BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
    gl.Viewport(0, 0, offscreen.width(), offscreen.height());
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    GeometryBuffer result;
    std::vector<float>* const images[] = {&result.position, &result.normal, &result.tangent};
    const char* const values[] = {"fbrdfPosition", "fbrdfNormal", "fbrdfTangent.xyz"};
    for (int i = 0; i < 3; ++i) {
        const int glsl = gl.VERSION_3_1 ? 140 : 120;
        const GLuint program =
            linkProgram(gl, vertexSource(glsl), geometryFragment(glsl, values[i]));
        gl.UseProgram(program);
        setMatrices(gl, program, model, view);
        offscreen.clear();
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT,
                        nullptr);
        *images[i] = offscreen.readPixels();
        gl.UseProgram(0);
        gl.DeleteProgram(program);
    }
    gl.BindVertexArray(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteVertexArrays(1, &buffers.array);
    gl.DeleteBuffers(4, buffers.names);
    offscreen.clear();
    return result;
}

std::vector<double> referenceImage(const Material& material, const GeometryBuffer& geometry,
                                   const std::vector<Light>& lights, const gl::View& view,
                                   const SurfaceReference& surface)
{
    const glm::dmat4 toEye(view.view);
    const bool perspective = view.projection[3][3] == 0.0f;
    std::vector<double> image(geometry.position.size(), 0.0);
    for (size_t pixel = 0; pixel < image.size() / 4; ++pixel) {
        if (!geometry.covers(pixel)) continue;
        const Vec3d point = pixelOf(geometry.position, pixel);
        auto frame = shadingFrame(pixelOf(geometry.normal, pixel), pixelOf(geometry.tangent, pixel),
                                  surface.handedness);
        if (surface.normal) frame = perturbed(frame, surface.normal(pixel));
        const Vec3d wo = frame.local(perspective ? glm::normalize(-point) : Vec3d(0.0, 0.0, 1.0));
        Vec3d sum(0.0);
        for (size_t i = 0; i < lights.size(); ++i) {
            if (!isValid(lights[i])) continue;
            const Incident incident = incidentFrom(lights[i], toEye, point);
            const Vec3d wi = frame.local(incident.toLight);
            const double shadow = surface.shadow ? surface.shadow(i, point) : 1.0;
            if (wi.z > 0.0) sum += shadow * evaluate(material, wo, wi) * incident.irradiance * wi.z;
        }
        for (int c = 0; c < 3; ++c) image[4 * pixel + static_cast<size_t>(c)] = sum[c];
        image[4 * pixel + 3] = 1.0;
    }
    return image;
}

}  // namespace fbrdf::truth
