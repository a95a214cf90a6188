#include "EyeLights.h"

#include "GlLights.h"
#include "InheritedState.h"
#include "Vectors.h"

#include <fbrdf/base/Assert.h>

namespace osgFbrdf {
namespace {

/// The lights that were selected, with the same attenuations.
EyeLights selected(const EyeLights& from, const fbrdf::LightSelection& selection)
{
    EyeLights found;
    found.attenuations = from.attenuations;
    found.culled = from.culled + selection.culled;
    found.dropped = from.dropped + selection.dropped;
    for (const int index : selection.lights) {
        found.lights.push_back(from.lights[static_cast<size_t>(index)]);
        found.attenuationOf.push_back(from.attenuationOf[static_cast<size_t>(index)]);
    }
    return found;
}

/// Adds the light; one that comes after all attenuations are taken is approximated at `centre`.
void add(EyeLights& lights, const ConvertedLight& source, const osg::Vec3d& centre)
{
    const bool applied =
        source.isAttenuated && lights.attenuations.size() < static_cast<size_t>(kMostAttenuations);
    lights.lights.push_back(applied ? source.light : approximatedAt(centre, source));
    lights.attenuationOf.push_back(applied ? static_cast<int>(lights.attenuations.size())
                                           : kNotAttenuated);
    if (applied) lights.attenuations.push_back(source.attenuation);
}

}  // namespace

bool isOn(const PlacedOsgLight& source, const InheritedState& state)
{
    const int number = source.light->getLightNum();
    return number < 0 || number >= kMostGlLights ||
           state.mode(GL_LIGHT0 + static_cast<GLenum>(number)).value_or(true);
}

std::vector<fbrdf::Light> pointLightsInEye(const SceneLights& scene, const osg::Matrixd& toEye)
{
    std::vector<fbrdf::Light> lights;
    lights.reserve(scene.lights.size() + scene.sources.size());
    for (const fbrdf::Light& light : scene.lights) lights.push_back(moved(light, toEye));
    return lights;
}

EyeLights lightsOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                   const InheritedState& state, bool withSpare)
{
    EyeLights all;
    all.lights = pointLightsInEye(scene, toEye);
    all.attenuationOf.assign(all.lights.size(), kNotAttenuated);
    for (const PlacedOsgLight& source : scene.sources)
        if (isOn(source, state)) add(all, converted(source, toEye), toOsg(bounds.centre));
    if (withSpare && scene.spare && isOn(*scene.spare, state))
        add(all, converted(*scene.spare, toEye), toOsg(bounds.centre));
    return selected(all, fbrdf::selectLights(all.lights, bounds, 0));
}

EyeLights strongest(const EyeLights& lights, const fbrdf::Sphere& bounds, int most)
{
    FBRDF_ASSERT(most, >, 0);
    return selected(lights, fbrdf::selectLights(lights.lights, bounds, most));
}

}  // namespace osgFbrdf
