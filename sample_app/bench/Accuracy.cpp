#include "bench/Accuracy.h"

#include "bench/Materials.h"
#include "bench/Stage.h"
#include "viewer/GlFunctions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/truth/Reference.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

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
    OffscreenFormat format;
    const char* name;
};
constexpr Format kFormats[] = {{OffscreenFormat::rgba32f, "RGBA32F"},
                               {OffscreenFormat::rgba16f, "RGBA16F"},
                               {OffscreenFormat::rgba8, "RGBA8"}};

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
    Bench(const Version& version, const Stage& stage, const truth::GeometryBuffer& geometry)
        : context_(version.context),
          renderer_(rendererOf(context_, version)),
          floatTargets_(version.floatTargets),
          stage_(stage),
          geometry_(geometry),
          mesh_(renderer_.createMesh(stage_.mesh))
    {
    }

    const gl::Renderer& renderer() const { return renderer_; }

    /// form: a form, optionally followed by how its maps are looked up: "pqp cube", or by
    /// "precise".
    void measure(const std::string& form, int count, std::vector<AccuracyRow>& rows)
    {
        const size_t end = form.find(' ');
        const Material material = ggxMaterial(form.substr(0, end));
        gl::MaterialOptions options;
        const std::string how = end == std::string::npos ? "native" : form.substr(end + 1);
        options.precise = how == "precise";
        if (!options.precise) options.lookUp = lookUpFromName(how);
        const auto gpu = renderer_.createMaterial(material, options);
        auto lights = stageLights(count);
        auto radiance = truth::referenceImage(material, geometry_, lights, stage_.view);
        // Scaled so that no pixel exceeds 1, where RGBA8 would clamp it.
        const auto scale =
            static_cast<float>(0.9 / *std::max_element(radiance.begin(), radiance.end()));
        for (Light& light : lights) light.intensity *= scale;
        radiance = truth::referenceImage(material, geometry_, lights, stage_.view);
        for (const Format& format : kFormats) {
            if (!floatTargets_ && format.format != OffscreenFormat::rgba8) continue;
            for (const Technique technique : allTechniques()) {
                AccuracyRow row = drawn(*gpu, lights, format, technique, radiance);
                row.form = form;
                rows.push_back(std::move(row));
            }
        }
    }

private:
    AccuracyRow drawn(const gl::GpuMaterial& material, const std::vector<Light>& lights,
                      const Format& format, Technique technique, const std::vector<double>& exact)
    {
        Offscreen offscreen(context_.loader(), {kSize, kSize, format.format});
        offscreen.clear();
        const auto stats = renderer_.draw({offscreen.framebuffer(), kSize, kSize}, stage_.view,
                                          {{&material, mesh_.get()}}, lights, {technique, 8, 0});
        if (stats.itemsFailed > 0)
            throw Error(ErrorKind::gl, "runtime", "found an object that cannot be drawn");
        const Capabilities& c = renderer_.capabilities();
        const bool isEs = c.glsl == 100 || c.glsl == 300;
        return {fmt::format("{}.{} {}{}{}", c.glMajor, c.glMinor, isEs ? "ES " : "GLSL ", c.glsl,
                            floatTargets_ ? "" : " RGBA8"),
                "",
                techniqueName(technique),
                format.name,
                static_cast<int>(lights.size()),
                stats.passes,
                stats.error,
                truth::deviationOf(offscreen.readPixels(), exact, stats.error),
                stats.whyReplaced};
    }

    HeadlessContext context_;
    gl::Renderer renderer_;
    bool floatTargets_;
    const Stage& stage_;
    const truth::GeometryBuffer& geometry_;
    std::shared_ptr<gl::GpuMesh> mesh_;
};

}  // namespace

bool Accuracy::holds() const
{
    return std::all_of(rows.begin(), rows.end(),
                       [](const AccuracyRow& row) { return row.found.share <= 1.0; });
}

Accuracy measureAccuracy(const Options& options)
{
    const std::vector<std::string> all{"hdio",      "pqp",          "pqpr",
                                       "io+hdio",   "pqp cube",     "pqp parabolic",
                                       "pqpr cube", "hdio precise", "pqpr precise"};
    const auto& forms = options.only.empty() ? all : options.only;
    const Stage stage = makeStage("sphere", 1.0);
    const truth::GeometryBuffer geometry = geometryOf(stage, options.device);
    Accuracy result;
    for (const Version& version : versions(options.device)) {
        try {
            Bench bench(version, stage, geometry);
            result.glRenderer = bench.renderer().glRenderer();
            for (const std::string& form : forms)
                for (const int count : options.lights) bench.measure(form, count, result.rows);
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
    std::string text = fmt::format(
        "{}, {}x{} pixels, against double\n{:<18} {:<13} {:<11} {:<8} {:>6} {:>6} {:>9} {:>9} "
        "{:>9} {:>9} {:>6}\n",
        accuracy.glRenderer, kSize, kSize, "version", "form", "technique", "format", "lights",
        "passes", "relative", "bound", "absolute", "bound", "share");
    for (const AccuracyRow& row : accuracy.rows)
        text += fmt::format(
            "{:<18} {:<13} {:<11} {:<8} {:>6} {:>6} {:>9.1e} {:>9.1e} {:>9.1e} {:>9.1e} "
            "{:>6.2f}{}\n",
            row.version, row.form, row.technique, row.format, row.lights, row.passes,
            row.found.relative, row.bound.relative, row.found.absolute, row.bound.absolute,
            row.found.share, row.whyReplaced.empty() ? "" : "  replaced: " + row.whyReplaced);
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
