#include "ShadowPlacement.h"

#include "EffectInternals.h"
#include "Vectors.h"

#include <osg/Light>
#include <osg/TexGen>
#include <osgUtil/RenderStage>

#include <functional>
#include <optional>

namespace osgFbrdf {
namespace {

// Lights and maps take different ways to eye space, and floats are in some of them. So much of the
// distance, or of a right angle, may lie between them.
constexpr double kSamePlace = 1e-3;

using Container = osgUtil::PositionalStateContainer;

osg::Vec4d column(const osg::Matrixd& matrix, int i)
{
    return {matrix(0, i), matrix(1, i), matrix(2, i), matrix(3, i)};
}

osg::Vec3d directionOf(const osg::Vec4d& v)
{
    return {v.x(), v.y(), v.z()};
}

/// True where `place`, a point or with w = 0 a unit direction, lies in the plane, as seen from
/// `about`.
bool liesIn(const osg::Vec4d& plane, const osg::Vec4d& place, const osg::Vec3d& about)
{
    const osg::Vec3d normal = directionOf(plane);
    const double distance = place.w() == 0.0 ? 1.0 : (directionOf(place) - about).length();
    const double here = std::abs(plane * osg::Vec4d(about, 1.0));
    return std::abs(plane * place) <= kSamePlace * normal.length() * distance + 1e-6 * here;
}

/// True where the map is drawn from there. toMap: from eye space to the homogeneous coordinates of
/// the map.
bool isDrawnFrom(const osg::Matrixd& toMap, const osg::Vec4d& place, const osg::Vec3d& about)
{
    for (const int i : {0, 1, 3})
        if (!liesIn(column(toMap, i), place, about)) return false;
    if (place.w() != 0.0) return true;
    // The opposite direction is in the same planes: towards the light depths become smaller.
    const double nearness = column(toMap, 3) * osg::Vec4d(about, 1.0);
    return (column(toMap, 2) * place) * nearness < 0.0;
}

/// A point with w = 1, or a unit direction with w = 0.
osg::Vec4d unit(const osg::Vec4d& v)
{
    const double length = v.w() == 0.0 ? directionOf(v).length() : v.w();
    return length == 0.0 ? v : v / length;
}

osg::Vec4d placeOf(const fbrdf::Light& light)
{
    const bool isFar = light.type == fbrdf::Light::Type::directional;
    return {toOsg(light.position), isFar ? 0.0 : 1.0};
}

/// Calls use(attributes, after) for the state of the stage and for what it takes over from the
/// stage around it.
template <class Use>
void forEachContainer(osgUtil::RenderStage& stage, const Use& use)
{
    if (Container* around = stage.getInheritedPositionalStateContainer())
        use(*around, stage.getInheritedPositionalStateContainerMatrix());
    use(*stage.getPositionalStateContainer(), osg::Matrixd());
}

osg::Matrixd toEye(const osg::RefMatrix* matrix, const osg::Matrixd& after)
{
    return matrix ? *matrix * after : after;
}

/// From eye space to the coordinates that the last osg::TexGen of the unit generates; empty where
/// there is none.
std::optional<osg::Matrixd> toMapOf(osgUtil::RenderStage& stage, int unit)
{
    std::optional<osg::Matrixd> found;
    forEachContainer(stage, [&](Container& container, const osg::Matrixd& after) {
        const auto& units = container.getTexUnitAttrMatrixListMap();
        const auto list = units.find(static_cast<unsigned int>(unit));
        if (list == units.end()) return;
        for (const auto& [attribute, matrix] : list->second) {
            const auto* generator = dynamic_cast<const osg::TexGen*>(attribute.get());
            if (!generator || generator->getMode() != osg::TexGen::EYE_LINEAR) continue;
            osg::Matrixd planes;
            for (int c = 0; c < 4; ++c)
                for (unsigned int i = 0; i < 4; ++i)
                    planes(static_cast<int>(i), c) =
                        generator->getPlane(static_cast<osg::TexGen::Coord>(c))[i];
            found = osg::Matrixd::inverse(toEye(matrix.get(), after)) * planes;
        }
    });
    return found;
}

/// Where the osg::Light is that the map is drawn for: there, or somewhere else and shining in the
/// direction in which the map is drawn. Empty where there is none.
std::optional<osg::Vec4d> lightOfMap(osgUtil::RenderStage& stage, const osg::Matrixd& toMap,
                                     const osg::Vec3d& about)
{
    std::optional<osg::Vec4d> there, aimed;
    forEachContainer(stage, [&](Container& container, const osg::Matrixd& after) {
        for (const auto& [attribute, matrix] : container.getAttrMatrixList()) {
            const auto* light = dynamic_cast<const osg::Light*>(attribute.get());
            if (!light) continue;
            const osg::Matrixd placed = toEye(matrix.get(), after);
            const osg::Vec4d place = unit(osg::Vec4d(light->getPosition()) * placed);
            const osg::Vec3d axis(light->getDirection());
            const osg::Vec4d towards(-osg::Matrixd::transform3x3(axis, placed), 0.0);
            if (isDrawnFrom(toMap, place, about)) there = place;
            if (isDrawnFrom(toMap, unit(towards), about)) aimed = place;
        }
    });
    return there ? there : aimed;
}

}  // namespace

ShadowPlacement::ShadowPlacement(const ShadowMaps& maps, const std::vector<fbrdf::Light>& lights,
                                 const osg::Vec3d& about, osgUtil::RenderStage& stage,
                                 EffectInternals& internals)
    : maps_(maps),
      lights_(lights),
      about_(about),
      stage_(&stage),
      matrices_(new osg::Uniform(osg::Uniform::FLOAT_MAT4, "osgFbrdfShadowMatrices",
                                 static_cast<int>(maps.units.size()))),
      internals_(&internals)
{
}

ShadowPlacement::ShadowPlacement(const ShadowPlacement& other, const osg::CopyOp& op)
    : osg::StateAttribute(other, op),
      maps_(other.maps_),
      lights_(other.lights_),
      about_(other.about_),
      stage_(other.stage_),
      matrices_(other.matrices_),
      numbers_(other.numbers_),
      internals_(other.internals_)
{
}

int ShadowPlacement::compare(const osg::StateAttribute& other) const
{
    return this == &other ? 0 : std::less<>()(this, &other) ? -1 : 1;
}

void ShadowPlacement::place(osg::Uniform* numbers, int firstLight)
{
    Numbers placed{numbers, {}, static_cast<size_t>(firstLight)};
    placed.before.resize(numbers->getNumElements());
    for (size_t i = 0; i < placed.before.size(); ++i)
        numbers->getElement(static_cast<unsigned int>(i), placed.before[i]);
    numbers_.push_back(std::move(placed));
}

void ShadowPlacement::apply(osg::State&) const
{
    if (!stage_) return;
    std::vector<int> mapsOfLights(lights_.size(), 0);
    int stray = -1;
    for (unsigned int map = 0; map < maps_.units.size(); ++map)
        if (!addMap(map, mapsOfLights)) stray = maps_.units[map];
    internals_->strayShadowMap = stray;
    for (const Numbers& numbers : numbers_)
        for (size_t i = 0; i < numbers.before.size(); ++i)
            numbers.uniform->setElement(
                static_cast<unsigned int>(i),
                numbers.before[i] + kShadowBit * mapsOfLights[numbers.firstLight + i]);
}

bool ShadowPlacement::addMap(unsigned int map, std::vector<int>& mapsOfLights) const
{
    const auto toMap = toMapOf(*stage_, maps_.units[map]);
    if (!toMap) return true;  // no light casts shadows, or fewer than could
    matrices_->setElement(map, osg::Matrixf(*toMap));
    const auto addAt = [&](const auto& isThere) {
        bool any = false;
        for (size_t i = 0; i < lights_.size(); ++i) {
            if (!isThere(placeOf(lights_[i]))) continue;
            mapsOfLights[i] |= 1 << map;
            any = true;
        }
        return any;
    };
    if (addAt([&](const osg::Vec4d& place) { return isDrawnFrom(*toMap, place, about_); }))
        return true;
    // The light may also be off here, or out of reach.
    const auto light = lightOfMap(*stage_, *toMap, about_);
    if (!light) return false;
    const double distance = (directionOf(*light) - about_).length();
    addAt([&](const osg::Vec4d& place) {
        return place.w() == light->w() &&
               (directionOf(place) - directionOf(*light)).length() <= kSamePlace * distance;
    });
    return true;
}

}  // namespace osgFbrdf
