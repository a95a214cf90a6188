#include "Options.h"

#include "CommandLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/SampledLight.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/scene/Image.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace fbrdf::viewer {
namespace {

constexpr int kMostLights = 65536;
constexpr int kMostSamples = 1 << 20, kMostBounces = 1000;

/// Texts that CLI11 fills in, to be interpreted afterwards.
struct Texts {
    std::string backend, device, technique, lookUp, camera, size, background;
};

void describeEnvironment(CLI::App& app, Options& options, Texts& texts)
{
    auto* environment =
        app.add_option("--environment", options.environment,
                       "Light from everywhere, beside the other lights: a panorama, or built-in " +
                           fmt::format("{}", fmt::join(proceduralEnvironments(), ", ")));
    environment->type_name("FILE.exr|FILE.hdr|NAME");
    app.add_option("--environment-rotation", options.environmentRotation,
                   "Degrees by which it is turned about +y")
        ->needs(environment);
    app.add_option("--environment-intensity", options.environmentIntensity,
                   "Factor of its radiance")
        ->needs(environment)
        ->check(CLI::NonNegativeNumber);
    app.add_option("--environment-lobes", options.environmentLobes,
                   "Lobes that are drawn, at most: 1, 2 or 3 (default: all that a material has)")
        ->needs(environment)
        ->check(CLI::Range(1, kMostTiltedLobes));
    app.add_option(
           "--environment-samples", options.environmentSamples,
           "Directions for each pixel that are drawn by the lobes, instead of looking those "
           "up: 64 in soft light, hundreds where lamps are small; 0: none (default)")
        ->needs(environment)
        ->check(CLI::Range(0, kMostSamples));
    app.add_option(
        "--background", texts.background,
        "What is seen behind the objects: environment, R,G,B (linear), or none (default)");
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
        app.add_option("--light-count", options.lightCount, "Number of point lights to make");
    count->excludes(file)->check(CLI::Range(0, kMostLights))->capture_default_str();
    app.add_option("--seed", options.seed, "Seed of the lights that are made")->excludes(file);
    describeEnvironment(app, options, texts);
    app.add_option("--camera", texts.camera, "Eye, centre and vertical field of view")
        ->type_name("ex,ey,ez,cx,cy,cz,fovy_degrees");
}

void describePicture(CLI::App& app, Options& options, Texts& texts)
{
    auto* headless = app.add_flag("--headless", options.headless, "No window, no display");
    app.add_option("--backend", texts.backend,
                   "How to get GL without a display: egl (default) or osmesa")
        ->needs(headless);
    app.add_option("--device", texts.device, deviceHelp())->type_name("N|list");
    app.add_option("--technique", texts.technique, scene::viewTechniqueHelp());
    app.add_option("--samples", options.samples,
                   "Samples a pixel, spread over it, of --technique path; the others do not take "
                   "it yet (default: 64 at its centre)")
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
    app.add_option("--size", texts.size, "Pixels (default 512x512)")->type_name("WxH");
    app.add_option("--exposure", options.exposure,
                   "Factor of the radiance in sRGB files and in the window")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--out", options.out,
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

/// A window may change to `path` later.
void checkPath(const Options& options)
{
    if (!options.headless || options.technique == scene::ViewTechnique::path) return;
    for (const auto& [option, isGiven] : {std::pair("--samples", options.samples.has_value()),
                                          std::pair("--bounces", options.bounces.has_value())})
        if (isGiven)
            throw Error(
                ErrorKind::usage, option,
                Found("it with --technique " + std::string(viewTechniqueName(options.technique)))
                    .expected("--technique path"));
}

void understand(const Texts& texts, Options& options)
{
    if (!texts.backend.empty()) options.backend = backendFromName(texts.backend);
    if (texts.device == "list") options.listDevices = true;
    if (!options.listDevices) options.device = deviceFromText(texts.device);
    if (options.device && (!options.headless || options.backend != Backend::egl))
        throw Error(ErrorKind::usage, "--device",
                    Found("it without --headless, or with osmesa").expected("both, with egl"));
    if (!texts.technique.empty()) options.technique = scene::viewTechniqueFromName(texts.technique);
    checkPath(options);
    if (!texts.lookUp.empty()) options.lookUp = lookUpFromName(texts.lookUp);
    if (!texts.camera.empty()) options.camera = scene::cameraFromText(texts.camera);
    if (!texts.size.empty()) {
        const Size size = sizeFromText(texts.size);
        options.width = size.width;
        options.height = size.height;
    }
    if (!texts.background.empty()) options.background = scene::backgroundFromText(texts.background);
    if (options.background.environment && options.environment.empty())
        throw Error(ErrorKind::usage, "--background",
                    Found("environment without one").expected("--environment as well"));
    for (const double number : {options.environmentRotation, options.environmentIntensity})
        if (!std::isfinite(number))
            throw Error(ErrorKind::usage, "--environment-rotation, --environment-intensity",
                        Found("no finite number").expected("one"));
    if (!std::isfinite(options.exposure))
        throw Error(ErrorKind::usage, "--exposure", Found("no finite number").expected("one > 0"));
    if (!options.out.empty()) scene::checkImagePath(options.out);
}

}  // namespace

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
    const auto* devices =
        app.add_subcommand("list-devices", "Prints what --device can choose, a line each");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::usage, "command line", error.what());
    }
    if (devices->parsed()) texts.device = "list";
    understand(texts, options);
    return options;
}

}  // namespace fbrdf::viewer
