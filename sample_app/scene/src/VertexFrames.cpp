#include <fbrdf/scene/VertexFrames.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::scene {
namespace {

// Below this length of what should be near unit length, a direction is rounding noise.
constexpr double kDirectionless = 1e-6;

std::array<uint32_t, 3> triangleAt(const std::vector<uint32_t>& indices, size_t first)
{
    return {indices[first], indices[first + 1], indices[first + 2]};
}

/// Adds the face's normal, weighted by the angle at each corner.
void addFaceNormal(const std::vector<Vec3f>& positions, const std::array<uint32_t, 3>& corner,
                   std::vector<Vec3d>& sum)
{
    const std::array<Vec3d, 3> p{Vec3d(positions[corner[0]]), Vec3d(positions[corner[1]]),
                                 Vec3d(positions[corner[2]])};
    const Vec3d area = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (!(glm::length(area) > 0.0)) return;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3d a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
        sum[corner[i]] += angle * glm::normalize(area);
    }
}

/// Direction of growing u on a face: solves edge = du * dP/du + dv * dP/dv. Zero if undefined.
Vec3d growingU(const std::array<Vec3d, 3>& p, const std::array<Vec2<double>, 3>& uv)
{
    const Vec2<double> a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double area = a.x * b.y - b.x * a.y;
    const Vec3d direction = (p[1] - p[0]) * b.y - (p[2] - p[0]) * a.y;
    const double length = glm::length(direction);
    if (!(std::abs(area) > 0.0) || !(length > 0.0)) return Vec3d(0.0);
    return direction * (std::copysign(1.0, area) / length);
}

}  // namespace

std::vector<Vec3f> smoothNormals(const std::vector<Vec3f>& positions,
                                 const std::vector<uint32_t>& indices)
{
    std::vector<Vec3d> sum(positions.size(), Vec3d(0.0));
    for (size_t i = 0; i + 2 < indices.size(); i += 3)
        addFaceNormal(positions, triangleAt(indices, i), sum);
    std::vector<Vec3f> normals(positions.size(), Vec3f(0.0f, 0.0f, 1.0f));
    for (size_t i = 0; i < sum.size(); ++i)
        if (glm::length(sum[i]) > kDirectionless) normals[i] = Vec3f(glm::normalize(sum[i]));
    return normals;
}

Vec3f azimuthTangent(const Vec3f& normal)
{
    const double length = std::hypot(double(normal.x), double(normal.z));
    if (length < kDirectionless) return {1.0f, 0.0f, 0.0f};
    return Vec3f(Vec3d(normal.z, 0.0, -normal.x) / length);
}

Vec3f orthogonalTangent(const Vec3f& direction, const Vec3f& normal)
{
    const Vec3d n(normal), d(direction);
    const Vec3d flat = d - n * glm::dot(n, d);
    const double length = glm::length(flat);
    if (!(length > kDirectionless * glm::length(d))) return azimuthTangent(normal);
    return Vec3f(flat / length);
}

void computeTangents(Mesh& mesh, const std::vector<glm::vec2>& textureCoordinates)
{
    std::vector<Vec3d> sum(mesh.positions.size(), Vec3d(0.0));
    const bool usable = textureCoordinates.size() == mesh.positions.size();
    for (size_t i = 0; usable && i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = triangleAt(mesh.indices, i);
        std::array<Vec3d, 3> p;
        std::array<Vec2<double>, 3> uv;
        for (size_t k = 0; k < 3; ++k) {
            p[k] = Vec3d(mesh.positions[corner[k]]);
            uv[k] = Vec2<double>(textureCoordinates[corner[k]]);
        }
        const Vec3d direction = growingU(p, uv);
        for (const uint32_t index : corner) sum[index] += direction;
    }
    mesh.tangents.resize(mesh.positions.size());
    for (size_t i = 0; i < sum.size(); ++i)
        mesh.tangents[i] = orthogonalTangent(Vec3f(sum[i]), mesh.normals[i]);
}

}  // namespace fbrdf::scene
