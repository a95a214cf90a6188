#include <fbrdf/scene/Document.h>
#include <fbrdf/scene/Layout.h>

#include <tuple>
#include <utility>

namespace fbrdf::scene {
namespace {

auto valuesOf(const SceneMaterial& m)
{
    return std::tie(m.source, m.form, m.resolution, m.smoothness, m.kilobytes);
}

auto valuesOf(const SceneEnvironment& e)
{
    return std::tie(e.name, e.degrees, e.intensity, e.lobes, e.samples);
}

auto valuesOf(const DrawLimits& l)
{
    return std::tie(l.lookups, l.lights, l.lightsPerPass);
}

auto valuesOf(const Moment& m)
{
    return std::tie(m.tableDegrees, m.lightsDegrees, m.width, m.height);
}

bool isSame(const Background& a, const Background& b)
{
    return a.environment == b.environment && a.colour == b.colour;
}

bool isSame(const std::optional<Camera>& a, const std::optional<Camera>& b)
{
    if (!a || !b) return a.has_value() == b.has_value();
    return a->eye == b->eye && a->centre == b->centre && a->fovy == b->fovy;
}

}  // namespace

bool SceneMaterial::operator==(const SceneMaterial& other) const
{
    return valuesOf(*this) == valuesOf(other);
}

bool SceneLights::operator==(const SceneLights& other) const
{
    return made == other.made && seed == other.seed && list == other.list;
}

bool SceneEnvironment::operator==(const SceneEnvironment& other) const
{
    return valuesOf(*this) == valuesOf(other);
}

bool DrawLimits::operator==(const DrawLimits& other) const
{
    return valuesOf(*this) == valuesOf(other);
}

bool Moment::operator==(const Moment& other) const
{
    return valuesOf(*this) == valuesOf(other);
}

bool Document::operator==(const Document& o) const
{
    return materials == o.materials && shown == o.shown && mesh == o.mesh && lights == o.lights &&
           environment == o.environment && isSame(background, o.background) &&
           isSame(camera, o.camera) && technique == o.technique && lookUp == o.lookUp &&
           precise == o.precise && limits == o.limits && target == o.target && ground == o.ground &&
           shadows == o.shadows && toneMap == o.toneMap && samples == o.samples &&
           pathSamples == o.pathSamples && spread == o.spread && exposure == o.exposure &&
           turning == o.turning && orbiting == o.orbiting && compare == o.compare &&
           moment == o.moment;
}

const SceneMaterial* shownMaterial(const Document& document)
{
    const auto place = static_cast<size_t>(document.shown);
    return document.shown >= 0 && place < document.materials.size() ? &document.materials[place]
                                                                    : nullptr;
}

SceneMaterial* shownMaterial(Document& document)
{
    return const_cast<SceneMaterial*>(shownMaterial(std::as_const(document)));
}

int samplesOf(const Document& document, ViewTechnique technique)
{
    return technique == ViewTechnique::path ? document.pathSamples : document.samples;
}

LightSet lightsOf(const SceneLights& lights, const Bounds& bounds)
{
    if (lights.made == 0) return lights.list;
    return {spreadAround(makeLights(lights.made, lights.seed), bounds), {}};
}

}  // namespace fbrdf::scene
