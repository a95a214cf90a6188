#include "Options.h"

#include "CommandLine.h"
#include "CompareSide.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/codecs/AnimationFile.h>
#include <fbrdf/codecs/PictureFile.h>
#include <fbrdf/environment/SampledLight.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/scene/Image.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr int kMostLights = 65536;
constexpr int kMostSamples = 1 << 20, kMostBounces = 1000;
constexpr int kFullSamples = 16;  // edges have 16 grades
// A white matt surface that faces the key light, under the studio as well, sends 2: this exposure
// and the tone curve bring that to 0.59, and leave highlights room.
constexpr float kFullExposure = 0.6f;
constexpr int kPathSamples = 64;  // enough to see what a picture will be
constexpr int kMostTurntableFrames = 1000;
constexpr int kWindowWidth = 1280, kWindowHeight = 800;

/// Texts that CLI11 fills in, to be interpreted afterwards.
struct Texts {
    std::string backend, device, technique, lookUp, camera, size, background, compareMode;
    bool plain = false, full = false;
    std::optional<float> exposure;
};

void describeEnvironment(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--environment", options.environment,
                   "Light from everywhere, beside the other lights: a panorama, built-in " +
                       fmt::format("{}", fmt::join(proceduralEnvironments(), ", ")) + ", or none")
        ->type_name("FILE.exr|FILE.hdr|NAME");
    app.add_option("--environment-rotation", options.environmentRotation,
                   "Degrees by which it is turned about +y");
    app.add_option("--environment-intensity", options.environmentIntensity,
                   "Factor of its radiance")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--environment-lobes", options.environmentLobes,
                   "Lobes that are drawn, at most: 1, 2 or 3 (default: all that a material has)")
        ->check(CLI::Range(1, kMostTiltedLobes));
    app.add_option(
           "--environment-samples", options.environmentSamples,
           "Directions for each pixel that are drawn by the lobes, instead of looking those "
           "up: 64 in soft light, hundreds where lamps are small; 0: none (default)")
        ->check(CLI::Range(0, kMostSamples));
    app.add_option(
        "--background", texts.background,
        "What is seen behind the objects: environment, R,G,B (linear), or none (default)");
}

void describeStage(CLI::App& app, Options& options, Texts& texts)
{
    app.add_flag("--ground", options.ground,
                 "A matt plane below the objects that takes their shadows");
    app.add_flag("--shadows", options.shadows,
                 "Shadows of the strongest lights, up to four, on objects and ground");
    app.add_flag("--tone-map", options.toneMap,
                 "Compresses highlights in sRGB files and in the window instead of cutting them");
    auto* full = app.add_flag(
        "--full", texts.full,
        "The full scene, as in a window: environment studio as light and background, key lights, "
        "ground, shadows, tone mapping, 16 samples; every option given changes its part");
    app.add_flag("--plain", texts.plain,
                 "The bare scene, as without a window: black, no ground, no environment, one "
                 "sample; every option given adds its part")
        ->excludes(full);
}

void describeScene(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--material", options.materials,
                   "A material (.fbrdf, 2001 layout), or reflectance to fit first: a file or a "
                   "model like ggx:alpha=0.2. Repeatable: one object each")
        ->type_name("FILE|SOURCE")
        ->allow_extra_args(false);
    app.add_option("--form", options.form, "Form of the fit where a source is given")
        ->capture_default_str();
    app.add_option("--mesh", options.mesh, "sphere, knot, plane or an OBJ file")
        ->type_name("NAME|FILE.obj")
        ->capture_default_str();
    auto* file = app.add_option("--lights", options.lights, "Lights from a file");
    file->type_name("FILE.json");
    auto* count =
        app.add_option("--light-count", options.lightCount,
                       "Number of point lights to make (default: 5; two key lights in the full "
                       "scene)");
    count->excludes(file)->check(CLI::Range(0, kMostLights));
    app.add_option("--seed", options.seed, "Seed of the lights that are made")->excludes(file);
    describeEnvironment(app, options, texts);
    describeStage(app, options, texts);
    app.add_option("--camera", texts.camera, "Eye, centre and vertical field of view")
        ->type_name("ex,ey,ez,cx,cy,cz,fovy_degrees");
}

void describePicture(CLI::App& app, Options& options, Texts& texts)
{
    app.add_flag("--headless", options.headless, "No window, no display");
    app.add_option("--backend", texts.backend,
                   "How to get GL without a display: egl (default) or osmesa");
    app.add_option("--device", texts.device, deviceHelp())->type_name("N|list");
    app.add_option("--technique", texts.technique, scene::viewTechniqueHelp());
    app.add_option("--samples", options.samples,
                   "Samples a pixel, spread over it (default: 1, 16 in the full scene; of "
                   "--technique path 64)")
        ->check(CLI::Range(1, kMostSamples));
    app.add_option("--bounces", options.bounces,
                   "Bounces between surfaces, at most, of --technique path (default: 8)")
        ->check(CLI::Range(0, kMostBounces));
    app.add_option(
        "--look-up", texts.lookUp,
        "How maps over one direction are looked up: native (default), or recombined into "
        "parabolic or cube maps");
    app.add_flag("--precise", options.precise,
                 "Filter maps in the shader: slower, and as fine as floats where a GPU knows 256 "
                 "places between two texels");
    app.add_option("--size", texts.size,
                   "Pixels (default 512x512; 1280x800 in a window, 320x320 of each picture of a "
                   "sheet, 480x480 of a turntable)")
        ->type_name("WxH");
    app.add_option("--exposure", texts.exposure,
                   "Factor of the radiance in sRGB files and in the window (default: 1, 0.6 in "
                   "the full scene)")
        ->check(CLI::PositiveNumber);
    app.add_option("-o,--out", options.out,
                   "Picture: linear radiance (.exr with coverage, .hdr) or sRGB (.png, and .jpg, "
                   ".tif, .webp "
                   "and more where OpenImageIO is installed)")
        ->type_name("FILE");
    app.add_option("--stats", options.stats, "JSON file of what was drawn and how long it took")
        ->type_name("FILE.json");
    app.add_option("--frames", options.frames,
                   "Number of frames to draw; a window closes after them")
        ->check(CLI::Range(1, 1000000));
}

void describeComparison(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--compare", options.compare,
                   "Two pictures of the material in one, each " + compareSideHelp() +
                       ". Functions are drawn as --technique reference, with an environment as "
                       "path without bounces; --stats has PSNR, FLIP and Delta E")
        ->expected(2)
        ->type_name("A B");
    app.add_option("--compare-mode", texts.compareMode,
                   "How: split (default) at a line, wipe of that line (a film to FILE.gif or "
                   "FILE.webp), flip (side by side, or a film), difference of the sRGB codes, or "
                   "heat, its colours with a scale")
        ->type_name("MODE");
    app.add_option("--compare-at", options.compareAt,
                   "Share of the width that A has in a split (default: 0.5)")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--compare-gain", options.compareGain, "Factor of a difference (default: 8)")
        ->check(CLI::Range(double(scene::kLeastGain), double(scene::kMostGain)));
}

void describeMaterials(CLI::App& command, Options& options)
{
    command.fallthrough();  // the options of pictures are those of sheets, too
    command.add_option("MATERIAL", options.materials, "As --material")
        ->type_name("FILE|SOURCE")
        ->required();
}

CLI::App* describeSheet(CLI::App& app, Options& options)
{
    auto* sheet = app.add_subcommand(
        "sheet",
        "Writes a picture of each material under each light, with labels, in the full scene");
    describeMaterials(*sheet, options);
    sheet
        ->add_option("--under", options.under,
                     "A column of the sheet: an environment (as --environment) or lights (as "
                     "--lights). Repeatable (default: all built-in environments)")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false);
    return sheet;
}

CLI::App* describeTurntable(CLI::App& app, Options& options)
{
    auto* turntable = app.add_subcommand(
        "turntable",
        "Writes a material that turns once about +y, in the full scene: an animation (-o FILE.gif "
        "or FILE.webp), or a folder of PNG files; --frames N of them (default: 60)");
    describeMaterials(*turntable, options);
    return turntable;
}

CLI::App* describeFigures(CLI::App& app)
{
    auto* figures = app.add_subcommand(
        "figures",
        "Writes the figures of Romanyuk et al. 2020 to a folder (-o): the true BRDF at vertices "
        "(1a), its factorization (1b), several materials under several lights (2), their "
        "references, maps of their errors, and the numbers");
    figures->fallthrough();
    return figures;
}

/// A window may change to `path` later.
void checkPath(const Options& options)
{
    if (!options.headless || options.technique == scene::ViewTechnique::path) return;
    if (options.bounces)
        throw Error(
            ErrorKind::usage, "--bounces",
            Found("it with --technique " + std::string(viewTechniqueName(options.technique)))
                .expected("--technique path"));
}

/// What an environment is asked for must have one.
void checkEnvironment(const CLI::App& app, const Options& options)
{
    if (!options.environment.empty()) return;
    for (const char* option : {"--environment-rotation", "--environment-intensity",
                               "--environment-lobes", "--environment-samples"})
        if (app.count(option) > 0)
            throw Error(ErrorKind::usage, option,
                        Found("no environment").expected("--environment as well"));
    if (options.background.environment)
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
    if (options.compare.empty()) return;
    if (options.command != Command::view)
        throw Error(ErrorKind::usage, "--compare",
                    Found("it with a subcommand").expected("it with a single picture"));
    if (options.headless && options.materials.size() > 1)
        throw Error(ErrorKind::usage, "--compare",
                    Found(std::to_string(options.materials.size()) + " materials").expected("one"));
}

/// Fills in what the full scene has and nobody asked for otherwise.
void completeScene(const Texts& texts, Options& options)
{
    // Figures are compared pixel by pixel with what their lights alone do.
    const bool isFullByItself =
        options.command == Command::view ? !options.headless : options.command != Command::figures;
    const bool noEnvironment = options.environment == "none";
    if (noEnvironment) options.environment.clear();
    options.full = texts.full || (isFullByItself && !texts.plain);
    if (!options.full) return;
    options.ground = options.shadows = options.toneMap = true;
    if (options.command == Command::sheet && options.environment.empty() && !noEnvironment &&
        options.lights.empty() && options.under.empty())
        options.under = proceduralEnvironments();
    if (options.environment.empty() && !noEnvironment)
        options.environment = proceduralEnvironments().front();
    if (texts.background.empty()) options.background.environment = !noEnvironment;
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
    if (!options.stats.empty())
        throw Error(ErrorKind::usage, "--stats",
                    Found("it with a subcommand").expected("it with a single picture"));
    const bool isTurntable = options.command == Command::turntable;
    if (options.frames && (!isTurntable || *options.frames > kMostTurntableFrames))
        throw Error(ErrorKind::usage, "--frames",
                    Found(std::to_string(*options.frames)).expected("up to 1000, of a turntable"));
    if (options.command == Command::figures && !options.materials.empty())
        throw Error(ErrorKind::usage, "figures",
                    Found("--material").expected("the materials of the figures alone"));
    if (options.command == Command::figures && options.width != options.height)
        throw Error(ErrorKind::usage, "--size",
                    Found(std::to_string(options.width) + "x" + std::to_string(options.height))
                        .expected("as many pixels up as across, of figures"));
    if (isTurntable && options.materials.size() != 1)
        throw Error(ErrorKind::usage, "turntable",
                    Found(std::to_string(options.materials.size()) + " materials").expected("one"));
}

Size sizeOf(const Texts& texts, const Options& options)
{
    if (!texts.size.empty()) return sizeFromText(texts.size);
    switch (options.command) {
        case Command::sheet: return {320, 320};
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
    if (!texts.technique.empty()) options.technique = scene::viewTechniqueFromName(texts.technique);
    if (!texts.compareMode.empty())
        options.compareMode = scene::compareModeFromName(texts.compareMode);
    checkPath(options);
    if (!texts.lookUp.empty()) options.lookUp = lookUpFromName(texts.lookUp);
    if (!texts.camera.empty()) options.camera = scene::cameraFromText(texts.camera);
    const Size size = sizeOf(texts, options);
    options.width = size.width;
    options.height = size.height;
    completeScene(texts, options);
    options.exposure = texts.exposure.value_or(options.full ? kFullExposure : 1.0f);
    if (!texts.background.empty()) options.background = scene::backgroundFromText(texts.background);
    for (const double number : {options.environmentRotation, options.environmentIntensity})
        if (!std::isfinite(number))
            throw Error(ErrorKind::usage, "--environment-rotation, --environment-intensity",
                        Found("no finite number").expected("one"));
    if (!std::isfinite(options.exposure))
        throw Error(ErrorKind::usage, "--exposure", Found("no finite number").expected("one > 0"));
    checkCommand(options);
    checkOut(options);
}

}  // namespace

int samplesOf(const Options& options, scene::ViewTechnique technique)
{
    if (options.samples) return *options.samples;
    if (technique == scene::ViewTechnique::path) return kPathSamples;
    return options.full ? kFullSamples : 1;
}

Options optionsFromArguments(int argc, const char* const* argv)
{
    Options options;
    Texts texts;
    CLI::App app(
        "Draws factored materials under any number of lights, and the references that they are "
        "compared with",
        "fbrdf-viewer");
    describeScene(app, options, texts);
    describePicture(app, options, texts);
    describeComparison(app, options, texts);
    const auto* devices =
        app.add_subcommand("list-devices", "Prints what --device can choose, a line each");
    const auto* sheet = describeSheet(app, options);
    const auto* turntable = describeTurntable(app, options);
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
    if (figures->parsed()) options.command = Command::figures;
    if (options.command != Command::view) options.headless = true;
    understand(texts, options);
    checkEnvironment(app, options);
    checkComparison(app, options);
    return options;
}

}  // namespace fbrdf::viewer
