// Document.h - all that can be changed in the window, as one value: what is drawn, lit by what,
// seen from where, and how. Undo is another value (History.h), a scene on disk is one
// (viewer/SceneFile.h), and the world is brought in line with it.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/CompareView.h>
#include <fbrdf/scene/Environment.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/ViewTechnique.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::scene {

constexpr int kMostLights = 65536;  ///< that are made by number
constexpr int kMostSamples = 1 << 20;

/// A material, and how it is fitted where it is no material already.
struct SceneMaterial {
    std::string source;                     ///< a material file, or a file or model to fit
    std::string form = "auto";              ///< as FitOptions::form
    int resolution = 0;                     ///< texels; 0: the form's own
    std::optional<double> smoothness = {};  ///< > 0; unset: by the error held out
    int kilobytes = 0;                      ///< no material larger than this; 0: no limit
    /// Of those that a program has loaded, -1: not loaded yet. No part of what a material is, and
    /// not stored.
    int slot = -1;

    bool operator==(const SceneMaterial& other) const;
};

/// What lights the scene beside its environment: so many lights that are made (makeLights), or a
/// list.
struct SceneLights {
    int made = 0;  ///< 0: those of the list
    uint32_t seed = 0;
    LightSet list;

    bool operator==(const SceneLights& other) const;
};

struct SceneEnvironment {
    std::string name;        ///< a file, or a built-in one; empty: none
    float degrees = 0.0f;    ///< about +y
    float intensity = 1.0f;  ///< factor of its radiance, >= 0
    int lobes = 0;           ///< that are drawn at most; 0: all that a material has
    int samples = 0;         ///< directions that are drawn by them; 0: lobes are looked up

    bool operator==(const SceneEnvironment& other) const;
};

/// As in gl::DrawOptions; 0: no limit but the technique's own.
struct DrawLimits {
    int lookups = 0, lights = 0;
    int lightsPerPass = 8;  ///< of `batched`, >= 1

    bool operator==(const DrawLimits& other) const;
};

/// What goes on by itself, and what the window's border says: no step of undo.
struct Moment {
    double tableDegrees = 0.0;   ///< by which objects and ground are turned about +y
    double lightsDegrees = 0.0;  ///< by which the lights are turned about the objects
    int width = 0, height = 0;   ///< pixels of the picture; 0: as the program chooses

    bool operator==(const Moment& other) const;
};

struct Document {
    std::vector<SceneMaterial> materials;
    int shown = -1;               ///< of the materials; -1: all, side by side
    std::string mesh = "sphere";  ///< as meshFromName takes it
    SceneLights lights;
    SceneEnvironment environment;
    Background background;
    std::optional<Camera> camera;  ///< unset: one that suits the objects
    ViewTechnique technique = viewTechnique(Technique::single);
    LookUp lookUp = LookUp::native;
    bool precise = false;  ///< maps are filtered in the shader
    DrawLimits limits;
    /// Of the surface that the runtime draws to: RGBA32F, RGBA16F or RGBA8, which ends at 1.
    ColourFormat target = ColourFormat::rgba32f;
    bool ground = false, shadows = false, toneMap = false;
    int samples = 1;       ///< of a pixel
    int pathSamples = 64;  ///< of a pixel, of ViewTechnique::path: enough to see what it will be
    bool spread = false;   ///< those of `path` lie all over the pixel, not in its middle
    float exposure = 1.0f;
    bool turning = false;   ///< the turntable turns
    bool orbiting = false;  ///< the lights turn about the objects
    Comparison compare;
    Moment moment;

    bool operator==(const Document& other) const;
};

/// The material that is shown alone, null where all are or there is none.
const SceneMaterial* shownMaterial(const Document& document);
SceneMaterial* shownMaterial(Document& document);

/// Samples of a pixel that a technique takes.
int samplesOf(const Document& document, ViewTechnique technique);

/// How radiance becomes sRGB in files and in the window.
inline Transfer transferOf(const Document& document)
{
    return document.toneMap ? Transfer::toneMap : Transfer::srgb;
}

/// The lights of a scene whose objects are in a ball, before they orbit.
LightSet lightsOf(const SceneLights& lights, const Bounds& bounds);

}  // namespace fbrdf::scene
