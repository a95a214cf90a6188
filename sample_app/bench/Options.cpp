#include "bench/Options.h"

#include "viewer/CommandLine.h"

#include <fbrdf/base/ClassicLocale.h>
#include <fbrdf/base/Error.h>

#include <CLI/CLI.hpp>

namespace fbrdf::bench {
namespace {

constexpr int kMostLights = 65536;

[[noreturn]] void fail(const std::string& where, const std::string& what)
{
    throw Error(ErrorKind::usage, where, what);
}

}  // namespace

Options optionsFromArguments(int argc, const char* const* argv)
{
    const ClassicLocale numbers;
    Options options;
    std::string size, mesh, clock, device;
    CLI::App app(
        "Times the runtime against other ways to draw a material, all in one process, frame by "
        "frame in turn: median milliseconds a frame, and the ratio to analytic GGX",
        "fbrdf-bench");
    app.add_option("--lights", options.lights, "Numbers of lights")
        ->delimiter(',')
        ->check(CLI::Range(1, kMostLights))
        ->type_name("N,N,...");
    app.add_option("--size", size, "Pixels (default 256x256)")->type_name("WxH");
    app.add_option("--mesh", mesh, "One full-screen triangle, or a sphere (default: both)")
        ->check(CLI::IsMember({"triangle", "sphere"}));
    app.add_option("--only", options.only, "Nothing but these variants")
        ->delimiter(',')
        ->type_name("NAME,...");
    app.add_option("--frame-limit", options.frameLimit,
                   "Milliseconds; what would take longer a frame is left out, and named")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--clock", clock,
                   "wall (default); cpu: that of the process, steadier where a busy machine draws "
                   "in software; gpu: timer queries")
        ->check(CLI::IsMember({"wall", "cpu", "gpu"}));
    app.add_option("--device", device, viewer::deviceHelp())->type_name("N|list");
    app.add_flag("--accuracy", options.accuracy,
                 "How right the pictures are: every technique, form, format and version against "
                 "double and the bound of its plan; exit code 1 where that is exceeded");
    app.add_flag(
        "--reach", options.reach,
        "4,096 lights with a radius in lists, --lights of which reach a pixel, against one "
        "list of as many");
    app.add_flag("--environment", options.environment,
                 "Light from everywhere and area lights, by lobes, against GGX by the split sum");
    app.add_flag("--json", options.json, "One object instead of tables");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    } catch (const CLI::ParseError& error) {
        fail("command line", error.what());
    }
    if (!size.empty()) {
        const viewer::Size pixels = viewer::sizeFromText(size);
        options.width = pixels.width;
        options.height = pixels.height;
    }
    if (!mesh.empty()) options.meshes = {mesh};
    if (clock == "cpu") options.clock = Options::Clock::cpu;
    if (clock == "gpu") options.clock = Options::Clock::gpu;
    options.listDevices = device == "list";
    if (!options.listDevices) options.device = viewer::deviceFromText(device);
    return options;
}

}  // namespace fbrdf::bench
