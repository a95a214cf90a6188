#include "SceneLights.h"

#include "GlLights.h"
#include "InheritedState.h"
#include "Surfaces.h"
#include "Vectors.h"

#include <osgFbrdf/PointLights.h>

#include <osg/Camera>
#include <osg/LightSource>
#include <osg/Transform>
#include <osg/View>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

constexpr const char* kKey = "osgFbrdf::SceneLights";

bool isView(const osg::Node& node)
{
    const auto* transform = node.asTransform();
    return node.asCamera() && transform->getReferenceFrame() != osg::Transform::RELATIVE_RF;
}

osg::Vec3d toOsg(const fbrdf::Vec3f& v)
{
    const fbrdf::Vec3d d(v);
    return {d.x, d.y, d.z};
}

fbrdf::Vec3f turned(const fbrdf::Vec3f& direction, const osg::Matrixd& matrix)
{
    osg::Vec3d result = osg::Matrixd::transform3x3(toOsg(direction), matrix);
    result.normalize();
    return toVec3(result);
}

fbrdf::Light moved(fbrdf::Light light, const osg::Matrixd& matrix)
{
    using Type = fbrdf::Light::Type;
    light.position = light.type == Type::directional ? turned(light.position, matrix)
                                                     : toVec3(toOsg(light.position) * matrix);
    if (light.type == Type::spot) light.axis = turned(light.axis, matrix);
    return light;
}

/// Collects lights with the matrices above them; cameras with a view of their own are left out.
/// Sees what the view sees: its mask, and levels of detail from where it is.
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
        if (!isView(camera)) apply(static_cast<osg::Transform&>(camera));
    }
    void apply(osg::LightSource& source) override
    {
        if (source.getLight())
            scene_.plain.push_back({source.getLight(), matrix_,
                                    source.getReferenceFrame() != osg::LightSource::RELATIVE_RF});
        traverse(source);
    }
    // Nothing that lights is below a drawable.
    void apply(osg::Drawable&) override {}
    void apply(osg::Geode&) override {}

private:
    void add(const PointLights& lights)
    {
        for (const fbrdf::Light& light : lights.getLights()) {
            const fbrdf::Light placed = fbrdf::isValid(light) ? moved(light, matrix_) : light;
            if (fbrdf::isValid(placed))
                scene_.lights.push_back(placed);
            else
                ++scene_.dropped;
        }
    }

    SceneLights& scene_;
    osg::Matrixd matrix_;
    osg::Vec3d eye_;
    float scale_;
};

/// Where the coordinates of the lights begin: below the last camera with a view of its own.
size_t rootOf(const osg::NodePath& path)
{
    for (size_t i = path.size(); i-- > 0;)
        if (isView(*path[i])) return std::min(i + 1, path.size() - 1);
    return 0;
}

/// Lights the effects only where nothing else does, but other objects always.
void findViewLight(SceneLights& scene, const osg::Camera* camera)
{
    scene.viewNumber = -1;
    const osg::View* view = camera ? camera->getView() : nullptr;
    if (!view || !view->getLight() || view->getLightingMode() == osg::View::NO_LIGHT) return;
    scene.viewNumber = view->getLight()->getLightNum();
    if (!scene.lights.empty() || !scene.plain.empty()) return;
    scene.plain.push_back({view->getLight(), {}, view->getLightingMode() == osg::View::HEADLIGHT});
}

// Main window, and cameras within the view that have other sizes.
constexpr size_t kMostSurfaces = 4;

}  // namespace

SceneLights::SceneLights() = default;
SceneLights::SceneLights(const SceneLights& other, const osg::CopyOp& op) : osg::Object(other, op)
{
}
SceneLights::~SceneLights() = default;

Surfaces* surfacesOf(osgUtil::CullVisitor& visitor)
{
    const osg::Viewport* viewport = visitor.getViewport();
    if (!viewport) return nullptr;
    const int width = static_cast<int>(std::ceil(viewport->x() + viewport->width())),
              height = static_cast<int>(std::ceil(viewport->y() + viewport->height()));
    if (width < 1 || height < 1) return nullptr;
    auto& kept = sceneLights(visitor).surfaces;
    const auto found = std::find_if(kept.begin(), kept.end(), [&](const auto& surfaces) {
        return surfaces->fit(width, height, visitor.getState());
    });
    osg::ref_ptr<Surfaces> surfaces =
        found == kept.end() ? new Surfaces(width, height, visitor.getState()) : found->get();
    if (found != kept.end()) kept.erase(found);
    kept.insert(kept.begin(), surfaces);
    if (kept.size() > kMostSurfaces) kept.pop_back();
    return surfaces;
}

SceneLights& sceneLights(osgUtil::CullVisitor& visitor)
{
    osg::UserDataContainer* container = visitor.getOrCreateUserDataContainer();
    auto* scene = dynamic_cast<SceneLights*>(container->getUserObject(kKey));
    if (!scene) {
        scene = new SceneLights;
        scene->setName(kKey);
        container->addUserObject(scene);
    }
    const osg::NodePath& path = visitor.getNodePath();
    osg::Node* root = path[rootOf(path)];
    const unsigned int frame =
        visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
    if (scene->filled_ && visitor.getFrameStamp() && scene->root_ == root && scene->frame_ == frame)
        return *scene;
    scene->lights.clear();
    scene->plain.clear();
    scene->dropped = 0;
    scene->fallbackPlaced = false;
    // Not for another root: the visitor comes back from the cameras within a view.
    if (scene->frame_ != frame) scene->lastOwnBin = 0;
    scene->root_ = root;
    scene->frame_ = frame;
    scene->filled_ = true;
    Collector collector(*scene, visitor);
    root->accept(collector);
    findViewLight(*scene, visitor.getCurrentCamera());
    return *scene;
}

osg::Matrixd worldToEye(osgUtil::CullVisitor& visitor)
{
    return osg::Matrixd::inverse(osg::computeLocalToWorld(visitor.getNodePath())) *
           *visitor.getModelViewMatrix();
}

std::vector<fbrdf::Light> pointLightsInEye(const SceneLights& scene, const osg::Matrixd& toEye)
{
    std::vector<fbrdf::Light> lights;
    lights.reserve(scene.lights.size() + scene.plain.size());
    for (const fbrdf::Light& light : scene.lights) lights.push_back(moved(light, toEye));
    return lights;
}

bool isOn(const PlainLight& plain, const InheritedState& state)
{
    const int number = plain.light->getLightNum();
    return number < 0 || number >= kMostGlLights ||
           state.mode(GL_LIGHT0 + static_cast<GLenum>(number)).value_or(true);
}

namespace {

/// The same laws, but only the lights that were selected.
EyeLights selected(const EyeLights& from, const fbrdf::LightSelection& selection)
{
    EyeLights found;
    found.laws = from.laws;
    found.culled = from.culled + selection.culled;
    found.dropped = from.dropped + selection.dropped;
    for (const int index : selection.lights) {
        found.lights.push_back(from.lights[static_cast<size_t>(index)]);
        found.lawOf.push_back(from.lawOf[static_cast<size_t>(index)]);
    }
    return found;
}

}  // namespace

EyeLights lightsOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                   const InheritedState& state)
{
    EyeLights all;
    all.lights = pointLightsInEye(scene, toEye);
    all.lawOf.assign(all.lights.size(), -1);
    const osg::Vec3d centre = toOsg(bounds.centre);
    for (const PlainLight& plain : scene.plain) {
        if (!isOn(plain, state)) continue;
        const StandIn source = standIn(plain, toEye);
        const bool applied = source.hasLaw && all.laws.size() < kMostLaws;
        all.lights.push_back(applied ? source.light : approximated(source, centre));
        all.lawOf.push_back(applied ? static_cast<int>(all.laws.size()) : -1);
        if (applied) all.laws.push_back(source.law);
    }
    return selected(all, fbrdf::selectLights(all.lights, bounds, 0));
}

EyeLights strongest(const EyeLights& lights, const fbrdf::Sphere& bounds, int most)
{
    return selected(lights, fbrdf::selectLights(lights.lights, bounds, most));
}

}  // namespace osgFbrdf
