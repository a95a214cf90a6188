#include <fbrdf/base/Assert.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/Layout.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf::scene {
namespace {

// A sphere that lies on a plane hides 1 / 5^3 = 0.8 % of the sky at so many of its radii.
constexpr double kRadiusOverObjects = 5.0;

double lowestOf(const std::vector<Instance>& objects)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (const Instance& object : objects)
        for (const Vec3f& position : object.mesh->positions)
            lowest =
                std::min(lowest, (glm::dmat4(object.model) * glm::dvec4(Vec3d(position), 1.0)).y);
    return lowest;
}

}  // namespace

double SkyVisibility::at(double x, double z) const
{
    const auto place = [this](double at) {
        return std::clamp(0.5 * (at + 1.0), 0.0, 1.0) * (size - 1);
    };
    const double column = place(x), row = place(z);
    const int left = std::min(static_cast<int>(column), std::max(0, size - 2)),
              top = std::min(static_cast<int>(row), std::max(0, size - 2));
    const auto texel = [&](int i, int k) {
        const int u = std::min(left + i, size - 1), v = std::min(top + k, size - 1);
        return static_cast<double>(texels[static_cast<size_t>(v * size + u)]);
    };
    const double right = column - left;
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), right),
                    glm::mix(texel(0, 1), texel(1, 1), right), row - top);
}

Ground::Ground(const std::vector<Instance>& objects)
    : objects_(scene::boundsOf(objects)), mesh_(makePlane(1))
{
    FBRDF_ASSERT(objects.size(), >, 0u);
    centre_ = {objects_.centre.x, lowestOf(objects), objects_.centre.z};
    radius_ = kRadiusOverObjects * std::max(1e-6, static_cast<double>(objects_.radius));
}

glm::mat4 Ground::placement() const
{
    const glm::mat4 placed = glm::rotate(glm::translate(glm::mat4(1.0f), Vec3f(centre_)),
                                         static_cast<float>(angle_), {0.0f, 1.0f, 0.0f});
    return glm::scale(placed, Vec3f(static_cast<float>(radius_)));
}

Instance Ground::object(int index) const
{
    // makePlane faces +z.
    const auto quarter = static_cast<float>(-0.5 * kPi);
    return {&mesh_, glm::rotate(placement(), quarter, {1.0f, 0.0f, 0.0f}), index};
}

Bounds Ground::bounds() const
{
    const double reach = std::sqrt(2.0) * radius_ + 2.0 * static_cast<double>(objects_.radius);
    return {Vec3f(centre_), static_cast<float>(reach)};
}

Material Ground::material()
{
    Material material;
    material.form = formHdio({2, 2, 2});
    material.name = "ground";
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        const auto size = domainSize(spec.domain);
        table.texels.assign(3 * static_cast<size_t>(size[0]) * static_cast<size_t>(size[1]), 0.0f);
        material.tables.push_back(std::move(table));
    }
    material.scales.emplace_back(static_cast<float>(kAlbedo / kPi));
    return material;
}

Brdf Ground::brdf()
{
    return [](const Vec3d&, const Vec3d&) { return Vec3d(kAlbedo / kPi); };
}

double Ground::opacity(const Vec3d& position) const
{
    const double distance = std::hypot(position.x - centre_.x, position.z - centre_.z) / radius_;
    const double t = std::clamp((distance - kOpaque) / (1.0 - kOpaque), 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

Vec3d Ground::reflectedSky(const Vec3d& position, const Vec3d& irradiance) const
{
    const Vec3d place(glm::inverse(glm::dmat4(placement())) * glm::dvec4(position, 1.0));
    return visibility_.at(place.x, place.z) * kAlbedo / kPi * irradiance;
}

bool Ground::isSeenFrom(const gl::View& view) const
{
    // The sign of the plane's distance from the eye; a parallel projection has its eye infinitely
    // far away.
    const bool isParallel = view.projection[3][3] != 0.0f;
    const glm::dmat4 toWorld = glm::inverse(glm::dmat4(view.view));
    return isParallel ? toWorld[2].y > 0.0 : toWorld[3].y > centre_.y;
}

}  // namespace fbrdf::scene
