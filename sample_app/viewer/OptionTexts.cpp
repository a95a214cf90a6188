#include "OptionTexts.h"

#include "CommandLine.h"
#include "CompareSide.h"
#include "SceneFile.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/Sky.h>

#include <fmt/format.h>

#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr int kMostBounces = 1000;

void describeEnvironment(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--environment", options.document.environment.name,
                   "Light from everywhere, beside the other lights: a panorama, built-in " +
                       fmt::format("{}", fmt::join(proceduralEnvironments(), ", ")) + ", or none")
        ->type_name("FILE.exr|FILE.hdr|NAME");
    app.add_option("--environment-rotation", options.document.environment.degrees,
                   "Degrees by which it is turned about +y");
    app.add_option("--environment-intensity", options.document.environment.intensity,
                   "Factor of its radiance")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--environment-lobes", options.document.environment.lobes,
                   "Lobes that are drawn, at most: 1, 2 or 3 (default: all that a material has)")
        ->check(CLI::Range(1, kMostTiltedLobes));
    app.add_option(
           "--environment-samples", options.document.environment.samples,
           "Directions for each pixel that are drawn by the lobes, instead of looking those "
           "up: 64 in soft light, hundreds where lamps are small; 0: none (default)")
        ->check(CLI::Range(0, scene::kMostSamples));
    app.add_option(
        "--background", texts.background,
        "What is seen behind the objects: environment, R,G,B (linear), or none (default)");
}

void describeStage(CLI::App& app, Options& options, Texts& texts)
{
    app.add_flag("--ground", options.document.ground,
                 "A matt plane below the objects that takes their shadows");
    app.add_flag("--shadows", options.document.shadows,
                 "Shadows of the strongest lights, up to four, on objects and ground");
    app.add_flag("--tone-map", options.document.toneMap,
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

/// Options are taken in the order in which they are described, so what is given beside a scene
/// changes a part of it.
void describeSceneFile(CLI::App& app, Options& options)
{
    app.add_option_function<std::string>(
           "SCENE,--scene",
           [&options](const std::string& path) {
               if (std::filesystem::path(path).extension() != ".json")
                   throw Error(ErrorKind::usage, "command line",
                               Found("'" + path + "'")
                                   .expected("an option, a subcommand or a "
                                             "scene, FILE.json"));
               options.scene = path;
               options.document = readScene(path);
           },
           "A scene that the window saved (Ctrl+S); every option given changes its part")
        ->type_name("FILE.json");
}

void describeScene(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--material", texts.materials,
                   "A material (.fbrdf, 2001 layout), or reflectance to fit first: a file or a "
                   "model like ggx:alpha=0.2. Repeatable: one object each")
        ->type_name("FILE|SOURCE")
        ->allow_extra_args(false);
    app.add_option("--form", texts.form, "Form of the fit where a source is given")
        ->capture_default_str();
    app.add_option("--mesh", options.document.mesh, "sphere, knot, plane or an OBJ file")
        ->type_name("NAME|FILE.obj")
        ->capture_default_str();
    auto* file = app.add_option("--lights", options.lights, "Lights from a file");
    file->type_name("FILE.json");
    auto* count =
        app.add_option("--light-count", texts.lightCount,
                       "Number of point lights to make (default: 5; two key lights in the full "
                       "scene)");
    count->excludes(file)->check(CLI::Range(0, scene::kMostLights));
    app.add_option("--seed", options.document.lights.seed, "Seed of the lights that are made")
        ->excludes(file);
    describeEnvironment(app, options, texts);
    describeStage(app, options, texts);
    app.add_option("--camera", texts.camera, "Eye, centre and vertical field of view")
        ->type_name("ex,ey,ez,cx,cy,cz,fovy_degrees");
}

void describePicture(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--browse", options.browse,
                   "Folder whose materials a window lists with thumbnails (default: that of the "
                   "first material)")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--headless", options.headless, "No window, no display");
    app.add_option("--backend", texts.backend,
                   "How to get GL without a display: egl (default) or osmesa");
    app.add_option("--device", texts.device, deviceHelp())->type_name("N|list");
    app.add_option("--technique", texts.technique, scene::viewTechniqueHelp());
    app.add_option("--samples", texts.samples,
                   "Samples a pixel, spread over it (default: 1, 16 in the full scene; of "
                   "--technique path 64)")
        ->check(CLI::Range(1, scene::kMostSamples));
    app.add_option("--bounces", options.bounces,
                   "Bounces between surfaces, at most, of --technique path (default: 8)")
        ->check(CLI::Range(0, kMostBounces));
    app.add_option(
        "--look-up", texts.lookUp,
        "How maps over one direction are looked up: native (default), or recombined into "
        "parabolic or cube maps");
    app.add_flag("--precise", options.document.precise,
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
                       ". Functions are drawn as --technique reference, which here draws "
                       "directions to an environment at random, a sample each; --stats has PSNR, "
                       "FLIP and Delta E")
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

void describeMaterials(CLI::App& command, Texts& texts)
{
    command.fallthrough();  // the options of pictures are those of sheets, too
    command.add_option("MATERIAL", texts.materials, "As --material")
        ->type_name("FILE|SOURCE")
        ->required();
}

}  // namespace

void describeOptions(CLI::App& app, Options& options, Texts& texts)
{
    describeSceneFile(app, options);
    describeScene(app, options, texts);
    describePicture(app, options, texts);
    describeComparison(app, options, texts);
}

CLI::App* describeSheet(CLI::App& app, Options& options, Texts& texts)
{
    auto* sheet = app.add_subcommand(
        "sheet",
        "Writes a picture of each material under each light, with labels, in the full scene");
    describeMaterials(*sheet, texts);
    sheet
        ->add_option("--under", options.under,
                     "A column of the sheet: an environment (as --environment) or lights (as "
                     "--lights). Repeatable (default: all built-in environments)")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false);
    return sheet;
}

CLI::App* describeTurntable(CLI::App& app, Texts& texts)
{
    auto* turntable = app.add_subcommand(
        "turntable",
        "Writes a material that turns once about +y, in the full scene: an animation (-o FILE.gif "
        "or FILE.webp), or a folder of PNG files; --frames N of them (default: 60)");
    describeMaterials(*turntable, texts);
    return turntable;
}

CLI::App* describeCompareSheet(CLI::App& app, Texts& texts)
{
    auto* compare = app.add_subcommand(
        "compare",
        "Writes a material as several sides have it, in the full scene, with labels, and below a "
        "map of how far each is from the first; --stats has the numbers");
    describeMaterials(*compare, texts);
    compare
        ->add_option("--side", texts.sides,
                     "A column of the sheet, as the sides of --compare. Repeatable (default: "
                     "reference, drawn, pqp-2001, svd4, ggx and ggx2, as far as there are such)")
        ->type_name("NAME|FILE|SOURCE")
        ->allow_extra_args(false);
    return compare;
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

}  // namespace fbrdf::viewer
