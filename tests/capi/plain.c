#include "plain.h"

#include <string.h>

enum { SIZE = 4, TEXELS = SIZE * SIZE };

fbrdf_result plain_brdf(const fbrdf_log* log, fbrdf_brdf** out)
{
    float first[3 * TEXELS], second[3 * TEXELS];
    for (int i = 0; i < 3 * TEXELS; ++i) {
        first[i] = -2.0f + (float)(i % 3); /* log2 of 1/4, 1/2, 1 */
        second[i] = 0.0f;
    }
    const float* const tables[2] = {first, second};
    fbrdf_brdf_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.form = FBRDF_HDIO;
    desc.size[0] = desc.size[1] = desc.size[2] = SIZE;
    desc.table_count = 2;
    desc.tables = tables;
    desc.name = "plain";
    return fbrdf_brdf_create(&desc, log, out);
}

static fbrdf_result quad(fbrdf_renderer* renderer, fbrdf_mesh** out)
{
    static const float positions[12] = {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0};
    static const float normals[12] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    fbrdf_mesh_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.vertex_count = 4;
    desc.index_count = 6;
    desc.positions = positions;
    desc.normals = normals;
    desc.indices = indices;
    return fbrdf_mesh_create(renderer, &desc, out);
}

static void identity(float matrix[16])
{
    memset(matrix, 0, 16 * sizeof(float));
    matrix[0] = matrix[5] = matrix[10] = matrix[15] = 1.0f;
}

static fbrdf_result draw(fbrdf_renderer* renderer, const fbrdf_material* material,
                         const fbrdf_mesh* mesh, uint32_t framebuffer, int32_t size,
                         fbrdf_draw_stats* stats)
{
    fbrdf_item item;
    memset(&item, 0, sizeof item);
    item.material = material;
    item.mesh = mesh;
    identity(item.model);
    fbrdf_light light;
    memset(&light, 0, sizeof light);
    light.type = FBRDF_DIRECTIONAL;
    light.position[2] = 1.0f;
    light.intensity[0] = light.intensity[1] = light.intensity[2] = 1.0f;
    fbrdf_draw_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.framebuffer = framebuffer;
    desc.width = desc.height = size;
    identity(desc.view);
    identity(desc.projection);
    desc.projection[10] = -1.0f; /* parallel, along -z */
    desc.item_count = 1;
    desc.item_size = sizeof item;
    desc.items = &item;
    desc.light_count = 1;
    desc.light_size = sizeof light;
    desc.lights = &light;
    return fbrdf_draw(renderer, &desc, stats);
}

fbrdf_result plain_draw(fbrdf_load_function load, void* user, fbrdf_log log, uint32_t framebuffer,
                        int32_t size, fbrdf_draw_stats* stats)
{
    fbrdf_renderer_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.api_version = FBRDF_API_VERSION;
    desc.load = load;
    desc.load_user = user;
    desc.log = log;
    fbrdf_renderer* renderer = NULL;
    fbrdf_brdf* brdf = NULL;
    fbrdf_material* material = NULL;
    fbrdf_mesh* mesh = NULL;
    fbrdf_result result = fbrdf_renderer_create(&desc, &renderer);
    if (result == FBRDF_OK) result = plain_brdf(&log, &brdf);
    if (result == FBRDF_OK) result = fbrdf_material_create(renderer, brdf, &material);
    if (result == FBRDF_OK) result = quad(renderer, &mesh);
    if (result == FBRDF_OK) result = draw(renderer, material, mesh, framebuffer, size, stats);
    fbrdf_renderer_release(renderer); /* in any order */
    fbrdf_mesh_release(mesh);
    fbrdf_material_release(material);
    fbrdf_brdf_release(brdf);
    return result;
}
