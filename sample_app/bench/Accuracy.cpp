#include "bench/Accuracy.h"

#include "bench/Materials.h"
#include "bench/Stage.h"
#include "bench/Variants.h"
#include "viewer/GlFunctions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/truth/Reference.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fbrdf::bench {
namespace {

constexpr int kSize = 64;

const HeadlessOptions kDesktop{Backend::egl, HeadlessOptions::Profile::core, 4, 5};

struct Version {
    HeadlessOptions context;
    int glsl = 0;              ///< 0: the newest that the context has
    bool floatTargets = true;  ///< false: pretends that only RGBA8 can be drawn to
};

std::vector<Version> versions(std::optional<int> device)
{
    using Profile = HeadlessOptions::Profile;
    std::vector<Version> all{{kDesktop, 0},
                             {kDesktop, 0, false},
                             {{Backend::egl, Profile::core, 3, 3}, 330},
                             {{Backend::egl, Profile::compatibility, 2, 1}, 120},
                             {{Backend::egl, Profile::es, 3, 0}, 300},
                             {{Backend::egl, Profile::es, 3, 0}, 100}};
    for (Version& version : all) version.context.device = device;
    return all;
}

struct Format {
    OffscreenFormat offscreen;
    ColourFormat colour;
};
constexpr Format kFormats[] = {{OffscreenFormat::rgba32f, ColourFormat::rgba32f},
                               {OffscreenFormat::rgba16f, ColourFormat::rgba16f},
                               {OffscreenFormat::rgba8, ColourFormat::rgba8}};

ColourFormat colourFormatFromName(const std::string& name)
{
    for (const ColourFormat format :
         {ColourFormat::rgba8, ColourFormat::rgba16, ColourFormat::rgba16f, ColourFormat::rgba32f})
        if (name == colourFormatName(format)) return format;
    return ColourFormat::other;
}

/// A material under so many lights, and what is exact for it: the same in every version.
struct Case {
    std::string form;  ///< with what materialOptionsFromWord takes: "pqp cube"
    Material material;
    gl::MaterialOptions options;
    std::vector<Light> lights;
    std::vector<double> radiance = {};  ///< of each pixel
};

Case makeCase(const std::string& form, int count, const Stage& stage,
              const truth::GeometryBuffer& geometry)
{
    const size_t end = form.find(' ');
    Case result{form, benchMaterial(form.substr(0, end)),
                materialOptionsFromWord(end == std::string::npos ? "" : form.substr(end + 1)),
                stageLights(count)};
    result.radiance = truth::referenceImage(result.material, geometry, result.lights, stage.view);
    const auto forColours = [&](auto act) {
        for (size_t i = 0; i < result.radiance.size(); ++i)
            if (i % 4 < 3) act(result.radiance[i]);
    };
    double largest = 0.0;
    forColours([&](double value) { largest = std::max(largest, value); });
    // Scaled so that no pixel exceeds 1, where RGBA8 would clamp it; by a power of two, which
    // rounds nothing.
    const double scale = std::exp2(std::floor(-std::log2(largest)));
    forColours([&](double& value) { value *= scale; });
    for (Light& light : result.lights) light.intensity *= static_cast<float>(scale);
    return result;
}

gl::Renderer rendererOf(const HeadlessContext& context, const Version& version)
{
    gl::RendererOptions options;
    options.load = context.loader();
    options.capabilities = gl::Renderer(options).capabilities();
    if (version.glsl != 0) options.capabilities->glsl = version.glsl;
    if (version.glsl == 120) options.capabilities->vertexArrays = false;
    if (!version.floatTargets)
        options.capabilities->floatTargets = options.capabilities->halfTargets = false;
    return gl::Renderer(options);
}

/// The interpolated geometry, read back from a desktop context: it does not depend on the version.
truth::GeometryBuffer geometryOf(const Stage& stage, std::optional<int> device)
{
    HeadlessOptions desktop = kDesktop;
    desktop.device = device;
    const HeadlessContext context(desktop);
    Offscreen floats(context.loader(), {kSize, kSize});
    return truth::geometryBuffer(viewer::loadGlFunctions(context.loader()), floats, stage.mesh,
                                 glm::mat4(1.0f), stage.view);
}

/// One version: a context and the drawings in it.
class Bench {
public:
    Bench(const Version& version, const Stage& stage)
        : context_(version.context),
          renderer_(rendererOf(context_, version)),
          floatTargets_(version.floatTargets),
          stage_(stage),
          mesh_(renderer_.createMesh(stage_.mesh))
    {
    }

    const gl::Renderer& renderer() const { return renderer_; }

    void measure(const Case& wanted, std::vector<AccuracyRow>& rows)
    {
        const auto gpu = renderer_.createMaterial(wanted.material, wanted.options);
        const UploadedMaterial uploaded =
            uploadedMaterial(wanted.material, wanted.options, renderer_.capabilities());
        for (const Format& format : kFormats) {
            if (!floatTargets_ && format.colour != ColourFormat::rgba8) continue;
            for (const Technique technique : allTechniques())
                rows.push_back(drawn(*gpu, uploaded, wanted, format, technique));
        }
    }

private:
    AccuracyRow drawn(const gl::GpuMaterial& material, const UploadedMaterial& uploaded,
                      const Case& wanted, const Format& format, Technique technique)
    {
        constexpr int kLightsPerPass = 8;
        Offscreen offscreen(context_.loader(), {kSize, kSize, format.offscreen});
        offscreen.clear();
        const auto stats = renderer_.draw({offscreen.framebuffer(), kSize, kSize}, stage_.view,
                                          {{&material, mesh_.get()}}, wanted.lights,
                                          {technique, kLightsPerPass, 0});
        if (stats.itemsFailed > 0)
            throw Error(ErrorKind::gl, "runtime", "found an object that cannot be drawn");
        const Capabilities& c = renderer_.capabilities();
        PlanRequest request;
        request.technique = stats.technique;
        request.lights = static_cast<int>(wanted.lights.size());
        request.lightsPerPass = kLightsPerPass;
        request.target = format.colour;
        request.accumulation = colourFormatFromName(stats.accumulation);
        const bool isEs = c.glsl == 100 || c.glsl == 300;
        return {fmt::format("{}.{} {}{}{}", c.glMajor, c.glMinor, isEs ? "ES " : "GLSL ", c.glsl,
                            floatTargets_ ? "" : " RGBA8"),
                wanted.form,
                techniqueName(technique),
                colourFormatName(format.colour),
                request.lights,
                stats.passes,
                runtimeCost(uploaded, request, c),
                stats.error,
                truth::deviationOf(offscreen.readPixels(), wanted.radiance, stats.error),
                stats.whyReplaced};
    }

    HeadlessContext context_;
    gl::Renderer renderer_;
    bool floatTargets_;
    const Stage& stage_;
    std::shared_ptr<gl::GpuMesh> mesh_;
};

}  // namespace

std::vector<std::string> accuracyForms()
{
    std::vector<std::string> forms = allForms();
    for (const char* form : {"pqp cube", "pqp parabolic", "pqpr cube", "hdio precise",
                             "hdpio precise", "hdpu precise", "pqpr precise"})
        forms.push_back(form);
    return forms;
}

bool Accuracy::holds() const
{
    return std::all_of(rows.begin(), rows.end(),
                       [](const AccuracyRow& row) { return row.found.share <= 1.0; });
}

Accuracy measureAccuracy(const Options& options)
{
    const std::vector<std::string> forms = options.only.empty() ? accuracyForms() : options.only;
    const Stage stage = makeStage("sphere", 1.0);
    const truth::GeometryBuffer geometry = geometryOf(stage, options.device);
    std::vector<Case> cases;
    for (const std::string& form : forms)
        for (const int count : options.lights)
            cases.push_back(makeCase(form, count, stage, geometry));
    Accuracy result;
    for (const Version& version : versions(options.device)) {
        try {
            Bench bench(version, stage);
            result.glRenderer = bench.renderer().glRenderer();
            for (const Case& wanted : cases) bench.measure(wanted, result.rows);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::gl) throw;
            result.leftOut.push_back(fmt::format("{}.{}: {}", version.context.major,
                                                 version.context.minor, error.what()));
        }
    }
    if (result.rows.empty())
        throw Error(ErrorKind::gl, "accuracy", result.leftOut.empty() ? "" : result.leftOut[0]);
    return result;
}

std::string asText(const Accuracy& accuracy)
{
    size_t width = std::size("form");
    for (const AccuracyRow& row : accuracy.rows) width = std::max(width, row.form.size());
    std::string text = fmt::format(
        "{}, {}x{} pixels, against double; multiply-adds, special functions and bytes of texels "
        "are for a pixel and light\n{:<18} {:<{}} {:<11} {:<8} {:>6} {:>6} {:>7} {:>7} {:>7} "
        "{:>9} {:>9} {:>9} {:>9} {:>6}\n",
        accuracy.glRenderer, kSize, kSize, "version", "form", width, "technique", "format",
        "lights", "passes", "MACs", "special", "bytes", "relative", "bound", "absolute", "bound",
        "share");
    for (const AccuracyRow& row : accuracy.rows)
        text += fmt::format(
            "{:<18} {:<{}} {:<11} {:<8} {:>6} {:>6} {:>7.1f} {:>7.1f} {:>7.1f} {:>9.1e} {:>9.1e} "
            "{:>9.1e} {:>9.1e} {:>6.2f}{}\n",
            row.version, row.form, width, row.technique, row.format, row.lights, row.passes,
            row.cost.multiplyAdds, row.cost.specials, row.cost.bytes, row.found.relative,
            row.bound.relative, row.found.absolute, row.bound.absolute, row.found.share,
            row.whyReplaced.empty() ? "" : "  replaced: " + row.whyReplaced);
    for (const std::string& left : accuracy.leftOut) text += "left out: " + left + "\n";
    return text +
           "relative: to the exact value or a hundredth of the mean; share: of relative bound x "
           "that "
           "+ absolute bound\n";
}

std::string asJson(const Accuracy& accuracy)
{
    auto rows = nlohmann::ordered_json::array();
    for (const AccuracyRow& row : accuracy.rows)
        rows.push_back({{"version", row.version},
                        {"form", row.form},
                        {"technique", row.technique},
                        {"format", row.format},
                        {"lights", row.lights},
                        {"passes", row.passes},
                        {"multiply_adds", row.cost.multiplyAdds},
                        {"specials", row.cost.specials},
                        {"bytes", row.cost.bytes},
                        {"relative", row.found.relative},
                        {"absolute", row.found.absolute},
                        {"bound", {row.bound.relative, row.bound.absolute}},
                        {"share", row.found.share},
                        {"why_replaced", row.whyReplaced}});
    return nlohmann::ordered_json{{"renderer", accuracy.glRenderer},
                                  {"rows", rows},
                                  {"left_out", accuracy.leftOut},
                                  {"holds", accuracy.holds()}}
               .dump(2) +
           "\n";
}

}  // namespace fbrdf::bench
