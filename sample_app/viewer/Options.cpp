#include "Options.h"

#include "CommandLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Image.h>

#include <CLI/CLI.hpp>

namespace fbrdf::viewer {
namespace {

constexpr int kMostLights = 65536;

/// What CLI11 fills and what still has to be understood.
struct Texts {
    std::string backend, technique, lookUp, camera, size;
};

void describeScene(CLI::App& app, Options& options, Texts& texts)
{
    app.add_option("--material", options.materials,
                   "A material (.fbrdf, 2001 layout), or reflectance to fit first: a file or a "
                   "model like ggx:alpha=0.2. Repeatable: one object each")
        ->type_name("FILE|SOURCE")
        ->allow_extra_args(false);
    app.add_option("--form", options.form, "The form in which sources are fitted")
        ->capture_default_str();
    app.add_option("--mesh", options.mesh, "sphere, knot, plane or an OBJ file")
        ->type_name("NAME|FILE.obj")
        ->capture_default_str();
    auto* file = app.add_option("--lights", options.lights, "Lights from a file");
    file->type_name("FILE.json");
    auto* count = app.add_option("--light-count", options.lightCount, "Made point lights");
    count->excludes(file)->check(CLI::Range(0, kMostLights))->capture_default_str();
    app.add_option("--seed", options.seed, "Which made lights")->excludes(file);
    app.add_option("--camera", texts.camera, "Eye, centre and vertical field of view")
        ->type_name("ex,ey,ez,cx,cy,cz,fovy_degrees");
}

void describePicture(CLI::App& app, Options& options, Texts& texts)
{
    auto* headless = app.add_flag("--headless", options.headless, "No window, no display");
    app.add_option("--backend", texts.backend, "GL without a display: egl (default) or osmesa")
        ->needs(headless);
    app.add_option("--technique", texts.technique,
                   "single, batched, two-lookup; on the CPU: vertex (true BRDF at the vertices), "
                   "reference (true BRDF at every pixel, in double)");
    app.add_option("--look-up", texts.lookUp,
                   "Maps over one direction: native (default), or recombined into parabolic or "
                   "cube maps");
    app.add_option("--size", texts.size, "Pixels (default 512x512)")->type_name("WxH");
    app.add_option("--exposure", options.exposure, "Factor of radiance in PNG and window")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--out", options.out,
                   "Picture: linear radiance and coverage (.exr) or sRGB (.png)")
        ->type_name("FILE");
    app.add_option("--stats", options.stats, "What was drawn and how long it took")
        ->type_name("FILE.json");
    app.add_option("--frames", options.frames, "Frames to draw (a window closes after them)")
        ->check(CLI::Range(1, 1000000));
}

void understand(const Texts& texts, Options& options)
{
    if (!texts.backend.empty()) options.backend = backendFromName(texts.backend);
    if (!texts.technique.empty()) options.technique = scene::viewTechniqueFromName(texts.technique);
    if (!texts.lookUp.empty()) options.lookUp = lookUpFromName(texts.lookUp);
    if (!texts.camera.empty()) options.camera = scene::cameraFromText(texts.camera);
    if (!texts.size.empty()) {
        const Size size = sizeFromText(texts.size);
        options.width = size.width;
        options.height = size.height;
    }
    if (!std::isfinite(options.exposure))
        throw Error(ErrorKind::usage, "--exposure", "found no finite number, expected one > 0");
    if (!options.out.empty()) scene::checkImagePath(options.out);
}

}  // namespace

Options optionsFromArguments(int argc, const char* const* argv)
{
    Options options;
    Texts texts;
    CLI::App app(
        "Draws factored materials, lit by any number of lights, and what they are judged "
        "by",
        "fbrdf-viewer");
    describeScene(app, options, texts);
    describePicture(app, options, texts);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::usage, "command line", error.what());
    }
    understand(texts, options);
    return options;
}

}  // namespace fbrdf::viewer
