#include "SceneLights.h"

#include "Vectors.h"

#include <osgFbrdf/AreaLights.h>
#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/PointLights.h>

#include <fbrdf/base/Assert.h>

#include <osg/Camera>
#include <osg/LightSource>
#include <osg/Transform>
#include <osg/View>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace osgFbrdf {
namespace {

bool hasViewOfItsOwn(const osg::Node& node)
{
    const auto* transform = node.asTransform();
    return node.asCamera() && transform->getReferenceFrame() != osg::Transform::RELATIVE_RF;
}

fbrdf::Vec3f turned(const fbrdf::Vec3f& direction, const osg::Matrixd& matrix)
{
    osg::Vec3d result = osg::Matrixd::transform3x3(toOsg(direction), matrix);
    result.normalize();
    return toVec3(result);
}

bool lights(const EnvironmentLight& environment)
{
    const osg::Vec3f& intensity = environment.getIntensity();
    bool isBlack = true;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(intensity[c]) || intensity[c] < 0.0f) return false;
        isBlack = isBlack && !(intensity[c] > 0.0f);
    }
    return environment.valid() && !isBlack && std::isfinite(environment.getRotation());
}

/// From directions of a panorama, whose up is +y and whose middle is -z, to those of its node.
osg::Matrixd fromPanorama(const EnvironmentLight& environment)
{
    const osg::Matrixd upright(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0,
                               0.0, 0.0, 1.0);
    return upright *
           osg::Matrixd::rotate(static_cast<double>(environment.getRotation()), 0.0, 0.0, 1.0);
}

/// Collects lights with the matrices above them; cameras with a view of their own are left out.
/// It sees what the view sees: by the mask of the view, and levels of detail from where the eye is.
class Collector : public osg::NodeVisitor {
public:
    Collector(SceneLights& scene, osgUtil::CullVisitor& view)
        : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN),
          scene_(scene),
          eye_(osg::Matrixd::inverse(worldToEye(view)).getTrans()),
          scale_(view.getLODScale())
    {
        setTraversalMask(view.getTraversalMask());
        setNodeMaskOverride(view.getNodeMaskOverride());
        setFrameStamp(const_cast<osg::FrameStamp*>(view.getFrameStamp()));
    }

    float getDistanceToViewPoint(const osg::Vec3& place, bool scaled) const override
    {
        const double distance = (osg::Vec3d(place) * matrix_ - eye_).length();
        return static_cast<float>(distance) * (scaled ? scale_ : 1.0f);
    }

    void apply(osg::Group& group) override
    {
        if (const auto* lights = dynamic_cast<const PointLights*>(&group)) add(*lights);
        if (const auto* lights = dynamic_cast<const AreaLights*>(&group)) add(*lights);
        if (const auto* light = dynamic_cast<const EnvironmentLight*>(&group)) add(*light);
        traverse(group);
    }
    void apply(osg::Transform& transform) override
    {
        const osg::Matrixd above = matrix_;
        transform.computeLocalToWorldMatrix(matrix_, this);
        traverse(transform);
        matrix_ = above;
    }
    void apply(osg::Camera& camera) override
    {
        if (!hasViewOfItsOwn(camera)) apply(static_cast<osg::Transform&>(camera));
    }
    void apply(osg::LightSource& source) override
    {
        if (source.getLight())
            scene_.sources.push_back({source.getLight(), matrix_,
                                      source.getReferenceFrame() != osg::LightSource::RELATIVE_RF});
        traverse(source);
    }
    // No light is below a drawable.
    void apply(osg::Drawable&) override {}
    void apply(osg::Geode&) override {}

private:
    void add(const PointLights& lights)
    {
        scene_.pointLights.push_back({&lights, lights.getVersion(), matrix_});
    }

    void add(const AreaLights& lights)
    {
        for (const fbrdf::AreaLight& light : lights.getLights()) {
            std::string why = fbrdf::whyInvalid(light);
            fbrdf::AreaLight placed = why.empty() ? moved(light, matrix_) : light;
            if (why.empty()) why = fbrdf::whyInvalid(placed);
            if (why.empty()) {
                scene_.areaLights.push_back(std::move(placed));
                continue;
            }
            ++scene_.dropped;
            scene_.whyInvalid = why;
        }
    }

    void add(const EnvironmentLight& light)
    {
        if (!lights(light)) return;
        if (scene_.environment.cube) {
            ++scene_.environment.leftOut;
            return;
        }
        scene_.environment = {light.cube(), fromPanorama(light) * matrix_, light.getIntensity(),
                              light.getLobes()};
    }

    SceneLights& scene_;
    osg::Matrixd matrix_;
    osg::Vec3d eye_;
    float scale_;
};

/// Places the lights of PointLights, or takes over those of the last frame where nothing has moved.
void placePointLights(SceneLights& scene, SceneLights&& last)
{
    if (scene.pointLights == last.pointLights) {
        scene.lights = std::move(last.lights);
        scene.serial = last.serial;
        scene.pointLightsDropped = last.pointLightsDropped;
    } else {
        static std::atomic<unsigned int> serials{0};
        scene.serial = ++serials;
        for (const PlacedPointLights& placed : scene.pointLights)
            for (const fbrdf::Light& light : placed.node->getLights()) {
                scene.lights.push_back(fbrdf::isValid(light) ? moved(light, placed.toWorld)
                                                             : light);
                if (fbrdf::isValid(scene.lights.back())) continue;
                scene.lights.pop_back();
                ++scene.pointLightsDropped;
            }
    }
    scene.dropped += scene.pointLightsDropped;
}

/// The light of the view lights the effects only where nothing else does, but other objects always.
void addViewLight(SceneLights& scene, const osg::Camera* camera)
{
    const osg::View* view = camera ? camera->getView() : nullptr;
    if (!view || !view->getLight() || view->getLightingMode() == osg::View::NO_LIGHT) return;
    scene.viewNumber = view->getLight()->getLightNum();
    if (!scene.lights.empty() || !scene.sources.empty()) return;
    PlacedOsgLight light{view->getLight(), {}, view->getLightingMode() == osg::View::HEADLIGHT};
    if (scene.environment.cube || !scene.areaLights.empty())
        scene.spare = std::move(light);
    else
        scene.sources.push_back(std::move(light));
}

}  // namespace

fbrdf::Light moved(fbrdf::Light light, const osg::Matrixd& matrix)
{
    using Type = fbrdf::Light::Type;
    light.position = light.type == Type::directional ? turned(light.position, matrix)
                                                     : toVec3(toOsg(light.position) * matrix);
    if (light.type == Type::spot) light.axis = turned(light.axis, matrix);
    return light;
}

fbrdf::AreaLight moved(fbrdf::AreaLight light, const osg::Matrixd& matrix)
{
    const auto place = [&](fbrdf::Vec3f& point) { point = toVec3(toOsg(point) * matrix); };
    const auto turn = [&](fbrdf::Vec3f& vector) {
        vector = toVec3(osg::Matrixd::transform3x3(toOsg(vector), matrix));
    };
    const auto row = [&](int i) { return osg::Vec3d(matrix(i, 0), matrix(i, 1), matrix(i, 2)); };
    const double volume = (row(0) ^ row(1)) * row(2);
    place(light.position);
    place(light.end);
    turn(light.axisU);
    turn(light.axisV);
    for (fbrdf::Vec3f& vertex : light.vertices) place(vertex);
    // Normals turn with planes: by the inverse of the transpose.
    light.normal =
        toVec3(osg::Matrixd::transform3x3(osg::Matrixd::inverse(matrix), toOsg(light.normal)));
    light.size *= static_cast<float>(std::cbrt(std::abs(volume)));
    if (volume < 0.0) {
        light.axisU = -light.axisU;
        std::reverse(light.vertices.begin(), light.vertices.end());
    }
    return light;
}

osg::Vec3f meanOf(const SceneEnvironment& environment)
{
    const fbrdf::Vec3f& mean = environment.cube->mean();
    return osg::componentMultiply(environment.intensity, osg::Vec3f(mean.x, mean.y, mean.z));
}

osg::Node& rootOfLights(const osg::NodePath& path)
{
    FBRDF_ASSERT(path.empty(), ==, false);
    for (size_t i = path.size(); i-- > 0;)
        if (hasViewOfItsOwn(*path[i])) return *path[std::min(i + 1, path.size() - 1)];
    return *path.front();
}

SceneLights lightsBelow(osg::Node& root, osgUtil::CullVisitor& visitor, SceneLights&& last)
{
    SceneLights scene;
    Collector collector(scene, visitor);
    root.accept(collector);
    placePointLights(scene, std::move(last));
    addViewLight(scene, visitor.getCurrentCamera());
    return scene;
}

osg::Matrixd worldToEye(osgUtil::CullVisitor& visitor)
{
    return osg::Matrixd::inverse(osg::computeLocalToWorld(visitor.getNodePath())) *
           *visitor.getModelViewMatrix();
}

}  // namespace osgFbrdf
