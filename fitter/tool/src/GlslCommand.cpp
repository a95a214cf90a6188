// fbrdf glsl: the programs that draw a material.
#include "Commands.h"
#include "Output.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/shaders/TextureImage.h>
#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

struct GlslCommand {
    std::string material, technique = techniqueName(Technique::single);
    int version = 330, lights = 8;
    bool functions = false;
};

bool isEs(int version)
{
    return version == 100 || version == 300;
}

std::string versionList()
{
    std::string list;
    for (const int version : kGlslVersions)
        list += (list.empty() ? "" : ", ") + std::to_string(version);
    return list;
}

void checkVersion(int version)
{
    if (std::find(kGlslVersions.begin(), kGlslVersions.end(), version) == kGlslVersions.end())
        throw Error(ErrorKind::usage, "--version",
                    fmt::format(Found("{}").expected("one of {}"), version, versionList()));
}

/// A common context of that version. OpenGL ES 2.0 seldom draws to floats or filters them, and no
/// ES has 16-bit UNORM textures.
Capabilities commonContext(int version)
{
    Capabilities c;
    c.glsl = version;
    c.maxUniformVectors = 256;  // what OpenGL 3.0 guarantees a fragment shader
    c.framebufferObjects = true;
    c.floatTextures = c.floatTargets = c.halfTargets = version != 100;
    c.unorm16Textures = !isEs(version);
    return c;
}

std::vector<TableEncoding> encodingsIn(const Capabilities& context, const Material& material)
{
    std::vector<TableEncoding> encodings;
    for (size_t k = 0; k < material.tables.size(); ++k)
        encodings.push_back(material.form.tables[k].uniform
                                ? TableEncoding{isLog(material.tables[k].storage), false}
                                : textureImage(material.tables[k], context).encoding);
    return encodings;
}

Plan planOf(const GlslCommand& command, const Material& material, const Capabilities& context)
{
    PlanRequest request;
    request.technique = techniqueFromName(command.technique);
    request.lights = command.lights;
    request.target = context.floatTargets ? ColourFormat::rgba32f : ColourFormat::rgba8;
    request.signs = hasSigns(material);
    Plan plan = planPasses(material.form, request, context);
    if (!plan.feasible()) throw Error(ErrorKind::gl, command.material, plan.reason);
    return plan;
}

/// "1 to 8, 10".
std::string ranges(const std::vector<int>& numbers)
{
    std::string text;
    for (size_t i = 0; i < numbers.size();) {
        size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
        if (last > i) text += " to " + std::to_string(numbers[last]);
        i = last + 1;
    }
    return text;
}

const char* surfaceName(Surface surface)
{
    switch (surface) {
        case Surface::target: return "target";
        case Surface::accumulation: return "accumulation";
        case Surface::scratch: return "scratch";
        case Surface::sum: return "sum";
    }
    return "?";
}

const char* blendName(Blend blend)
{
    switch (blend) {
        case Blend::replace: return "replace";
        case Blend::add: return "add";
        case Blend::multiply: return "multiply";
    }
    return "?";
}

std::string passTable(const Plan& plan)
{
    std::string text = "// pass  lights  look-ups  blend     writes        reads\n";
    int number = 0;
    for (const Pass& pass : plan.passes)
        text += fmt::format("// {:>4}  {:>6}  {:>8}  {:<8}  {:<12}  {}\n", ++number,
                            pass.lightCount, pass.lookups, blendName(pass.blend),
                            surfaceName(pass.writes), pass.reads ? surfaceName(*pass.reads) : "-");
    return text;
}

/// The line before each shader: a script splits the output there.
std::string heading(const char* stage, const std::vector<int>& passes)
{
    return fmt::format("\n// ---- {} shader, pass {}\n", stage, ranges(passes));
}

/// Fragment shaders in the order in which they are first used; passes often share one.
struct Fragment {
    std::string text;
    std::vector<int> passes;
};

std::vector<Fragment> fragmentsOf(const Plan& plan, const Material& material,
                                  const Capabilities& context)
{
    const auto encodings = encodingsIn(context, material);
    const int mostLights = maxLightsInUniforms(material.form, context);
    std::vector<Fragment> fragments;
    int number = 0;
    for (const Pass& pass : plan.passes) {
        std::string text =
            fragmentSource(material.form, encodings, programSpec(pass, mostLights), context.glsl);
        auto found = std::find_if(fragments.begin(), fragments.end(),
                                  [&text](const Fragment& f) { return f.text == text; });
        if (found == fragments.end())
            found = fragments.insert(fragments.end(), {std::move(text), {}});
        found->passes.push_back(++number);
    }
    return fragments;
}

std::string programsText(const GlslCommand& command, const Material& material)
{
    const Capabilities context = commonContext(command.version);
    const Plan plan = planOf(command, material, context);
    const std::vector<Fragment> fragments = fragmentsOf(plan, material, context);
    std::vector<int> all;
    for (size_t i = 1; i <= plan.passes.size(); ++i) all.push_back(static_cast<int>(i));
    std::string text = fmt::format(
        "// form {}, technique {}, {} lights, GLSL {}{}\n{}", material.form.name, command.technique,
        command.lights, isEs(command.version) ? "ES " : "", command.version, passTable(plan));
    text += heading("vertex", all) + vertexSource(command.version);
    for (const Fragment& fragment : fragments)
        text += heading("fragment", fragment.passes) + fragment.text;
    return text;
}

/// What a host puts into a fragment shader of its own; with lobes, how to draw directions by them.
std::string functionsText(const GlslCommand& command, const Material& material)
{
    const Capabilities context = commonContext(command.version);
    std::string text = materialFunctions(material.form, encodingsIn(context, material),
                                         command.version, std::max(1, command.lights));
    if (!material.lobes.isEmpty() && command.version != 100)
        text += samplingFunctions(layoutOf(material.lobes), command.version);
    return text;
}

int run(const GlslCommand& command)
{
    checkVersion(command.version);
    techniqueFromName(command.technique);  // bad usage is reported before the file is read
    const Material material = readMaterial(command.material);
    writeOut(command.functions ? functionsText(command, material)
                               : programsText(command, material));
    return 0;
}

}  // namespace

void addGlslCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("glsl", "the programs that draw a material");
    const auto command = std::make_shared<GlslCommand>();
    sub->add_option("MATERIAL", command->material, "material file")->required();
    sub->add_option("--technique", command->technique, techniqueNames())->capture_default_str();
    sub->add_option("--version", command->version,
                    versionList() + "; 100 and 300 are those of OpenGL ES")
        ->capture_default_str();
    sub->add_option("--lights", command->lights, "number of lights")
        ->check(CLI::Range(0, 65536))
        ->capture_default_str();
    sub->add_flag("--functions", command->functions,
                  "instead: fbrdfEvaluate, fbrdfRadiance and, where the material has lobes, "
                  "fbrdfSampleLobes and fbrdfLobePdf, for a fragment shader of your own");
    sub->footer(
        "Prints the passes, one vertex shader that serves all of them, and each fragment shader\n"
        "once. A line that starts with '// ----' begins a shader.");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool
