/* glfw_host.c - the same as glfw_host.cpp in C, through the C ABI: a window of GLFW in which fbrdf
 * draws one material on a sphere. Usage: glfw_host_c MATERIAL.fbrdf [FRAMES PICTURE.ppm] */
#include <fbrdf/fbrdf.h>

#include <GLFW/glfw3.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RINGS = 64, COLUMNS = 2 * RINGS + 1, VERTICES = (RINGS + 1) * COLUMNS };
static const float kStep = 3.14159265f / RINGS;

static void print(void* user, fbrdf_severity severity, fbrdf_result code, const char* text)
{
    (void)user, (void)severity, (void)code;
    fprintf(stderr, "%s\n", text);
}

static void* load(void* user, const char* name)
{
    return (void)user, (void*)glfwGetProcAddress(name);
}

/* The unit sphere; tangents follow increasing azimuth about +y. */
static fbrdf_result make_sphere(fbrdf_renderer* renderer, fbrdf_mesh** out)
{
    static float normals[VERTICES][3], tangents[VERTICES][3];
    static uint32_t indices[RINGS * (COLUMNS - 1)][6];
    uint32_t quads = 0;
    for (uint32_t i = 0; i < VERTICES; ++i) {
        const float polar = kStep * (float)(i / COLUMNS), azimuth = kStep * (float)(i % COLUMNS);
        normals[i][0] = sinf(polar) * sinf(azimuth), normals[i][1] = cosf(polar);
        normals[i][2] = sinf(polar) * cosf(azimuth);
        tangents[i][0] = cosf(azimuth), tangents[i][2] = -sinf(azimuth);
        const uint32_t corners[6] = {i, i + COLUMNS, i + 1, i + 1, i + COLUMNS, i + COLUMNS + 1};
        if (i / COLUMNS < RINGS && i % COLUMNS + 1 < COLUMNS)
            memcpy(indices[quads++], corners, sizeof corners);
    }
    const fbrdf_mesh_desc desc = {.struct_size = sizeof desc,
                                  .vertex_count = VERTICES,
                                  .index_count = 6 * quads,
                                  .positions = normals[0],
                                  .normals = normals[0],
                                  .tangents = tangents[0],
                                  .indices = indices[0]};
    return fbrdf_mesh_create(renderer, &desc, out);
}

static void write_picture(const char* path, int width, int height)
{
    static unsigned char row[3 * 16384]; /* wider than any window */
    FILE* file = fopen(path, "wb");
    if (!file) exit(1);
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height - 1; y >= 0; --y) {
        glReadPixels(0, y, width, 1, GL_RGB, GL_UNSIGNED_BYTE, row);
        fwrite(row, 3, (size_t)width, file);
    }
    fclose(file);
}

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 4)
        return fputs("expected MATERIAL.fbrdf [FRAMES FILE.ppm]\n", stderr), 2;
    const int frames = argc == 4 ? atoi(argv[2]) : -1;
    GLFWwindow* window = glfwInit() ? glfwCreateWindow(512, 512, "fbrdf", NULL, NULL) : NULL;
    if (!window) return fputs("found no display with OpenGL, expected one\n", stderr), 1;
    glfwMakeContextCurrent(window);
    /* Once, with your OpenGL context current: */
    const fbrdf_log log = {.function = print};
    const fbrdf_renderer_desc options = {
        .struct_size = sizeof options, .api_version = FBRDF_API_VERSION, .load = load, .log = log};
    fbrdf_renderer* renderer = NULL;
    fbrdf_material* data = NULL;
    fbrdf_gpu_material* material = NULL;
    fbrdf_mesh* mesh = NULL;
    if (fbrdf_renderer_create(&options, &renderer) != FBRDF_RESULT_OK ||
        fbrdf_material_read(argv[1], &log, &data) != FBRDF_RESULT_OK ||
        fbrdf_gpu_material_create(renderer, data, NULL, &material) != FBRDF_RESULT_OK ||
        make_sphere(renderer, &mesh) != FBRDF_RESULT_OK)
        return 1;
    for (int frame = 0; frame != frames && !glfwWindowShouldClose(window); ++frame) {
        glfwPollEvents();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width == 0 || height == 0) continue; /* the window is minimised */
        const float turn = 0.01f * (float)frame;
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        /* Every frame, with your own window or framebuffer, camera and lights: */
        const fbrdf_light lamp = {.position = {2, 3, 3}, .intensity = {30, 30, 30}};
        fbrdf_item item = {.material = material, .mesh = mesh};
        item.model[0] = item.model[10] = cosf(turn), item.model[5] = item.model[15] = 1;
        item.model[8] = sinf(turn), item.model[2] = -sinf(turn);
        fbrdf_draw_desc draw = {.struct_size = sizeof draw, .width = width, .height = height};
        draw.transfer = FBRDF_TRANSFER_SRGB; /* a window shows sRGB */
        draw.view[0] = draw.view[5] = draw.view[10] = draw.view[15] = 1, draw.view[14] = -4;
        draw.projection[5] = 3.17159f; /* a field of view of 35 degrees, seen from 0.1 to 10 */
        draw.projection[0] = draw.projection[5] * (float)height / (float)width;
        draw.projection[10] = -1.0202f, draw.projection[11] = -1, draw.projection[14] = -0.20202f;
        draw.item_count = 1, draw.item_size = sizeof item, draw.items = &item;
        draw.light_count = 1, draw.light_size = sizeof lamp, draw.lights = &lamp;
        fbrdf_draw(renderer, &draw, NULL);
        if (frame + 1 == frames) write_picture(argv[3], width, height);
        glfwSwapBuffers(window);
    }
    fbrdf_mesh_release(mesh);
    fbrdf_gpu_material_release(material);
    fbrdf_material_release(data);
    fbrdf_renderer_release(renderer);
    glfwTerminate();
    return 0;
}
