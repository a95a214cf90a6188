#include "Options.h"

#include "CommandLine.h"
#include "CompareSide.h"
#include "OptionTexts.h"
#include "World.h"

#include <fbrdf/base/ClassicLocale.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/codecs/AnimationFile.h>
#include <fbrdf/codecs/PictureFile.h>
#include <fbrdf/environment/SampledLight.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/scene/Image.h>
#include <fbrdf/scene/KeyLights.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr int kFullSamples = 16;  // edges have 16 grades
// A white matt surface that faces the key light, under the studio as well, sends 2: this exposure
// and the tone curve bring that to 0.59, and leave highlights room.
constexpr float kFullExposure = 0.6f;
constexpr int kPlainLights = 5;
constexpr int kMostTurntableFrames = 1000;
constexpr int kWindowWidth = 1280, kWindowHeight = 800;

/// A window may change to `path` later.
void checkPath(const Options& options)
{
    if (!options.headless || options.document.technique == scene::ViewTechnique::path) return;
    if (options.bounces)
        throw Error(ErrorKind::usage, "--bounces",
                    Found("it with --technique " +
                          std::string(viewTechniqueName(options.document.technique)))
                        .expected("--technique path"));
}

/// What an environment is asked for must have one.
void checkEnvironment(const CLI::App& app, const Options& options)
{
    if (!options.document.environment.name.empty()) return;
    for (const char* option : {"--environment-rotation", "--environment-intensity",
                               "--environment-lobes", "--environment-samples"})
        if (app.count(option) > 0)
            throw Error(ErrorKind::usage, option,
                        Found("no environment").expected("--environment as well"));
    if (options.document.background.environment)
        throw Error(ErrorKind::usage, "--background",
                    Found("environment without one").expected("--environment as well"));
}

/// Throws Error(usage) for a comparison that cannot be.
void checkComparison(const CLI::App& app, const Options& options)
{
    for (const std::string& side : options.compare) compareSideFromName(side);
    if (options.compare.empty())
        for (const char* option : {"--compare-mode", "--compare-at", "--compare-gain"})
            if (app.count(option) > 0)
                throw Error(ErrorKind::usage, option,
                            Found("nothing to compare").expected("--compare A B as well"));
    const bool isSheet = options.command == Command::compare;
    if (isSheet && app.count("--compare") > 0)
        throw Error(ErrorKind::usage, "--compare", Found("it with a sheet").expected("--side"));
    if (isSheet && options.compare.size() == 1)
        throw Error(ErrorKind::usage, "--side", Found("one").expected("at least two"));
    if (options.compare.empty() && !isSheet) return;
    if (options.command != Command::view && !isSheet)
        throw Error(ErrorKind::usage, "--compare",
                    Found("it with a subcommand").expected("it with a single picture"));
    if (options.headless && options.document.materials.size() > 1)
        throw Error(ErrorKind::usage, "--compare",
                    Found(std::to_string(options.document.materials.size()) + " materials")
                        .expected("one"));
}

/// What a scene compares is compared, in the ways that nothing else was asked for.
void takeComparison(const CLI::App& app, Options& options)
{
    const scene::Comparison& compare = options.document.compare;
    if (options.command != Command::view) return;
    if (options.compare.empty() && compare.on) options.compare = {compare.a, compare.b};
    if (app.count("--compare-mode") == 0) options.compareMode = compare.mode;
    if (app.count("--compare-at") == 0) options.compareAt = static_cast<double>(compare.at);
    if (app.count("--compare-gain") == 0) options.compareGain = static_cast<double>(compare.gain);
}

/// Writes into the document what is compared.
void giveComparison(Options& options)
{
    scene::Comparison& compare = options.document.compare;
    if (options.compare.size() != 2) return;
    compare = {true,
               options.compareMode,
               options.compare[0],
               options.compare[1],
               static_cast<float>(options.compareAt),
               static_cast<float>(options.compareGain),
               compare.holds};
}

/// Fills in what the full scene has and nobody asked for otherwise.
void completeScene(const Texts& texts, Options& options)
{
    // Figures are compared pixel by pixel with what their lights alone do.
    const bool isFullByItself =
        options.command == Command::view ? !options.headless : options.command != Command::figures;
    scene::Document& document = options.document;
    std::string& environment = document.environment.name;
    const bool noEnvironment = environment == "none";
    if (noEnvironment) environment.clear();
    if (noEnvironment && texts.background.empty()) document.background.environment = false;
    options.full = texts.full || (isFullByItself && !texts.plain && options.scene.empty());
    if (!options.full) return;
    document.ground = document.shadows = document.toneMap = document.spread = true;
    document.samples = kFullSamples;
    document.exposure = kFullExposure;
    document.turning = !options.headless && !options.frames;
    if (options.command == Command::sheet && environment.empty() && !noEnvironment &&
        options.lights.empty() && options.under.empty())
        options.under = proceduralEnvironments();
    if (environment.empty() && !noEnvironment) environment = proceduralEnvironments().front();
    if (texts.background.empty()) document.background.environment = !noEnvironment;
}

/// What is given with another name than that of a document's field.
void completeDocument(const Texts& texts, Options& options)
{
    scene::Document& document = options.document;
    if (!texts.materials.empty()) {
        document.materials.clear();
        document.shown = -1;
    }
    for (const std::string& source : texts.materials)
        document.materials.push_back({source, texts.form});
    if (options.command == Command::figures)
        options.figureForm = texts.form;
    else if (document.materials.empty())
        document.materials.push_back(defaultMaterial(texts.form));
    // Without a window nobody asks for those that a scene does not show.
    if (const scene::SceneMaterial* const shown = shownMaterial(document);
        shown && options.headless) {
        document.materials = {scene::SceneMaterial(*shown)};
        document.shown = 0;
    }
    for (size_t i = 0; i < document.materials.size(); ++i)
        document.materials[i].slot = static_cast<int>(i);
    if (texts.lightCount)
        document.lights = {*texts.lightCount, document.lights.seed, {}};
    else if (options.full)
        document.lights.list.lights = scene::keyLights();
    else if (options.scene.empty())
        document.lights.made = kPlainLights;
    if (texts.samples) {
        document.samples = document.pathSamples = *texts.samples;
        document.spread = true;
    }
    if (texts.exposure) document.exposure = *texts.exposure;
    if (!texts.background.empty())
        document.background = scene::backgroundFromText(texts.background);
}

/// Throws Error(usage) unless a path suits what a command writes.
void checkOut(const Options& options)
{
    if (options.command != Command::view && options.out.empty())
        throw Error(ErrorKind::usage, "-o", Found("none").expected("a path to write to"));
    if (options.out.empty()) return;
    const bool isFolder = !std::filesystem::path(options.out).has_extension();
    if (options.command == Command::figures) {
        if (isFolder) return;
        throw Error(ErrorKind::usage, "-o",
                    Found("'" + options.out + "'").expected("a folder without a dot"));
    }
    if (options.command == Command::view && options.comparesMoving() &&
        isAnimationPath(options.out))
        return requirePictureModule(ErrorKind::output, options.out);
    if (options.command != Command::turntable) return scene::checkImagePath(options.out);
    if (!isFolder && !isAnimationPath(options.out))
        throw Error(ErrorKind::usage, "-o",
                    Found("'" + options.out + "'")
                        .expected("FILE.gif, FILE.webp or a folder without a dot"));
    if (!isFolder) requirePictureModule(ErrorKind::output, options.out);
}

void checkCommand(const Options& options)
{
    if (options.command == Command::view) return;
    if (!options.scene.empty())
        throw Error(ErrorKind::usage, "--scene",
                    Found("it with a subcommand").expected("it with a single picture"));
    if (!options.stats.empty() && options.command != Command::compare)
        throw Error(ErrorKind::usage, "--stats",
                    Found("it with a subcommand").expected("it with a single picture"));
    const bool isTurntable = options.command == Command::turntable;
    if (options.frames && (!isTurntable || *options.frames > kMostTurntableFrames))
        throw Error(ErrorKind::usage, "--frames",
                    Found(std::to_string(*options.frames)).expected("up to 1000, of a turntable"));
    if (options.command == Command::figures && !options.document.materials.empty())
        throw Error(ErrorKind::usage, "figures",
                    Found("--material").expected("the materials of the figures alone"));
    if (options.command == Command::figures && options.width != options.height)
        throw Error(ErrorKind::usage, "--size",
                    Found(std::to_string(options.width) + "x" + std::to_string(options.height))
                        .expected("as many pixels up as across, of figures"));
    if (isTurntable && options.document.materials.size() != 1)
        throw Error(ErrorKind::usage, "turntable",
                    Found(std::to_string(options.document.materials.size()) + " materials")
                        .expected("one"));
}

Size sizeOf(const Texts& texts, const Options& options)
{
    if (!texts.size.empty()) return sizeFromText(texts.size);
    const scene::Moment& moment = options.document.moment;
    if (moment.width > 0) return {moment.width, moment.height};
    switch (options.command) {
        case Command::sheet:
        case Command::compare: return {320, 320};
        case Command::turntable: return {480, 480};
        case Command::figures:
        case Command::view: break;
    }
    return options.headless ? Size{512, 512} : Size{kWindowWidth, kWindowHeight};
}

void understand(const Texts& texts, Options& options)
{
    if (!texts.backend.empty()) options.backend = backendFromName(texts.backend);
    if (!texts.backend.empty() && !options.headless)
        throw Error(ErrorKind::usage, "--backend",
                    Found("it with a window").expected("--headless as well"));
    if (texts.device == "list") options.listDevices = true;
    if (!options.listDevices) options.device = deviceFromText(texts.device);
    if (options.device && (!options.headless || options.backend != Backend::egl))
        throw Error(ErrorKind::usage, "--device",
                    Found("it without --headless, or with osmesa").expected("both, with egl"));
    if (!texts.technique.empty())
        options.document.technique = scene::viewTechniqueFromName(texts.technique);
    if (!texts.compareMode.empty())
        options.compareMode = scene::compareModeFromName(texts.compareMode);
    checkPath(options);
    if (!texts.lookUp.empty()) options.document.lookUp = lookUpFromName(texts.lookUp);
    if (!texts.camera.empty()) options.document.camera = scene::cameraFromText(texts.camera);
    const Size size = sizeOf(texts, options);
    options.width = size.width;
    options.height = size.height;
    completeScene(texts, options);
    completeDocument(texts, options);
    for (const float number :
         {options.document.environment.degrees, options.document.environment.intensity})
        if (!std::isfinite(number))
            throw Error(ErrorKind::usage, "--environment-rotation, --environment-intensity",
                        Found("no finite number").expected("one"));
    if (!std::isfinite(options.document.exposure))
        throw Error(ErrorKind::usage, "--exposure", Found("no finite number").expected("one > 0"));
    checkCommand(options);
    checkOut(options);
}

}  // namespace

Options optionsFromArguments(int argc, const char* const* argv)
{
    const ClassicLocale numbers;
    Options options;
    Texts texts;
    CLI::App app(
        "Draws factored materials under any number of lights, and the references that they are "
        "compared with",
        "fbrdf-viewer");
    describeOptions(app, options, texts);
    const auto* devices =
        app.add_subcommand("list-devices", "Prints what --device can choose, a line each");
    const auto* sheet = describeSheet(app, options, texts);
    const auto* turntable = describeTurntable(app, texts);
    const auto* compare = describeCompareSheet(app, texts);
    const auto* figures = describeFigures(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        const auto used = app.get_subcommands();
        options.help = used.empty() ? app.help() : used.front()->help(app.get_name());
        return options;
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::usage, "command line", error.what());
    }
    if (devices->parsed()) texts.device = "list";
    if (sheet->parsed()) options.command = Command::sheet;
    if (turntable->parsed()) options.command = Command::turntable;
    if (compare->parsed()) {
        options.command = Command::compare;
        options.compare = texts.sides;
    }
    if (figures->parsed()) options.command = Command::figures;
    if (options.command != Command::view) options.headless = true;
    takeComparison(app, options);
    understand(texts, options);
    checkEnvironment(app, options);
    checkComparison(app, options);
    giveComparison(options);
    options.drawsEnvironment = options.command == Command::compare || !options.compare.empty() ||
                               (!options.headless && !options.frames);
    return options;
}

}  // namespace fbrdf::viewer
