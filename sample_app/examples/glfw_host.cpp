// glfw_host.cpp - a window of GLFW in which fbrdf draws one material on a sphere.
// Usage: glfw_host MATERIAL.fbrdf [FRAMES PICTURE.ppm]: with a number of frames it then writes what
// the window shows and ends; otherwise it runs until the window is closed.
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/io/MaterialFile.h>

#include <GLFW/glfw3.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

// The unit sphere; tangents follow increasing azimuth about +y.
fbrdf::gl::MeshData sphere(uint32_t rings)
{
    const uint32_t columns = 2 * rings + 1;
    fbrdf::gl::MeshData mesh;
    for (uint32_t ring = 0; ring <= rings; ++ring)
        for (uint32_t column = 0; column < columns; ++column) {
            const float step = glm::pi<float>() / static_cast<float>(rings);
            const float polar = step * static_cast<float>(ring);
            const float azimuth = step * static_cast<float>(column);
            mesh.normals.emplace_back(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                      std::sin(polar) * std::cos(azimuth));
            mesh.tangents.emplace_back(std::cos(azimuth), 0.0f, -std::sin(azimuth));
            const uint32_t a = ring * columns + column, b = a + columns;
            if (ring < rings && column + 1 < columns)
                mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    mesh.positions = mesh.normals;
    return mesh;
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
    // [readme]
    // Once, with your OpenGL context current:
    fbrdf::gl::RendererOptions options;
    options.load = [](void*, const char* name) { return (void*)glfwGetProcAddress(name); };
    options.log = [](fbrdf::gl::Severity, const std::string& text) { std::cerr << text << '\n'; };
    fbrdf::gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(fbrdf::readMaterial(file));
    const auto mesh = renderer.createMesh(sphere(64));
    const fbrdf::Light lamp{fbrdf::Light::Type::point, {2.0f, 3.0f, 3.0f}, glm::vec3(30.0f)};
    // [/readme]
    for (int frame = 0; frame != frames && !glfwWindowShouldClose(window); ++frame) {
        glfwPollEvents();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width == 0 || height == 0) continue;  // the window is minimised
        const float aspect = static_cast<float>(width) / static_cast<float>(height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        // [readme]
        // Every frame, with your own window or framebuffer, camera and lights:
        const fbrdf::gl::Target target{0, width, height, fbrdf::Transfer::srgb};  // 0: the window
        const fbrdf::gl::View view{glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -4.0f}),
                                   glm::perspective(glm::radians(35.0f), aspect, 0.1f, 10.0f)};
        const float turned = 0.01f * static_cast<float>(frame);
        const fbrdf::gl::Item item{material.get(), mesh.get(),
                                   glm::rotate(glm::mat4(1.0f), turned, {0.0f, 1.0f, 0.0f})};
        renderer.draw(target, view, {item}, {lamp});
        // [/readme]
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
