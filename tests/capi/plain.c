#include "plain.h"

#include <string.h>

enum { SIZE = 4, TEXELS = SIZE * SIZE };

/* T1(theta_h, theta_d) T2(theta_i, theta_o), of SIZE knots a side. */
static const char kForm[] =
    "{\"name\": \"hdio\", \"tables\": ["
    "{\"name\": \"T1\", \"domain\": {\"grid\": {\"symmetric\": false, \"axes\": ["
    "{\"size\": 4, \"from\": \"1-cos\", \"exponent\": 0.25},"
    "{\"size\": 4, \"from\": \"1-cos\", \"exponent\": 0.5}]}}},"
    "{\"name\": \"T2\", \"domain\": {\"grid\": {\"symmetric\": true, \"axes\": ["
    "{\"size\": 4, \"from\": \"cos\", \"exponent\": 0.5},"
    "{\"size\": 4, \"from\": \"cos\", \"exponent\": 0.5}]}}}],"
    "\"terms\": [[{\"table\": 0, \"argument\": [\"theta_h\", \"theta_d\"]},"
    "{\"table\": 1, \"argument\": [\"theta_i\", \"theta_o\"]}]]}";

fbrdf_result plain_material(const fbrdf_log* log, fbrdf_material** out)
{
    float first[3 * TEXELS], second[3 * TEXELS];
    for (int i = 0; i < 3 * TEXELS; ++i) {
        first[i] = -2.0f + (float)(i % 3); /* log2 of 1/4, 1/2, 1 */
        second[i] = 0.0f;
    }
    fbrdf_table tables[2];
    memset(tables, 0, sizeof tables);
    tables[0].texels = first;
    tables[1].texels = second;
    tables[0].texel_count = tables[1].texel_count = TEXELS;
    fbrdf_material_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.form = kForm;
    desc.table_count = 2;
    desc.table_size = sizeof tables[0];
    desc.tables = tables;
    desc.name = "plain";
    return fbrdf_material_create(&desc, log, out);
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

fbrdf_result plain_draw_mesh(fbrdf_renderer* renderer, const fbrdf_gpu_material* material,
                             const fbrdf_mesh* mesh, uint32_t framebuffer, int32_t size,
                             const fbrdf_depth_desc* depth, fbrdf_draw_stats* stats)
{
    fbrdf_item item;
    memset(&item, 0, sizeof item);
    item.material = material;
    item.mesh = mesh;
    identity(item.model);
    fbrdf_light light;
    memset(&light, 0, sizeof light);
    light.type = FBRDF_LIGHT_DIRECTIONAL;
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
    desc.depth = depth;
    return fbrdf_draw(renderer, &desc, stats);
}

fbrdf_result plain_draw_with_depth(fbrdf_load_function load, void* user, fbrdf_log log,
                                   uint32_t framebuffer, int32_t size,
                                   const fbrdf_depth_desc* depth, fbrdf_draw_stats* stats)
{
    fbrdf_renderer_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.api_version = FBRDF_API_VERSION;
    desc.load = load;
    desc.load_user = user;
    desc.log = log;
    fbrdf_renderer* renderer = NULL;
    fbrdf_material* material = NULL;
    fbrdf_gpu_material* gpu_material = NULL;
    fbrdf_mesh* mesh = NULL;
    fbrdf_result result = fbrdf_renderer_create(&desc, &renderer);
    if (result == FBRDF_RESULT_OK) result = plain_material(&log, &material);
    if (result == FBRDF_RESULT_OK)
        result = fbrdf_gpu_material_create(renderer, material, NULL, &gpu_material);
    if (result == FBRDF_RESULT_OK) result = quad(renderer, &mesh);
    if (result == FBRDF_RESULT_OK)
        result = plain_draw_mesh(renderer, gpu_material, mesh, framebuffer, size, depth, stats);
    fbrdf_renderer_release(renderer); /* in any order */
    fbrdf_mesh_release(mesh);
    fbrdf_gpu_material_release(gpu_material);
    fbrdf_material_release(material);
    return result;
}

fbrdf_result plain_draw(fbrdf_load_function load, void* user, fbrdf_log log, uint32_t framebuffer,
                        int32_t size, fbrdf_draw_stats* stats)
{
    return plain_draw_with_depth(load, user, log, framebuffer, size, NULL, stats);
}
