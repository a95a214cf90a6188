#include "Scenes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <random>

namespace fbrdf::test {
namespace {

float uniform(std::mt19937& random, float low, float high)
{
    return std::uniform_real_distribution<float>(low, high)(random);
}

Axis axis(int size, double exponent, AxisMap::From from = AxisMap::From::oneMinusCosine)
{
    return {size, {from, exponent}};
}

Table noiseTable(const TableSpec& spec, Storage storage, std::mt19937& random)
{
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    // Linear maps store at most 1, and few digits of values far below.
    const float low = storage == Storage::linear8 ? -4.0f : -1.5f,
                high = storage == Storage::linear8 ? 0.0f : 1.5f;
    table.texels.resize(3 * static_cast<size_t>(texelCount(spec.domain)));
    for (float& texel : table.texels) texel = uniform(random, low, high);
    return quantized(table, storage);
}

/// Two triangles between neighbouring rows of a grid of (rows + 1) x (columns + 1) vertices.
void addGrid(gl::MeshData& mesh, int rows, int columns)
{
    const auto stride = static_cast<uint32_t>(columns + 1);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const uint32_t a = static_cast<uint32_t>(i) * stride + static_cast<uint32_t>(j),
                           b = a + stride;
            for (const uint32_t index : {a, b, b + 1, a, b + 1, a + 1})
                mesh.indices.push_back(index);
        }
}

Vec3f knotPoint(float u)
{
    const float r = 0.6f + 0.25f * std::cos(3.0f * u);
    return {r * std::cos(2.0f * u), r * std::sin(2.0f * u), 0.35f * std::sin(3.0f * u)};
}

}  // namespace

Material noiseMaterial(const Form& form, Storage storage, unsigned seed)
{
    std::mt19937 random(seed);
    Material material;
    material.form = form;
    material.name = form.name + " " + storageName(storage);
    for (const TableSpec& spec : form.tables)
        material.tables.push_back(noiseTable(spec, storage, random));
    for (size_t t = 0; t < form.terms.size(); ++t)
        material.scales.emplace_back(uniform(random, 0.2f, 2.0f), uniform(random, 0.2f, 2.0f),
                                     uniform(random, 0.2f, 2.0f));
    return material;
}

Material calmMaterial(const Form& form)
{
    Material material = noiseMaterial(form, Storage::float32);
    for (Table& table : material.tables) {
        for (float& texel : table.texels) texel *= 0.25f;
        table = quantized(table, Storage::half);
    }
    return material;
}

Form sumOf(const Form& a, const Form& b)
{
    Form form = a;
    const int offset = static_cast<int>(a.tables.size());
    form.name += "+" + b.name;
    form.tables.insert(form.tables.end(), b.tables.begin(), b.tables.end());
    for (Term term : b.terms) {
        for (Factor& factor : term.factors) factor.table += offset;
        form.terms.push_back(term);
    }
    return form;
}

Form formIo()
{
    Form form{"io", {{"D", GridDomain{{axis(6, 0.5), axis(6, 0.5)}, true}}}, {}};
    form.terms = {{{{0, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}}};
    return form;
}

Material waterlooMaterial()
{
    const DiscDomain disc{32, 1.0, 14.0};  // 7/16 of the size: the published maps
    Form form{"waterloo", {{"p", disc}, {"q", disc}, {"s", disc}}, {}};
    form.terms = {{{{0, Direction::wo}, {1, Direction::h}, {0, Direction::wi}}},
                  {{{2, Direction::h}}}};
    return noiseMaterial(form, Storage::linear8);
}

Material everythingMaterial()
{
    const auto cosine = AxisMap::From::cosine;
    Form form;
    form.name = "everything";
    form.tables = {{"volume", GridDomain{{axis(6, 0.25), axis(5, 0.5), axis(4, 1.0)}}},
                   {"odd", GridDomain{{axis(7, 0.7, cosine), axis(1, 0.5)}}},
                   {"line", GridDomain{{axis(9, 1.0, cosine)}}},
                   {"knots", GridDomain{{axis(8, 0.5)}}, true},
                   {"disc", DiscDomain::fitting(9, 0.8)}};
    form.terms = {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d, Angle::theta_i}},
                    {1, std::vector<Angle>{Angle::theta_o, Angle::theta_i}},
                    {3, std::vector<Angle>{Angle::theta_o}}}},
                  {{{2, std::vector<Angle>{Angle::theta_i}},
                    {2, std::vector<Angle>{Angle::theta_o}},
                    {3, std::vector<Angle>{Angle::theta_d}},
                    {4, Direction::wi}}}};
    Material material = noiseMaterial(form, Storage::half);
    Table& line = material.tables[2];
    line.channels = 1;
    line.texels.resize(line.texels.size() / 3);
    return material;
}

Material directionsMaterial()
{
    Form form;
    form.name = "directions";
    form.tables = {{"u", DiscDomain::fitting(9, 0.5)},
                   {"v", DiscDomain::fitting(8, 1.0)},
                   {"a", GridDomain{{axis(6, 0.5), axis(5, 0.5)}}},
                   {"b", GridDomain{{axis(6, 0.5), axis(5, 0.5)}}},
                   {"c", GridDomain{{axis(6, 0.5), axis(5, 0.5)}}}};
    form.terms = {
        {{{0, Direction::d}, {1, Direction::mirror}}},
        {{{1, Direction::combination(0.5, 1.0, 0.5)}, {0, Direction::combination(1.0, 0.0, 1.0)}}},
        {{{2, std::vector<Angle>{Angle::theta_h, Angle::phi_d}},
          {3, std::vector<Angle>{Angle::theta_h, Angle::half_phi_d}},
          {4, std::vector<Angle>{Angle::theta_h, Angle::side_phi_d}}}}};
    Material material = noiseMaterial(form, Storage::half);
    // Signed factors, as those of a singular value decomposition: the first term may be negative.
    for (size_t k = 0; k < 2; ++k) {
        Table& table = material.tables[k];
        table.storage = Storage::signedHalf;
        for (float& texel : table.texels) texel *= 0.25f;
    }
    // phi_d means nothing at theta_h = 0, and there the tables must not depend on it.
    for (const size_t azimuths : {size_t{2}, size_t{3}, size_t{4}})
        for (size_t k = 0; k < material.tables[azimuths].texels.size(); ++k)
            if (k / 3 % 6 == 0) material.tables[azimuths].texels[k] = 0.5f;
    // In the plane of incidence side_phi_d is either end.
    std::vector<float>& sides = material.tables[4].texels;
    std::copy(sides.begin(), sides.begin() + 6 * 3, sides.end() - 6 * 3);
    return material;
}

std::vector<Material> testMaterials()
{
    const Form pqp = formPqp(16, 0.5), pqpr = formPqpr(16, 1.0, 12), hdio = formHdio({16, 8, 8});
    return {noiseMaterial(pqp, Storage::log8),
            noiseMaterial(pqpr, Storage::log8),
            noiseMaterial(hdio, Storage::log8),
            noiseMaterial(sumOf(formIo(), pqp), Storage::half),
            noiseMaterial(sumOf(pqp, pqpr), Storage::float32),
            waterlooMaterial(),
            everythingMaterial(),
            directionsMaterial()};
}

gl::MeshData sphereMesh(int rings)
{
    gl::MeshData mesh;
    const int columns = 2 * rings;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= columns; ++j) {
            const double theta = kPi * i / rings, phi = 2.0 * kPi * j / columns;
            const Vec3d v(std::sin(theta) * std::sin(phi), std::cos(theta),
                          std::sin(theta) * std::cos(phi));
            mesh.positions.emplace_back(v);
            mesh.normals.emplace_back(v);
            mesh.tangents.emplace_back(Vec3d(std::cos(phi), 0.0, -std::sin(phi)));
        }
    addGrid(mesh, rings, columns);
    return mesh;
}

gl::MeshData knotMesh(int segments, int sides)
{
    constexpr float kTube = 0.17f;
    gl::MeshData mesh;
    for (int i = 0; i <= segments; ++i) {
        const float u = 2.0f * static_cast<float>(kPi) * static_cast<float>(i % segments) /
                        static_cast<float>(segments);
        const Vec3f centre = knotPoint(u),
                    along = glm::normalize(knotPoint(u + 1e-2f) - knotPoint(u - 1e-2f)),
                    side = glm::normalize(glm::cross(along, Vec3f(0.0f, 0.0f, 1.0f))),
                    up = glm::cross(side, along);
        for (int j = 0; j <= sides; ++j) {
            const float a = 2.0f * static_cast<float>(kPi) * static_cast<float>(j % sides) /
                            static_cast<float>(sides);
            const Vec3f normal = std::cos(a) * side + std::sin(a) * up;
            mesh.positions.push_back(centre + kTube * normal);
            mesh.normals.push_back(normal);
            mesh.tangents.push_back(along);
        }
    }
    addGrid(mesh, segments, sides);
    return mesh;
}

std::vector<Light> testLights(int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        Light light;
        light.position = {uniform(random, -4.0f, 4.0f), uniform(random, -4.0f, 4.0f),
                          uniform(random, 1.5f, 5.0f)};
        light.intensity = {uniform(random, 0.5f, 4.0f), uniform(random, 0.5f, 4.0f),
                           uniform(random, 0.5f, 4.0f)};
        if (i % 5 == 4) light.type = Light::Type::directional;
        if (i % 5 == 2) {
            light.type = Light::Type::spot;
            light.axis = -light.position;
            light.innerAngle = 0.1f;
            light.outerAngle = 0.4f;
        }
        if (i % 4 == 3) light.radius = uniform(random, 3.0f, 9.0f);
        lights.push_back(light);
    }
    return lights;
}

gl::View perspectiveView()
{
    gl::View view;
    view.view = glm::rotate(glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -4.0f)), 0.4f,
                            Vec3f(1.0f, 0.0f, 0.0f));
    view.projection = glm::perspective(0.6f, 1.0f, 0.5f, 20.0f);
    return view;
}

gl::View orthographicView()
{
    gl::View view = perspectiveView();
    view.projection = glm::ortho(-1.2f, 1.2f, -1.2f, 1.2f, 0.5f, 20.0f);
    return view;
}

}  // namespace fbrdf::test
