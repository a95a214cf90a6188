// Options.h - the command line of fbrdf-viewer.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>
#include <fbrdf/headless/Context.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/CompareView.h>
#include <fbrdf/scene/Controls.h>
#include <fbrdf/scene/Environment.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// What is made: a picture or a window, a sheet of pictures, a turning picture, or the figures of
/// the paper.
enum class Command { view, sheet, turntable, figures };

struct Options {
    Command command = Command::view;
    std::vector<std::string> under;  ///< of a sheet: environments or files of lights, one a column
    bool headless = false;
    Backend backend = Backend::egl;
    std::optional<int> device;           ///< of headlessDevices()
    bool listDevices = false;            ///< nothing else is asked for
    std::vector<std::string> materials;  ///< files or sources; empty: the default material
    std::string form = "auto";           ///< in which sources are fitted
    std::string mesh = "sphere";
    std::string lights;             ///< path; empty: lightCount made ones
    std::optional<int> lightCount;  ///< made ones; unset: key lights in a full scene, else 5
    uint32_t seed = 0;
    std::string environment;           ///< a file, or the name of a built-in one; empty: none
    double environmentRotation = 0.0;  ///< degrees about +y
    double environmentIntensity = 1.0;
    int environmentLobes = 0;    ///< 0: all that a material has
    int environmentSamples = 0;  ///< directions that are drawn by them; 0: lobes are looked up
    scene::Background background;
    scene::ViewTechnique technique = scene::viewTechnique(Technique::single);
    LookUp lookUp = LookUp::native;
    bool precise = false;  ///< filtered in the shader
    bool full = false;     ///< the full scene: what is not asked for otherwise is as below
    bool ground = false, shadows = false, toneMap = false;  ///< on in a full scene
    std::optional<int> samples;                             ///< a pixel; unset: see samplesOf
    std::optional<int> bounces;                             ///< of `path`; unset: as PathOptions
    std::optional<scene::Camera> camera;
    int width = 512, height = 512;  ///< of a window unless told: 1280 x 800
    float exposure = 1.0f;
    std::vector<std::string> compare;  ///< two sides (CompareSide.h), or none
    scene::CompareMode compareMode = scene::CompareMode::split;
    double compareAt = 0.5, compareGain = 8.0;  ///< of split and wipe, and of difference
    std::string out, stats;                     ///< paths; empty: nothing is written
    /// Unset: 1 headless, until closed in a window; of a turntable kTurntableFrames.
    std::optional<int> frames;
    /// A comparison that can be a film.
    bool comparesMoving() const
    {
        return !compare.empty() &&
               (compareMode == scene::CompareMode::flip || compareMode == scene::CompareMode::wipe);
    }
    std::string help;  ///< not empty: --help was asked for, and this is the answer
};

constexpr int kTurntableFrames = 60;

/// Samples a pixel that a technique takes: as asked for, else 16 in a full scene and 1 in a plain
/// one; of `path` 64, in a plain scene all at the pixel's centre.
int samplesOf(const Options& options, scene::ViewTechnique technique);

/// How radiance becomes sRGB in files and in the window.
inline Transfer transferOf(const Options& options)
{
    return options.toneMap ? Transfer::toneMap : Transfer::srgb;
}

/// Throws Error(usage) for everything that --help does not allow.
Options optionsFromArguments(int argc, const char* const* argv);

}  // namespace fbrdf::viewer
