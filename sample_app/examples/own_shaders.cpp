// own_shaders.cpp - an engine that draws by itself, here by tracing rays to a sphere: its shader
// contains the GLSL functions of a material, and fbrdf binds the maps. Usage: as glfw_host.
#include <fbrdf/gl/MaterialBinding.h>
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/plan/LightVectors.h>

#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLEXT
#include <GLFW/glfw3.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace {

// One triangle that covers the window.
const char* const kTriangle =
    "#version 140\nout vec2 at;\nvoid main() { at = vec2(gl_VertexID == 1 ? 3 : -1,"
    " gl_VertexID == 2 ? 3 : -1); gl_Position = vec4(at, 0, 1); }\n";

// A unit sphere 4 units before an eye whose field of view is 35 degrees.
const char* const kSphere = R"(
in vec2 at; out vec4 colour;
void main()
{
    vec3 ray = normalize(vec3(at * tan(radians(17.5)), -1.0)), centre = vec3(0.0, 0.0, -4.0);
    float middle = dot(ray, centre), inside = middle * middle - dot(centre, centre) + 1.0;
    if (inside < 0.0) discard;
    vec3 position = ray * (middle - sqrt(inside)), normal = position - centre;
    vec3 tangent = normalize(vec3(normal.z, 0.0, -normal.x));
    vec3 radiance = min(fbrdfRadiance(position, normal, tangent, -ray), 1.0);
    colour = vec4(fbrdfSrgbFromLinear(radiance), 1.0);
}
)";

void attach(GLuint program, GLenum stage, const std::string& source)
{
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    std::cerr << log;  // empty where it compiles
    glAttachShader(program, shader);
}

void writePicture(const std::string& path, int width, int height)
{
    const auto row = static_cast<std::streamsize>(3) * width;
    std::vector<char> pixels(static_cast<size_t>(row * height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << ' ' << height << "\n255\n";
    for (int y = height - 1; y >= 0; --y) file.write(pixels.data() + row * y, row);
}

void show(GLFWwindow* window, const std::string& file, int frames, const std::string& picture)
{
    fbrdf::gl::RendererOptions options;
    options.load = [](void*, const char* name) { return (void*)glfwGetProcAddress(name); };
    fbrdf::gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(fbrdf::readMaterial(file));
    // [readme]
    // Your shader calls fbrdfRadiance(position, normal, tangent, viewer) or fbrdfEvaluate(wo, wi).
    const GLuint program = glCreateProgram();
    attach(program, GL_VERTEX_SHADER, kTriangle);
    attach(program, GL_FRAGMENT_SHADER,
           "#version 140\n" + fbrdf::gl::materialFunctions(*material, 140, 8) + kSphere);
    glLinkProgram(program);
    const fbrdf::gl::MaterialBinding binding(material, program);
    // Every frame: the program becomes current, its maps take the texture units from 0 on.
    binding.apply(0);
    // In the space of the shader: from the eye.
    const fbrdf::Light lamp{fbrdf::Light::Type::point, {2.0f, 3.0f, -1.0f}, glm::vec3(30.0f)};
    const fbrdf::LightVectors vectors = fbrdf::lightVectors(lamp, glm::dmat4(1.0));
    glUniform4fv(glGetUniformLocation(program, "fbrdfLights"), 3, &vectors[0].x);
    glUniform1i(glGetUniformLocation(program, "fbrdfLightCount"), 1);
    // [/readme]
    for (int frame = 0; frame != frames && !glfwWindowShouldClose(window); ++frame) {
        glfwPollEvents();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        if (frame + 1 == frames) writePicture(picture, width, height);
        glfwSwapBuffers(window);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 4) {
        std::cerr << "usage: " << argv[0] << " MATERIAL.fbrdf [FRAMES PICTURE.ppm]\n";
        return 2;
    }
    int status = 1;
    glfwSetErrorCallback([](int, const char* text) { std::cerr << text << '\n'; });
    glfwInit();
    if (GLFWwindow* window = glfwCreateWindow(512, 512, "fbrdf", nullptr, nullptr)) {
        glfwMakeContextCurrent(window);
        try {
            show(window, argv[1], argc == 4 ? std::stoi(argv[2]) : -1, argc == 4 ? argv[3] : "");
            status = 0;
        } catch (const std::exception& error) {
            std::cerr << error.what() << '\n';
        }
    }
    glfwTerminate();
    return status;
}
