// SampleDocument.h - a document whose every field differs from the one that a document begins with.
#pragma once
#include <fbrdf/scene/Document.h>

namespace fbrdf::scene {

inline LightSet oneLightOfEachKind()
{
    LightSet set;
    set.lights.resize(3);
    set.lights[0].position = {0.1f, 2.0f, -3.3f};
    set.lights[0].radius = 7.7f;
    set.lights[1].type = Light::Type::directional;
    set.lights[1].position = {0.0f, 0.6f, 0.8f};
    set.lights[2].type = Light::Type::spot;
    set.lights[2].innerAngle = 0.0f;
    set.lights[2].outerAngle = 0.5f;
    for (const auto shape : {AreaLight::Shape::sphere, AreaLight::Shape::rectangle}) {
        AreaLight light;
        light.shape = shape;
        light.position = {1.0f / 3.0f, 1.0f, 2.0f};
        set.areaLights.push_back(light);
    }
    return set;
}

inline Document sampleDocument()
{
    Document document;
    document.materials.resize(2);
    document.materials[0].source = "paint.fbrdf";
    document.materials[1].source = "ggx:alpha=0.3";
    document.materials[1].form = "hdio";
    document.materials[1].resolution = 24;
    document.materials[1].smoothness = 1.0 / 3.0;
    document.materials[1].kilobytes = 8;
    document.shown = 1;
    document.mesh = "knot";
    document.lights.list = oneLightOfEachKind();
    document.environment = {"studio", 33.3f, 0.7f, 2, 64};
    document.background.environment = true;
    document.camera = Camera{{0.1, 0.2, 5.0}, {0.0, 0.3, 0.0}, 0.5};
    document.technique = viewTechnique(Technique::batched);
    document.lookUp = LookUp::cube;
    document.precise = true;
    document.limits = {2, 100, 4};
    document.target = ColourFormat::rgba16f;
    document.ground = document.shadows = document.toneMap = true;
    document.samples = 16;
    document.pathSamples = 32;
    document.spread = true;
    document.exposure = 0.6f;
    document.turning = document.orbiting = true;
    document.compare = {true, CompareMode::difference, "paint.fbrdf", "hdio", 0.3f, 4.0f, true};
    document.moment = {12.5, 33.0, 640, 480};
    return document;
}

}  // namespace fbrdf::scene
