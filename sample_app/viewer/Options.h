// Options.h - the command line of fbrdf-viewer.
#pragma once
#include <fbrdf/headless/Context.h>
#include <fbrdf/scene/CompareView.h>
#include <fbrdf/scene/Document.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// What is made: a picture or a window, a sheet of pictures, a turning picture, a sheet of the
/// sides of a comparison, or the figures of the paper.
enum class Command { view, sheet, turntable, compare, figures };

struct Options {
    Command command = Command::view;
    /// Of a sheet: environments or files of lights, one a column.
    std::vector<std::string> under;
    bool headless = false;
    Backend backend = Backend::egl;
    std::optional<int> device;  ///< of headlessDevices()
    bool listDevices = false;   ///< nothing else is asked for
    std::string scene;          ///< path of the scene that the document began as; empty: none
    scene::Document document;   ///< what is drawn; with a window, what it begins with
    std::string lights;         ///< path; what is in there takes the place of document.lights
    std::string browse;  ///< folder whose materials a window lists; empty: that of the first one
    std::string figureForm;      ///< of Command::figures
    bool full = false;           ///< the full scene: its camera looks from above
    std::optional<int> bounces;  ///< of `path`; unset: as PathOptions
    /// `reference` draws directions to an environment at random, as `path`, and takes as many
    /// samples; false: it sums over all texels, which takes minutes.
    bool drawsEnvironment = false;
    int width = 512, height = 512;  ///< of a window unless told: 1280 x 800
    /// Two sides (CompareSide.h), or none; of Command::compare at least two, or none for the usual.
    std::vector<std::string> compare;
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

/// True where a technique draws directions at random, so that its pictures have noise.
inline bool isRandom(const Options& options, scene::ViewTechnique technique)
{
    return technique == scene::ViewTechnique::path ||
           (technique == scene::ViewTechnique::reference && options.drawsEnvironment &&
            !options.document.environment.name.empty());
}

/// Samples of a pixel that a technique takes.
inline int samplesOf(const Options& options, scene::ViewTechnique technique)
{
    return samplesOf(options.document,
                     isRandom(options, technique) ? scene::ViewTechnique::path : technique);
}

/// Throws Error(usage) for everything that --help does not allow.
Options optionsFromArguments(int argc, const char* const* argv);

}  // namespace fbrdf::viewer
