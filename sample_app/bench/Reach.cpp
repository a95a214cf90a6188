#include "bench/Reach.h"

#include "bench/Materials.h"
#include "bench/Print.h"
#include "bench/Turns.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightClusters.h>
#include <fbrdf/scene/Stats.h>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <memory>
#include <random>

namespace fbrdf::bench {
namespace {

/// Lights spread evenly in front of [-aspect, aspect] x [-1, 1], the rectangle of the plane z = 0
/// that the picture shows. Each is half its radius away from the plane, so that `reaching` of them
/// reach a point.
std::vector<Light> spreadLights(int reaching, double aspect)
{
    // A disc of radius a covers a share pi a^2 / (4 aspect); a^2 = r^2 - (r / 2)^2.
    const double radius = std::sqrt(4.0 * aspect * reaching / (kPi * kReachLights) / (1.0 - 0.25));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f), colour(0.5f, 1.0f);
    std::vector<Light> lights(kReachLights);
    for (Light& light : lights) {
        const float x = place(random) * static_cast<float>(aspect), y = place(random);
        light.position = {x, y, static_cast<float>(0.5 * radius)};
        light.radius = static_cast<float>(radius);
        light.intensity = 0.01f * Vec3f(colour(random), colour(random), colour(random));
    }
    return lights;
}

std::vector<LightVectors> inEyeSpace(const Scene& scene)
{
    std::vector<LightVectors> vectors;
    for (const Light& light : scene.lights)
        vectors.push_back(lightVectors(light, glm::dmat4(scene.stage.view.view)));
    return vectors;
}

/// The same lights as spots that shine at the plane, 0.5 rad to each side and up to 45 degrees
/// aslant.
std::vector<LightVectors> spotsInEyeSpace(const Scene& scene)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> slope(-0.7f, 0.7f);
    std::vector<LightVectors> vectors;
    for (Light light : scene.lights) {
        light.type = Light::Type::spot;
        light.axis = {slope(random), slope(random), -1.0f};
        light.innerAngle = 0.2f;
        light.outerAngle = 0.5f;
        vectors.push_back(lightVectors(light, glm::dmat4(scene.stage.view.view)));
    }
    return vectors;
}

struct Averages {
    double reaching = 0.0, listed = 0.0;
};

/// Averages over every `kStep`th pixel of the stage's plane in both directions.
Averages averagesOf(const Scene& scene, const LightClusters& clusters, double aspect)
{
    constexpr int kStep = 8;
    const glm::dmat4 toEye(scene.stage.view.view);
    Averages sums;
    int count = 0;
    for (int y = kStep / 2; y < scene.target.height; y += kStep)
        for (int x = kStep / 2; x < scene.target.width; x += kStep) {
            const glm::dvec2 ndc((2.0 * x + 1.0) / scene.target.width - 1.0,
                                 (2.0 * y + 1.0) / scene.target.height - 1.0);
            const Vec3d point(ndc.x * aspect, ndc.y, 0.0);
            for (const Light& light : scene.lights)
                sums.reaching +=
                    glm::distance(Vec3d(light.position), point) < double(light.radius) ? 1 : 0;
            sums.listed += lightList(clusters, ndc, -(toEye * glm::dvec4(point, 1.0)).z).count;
            ++count;
        }
    return {sums.reaching / count, sums.listed / count};
}

/// A view that depth alone tells from the last one, as if the camera moved: lists are made anew.
class MovingView {
public:
    explicit MovingView(const gl::View& view) : view_(view) {}
    const gl::View& next()
    {
        view_.projection[2][2] *= forward_ ? 1.0f + 1e-6f : 1.0f / (1.0f + 1e-6f);
        forward_ = !forward_;
        return view_;
    }

private:
    gl::View view_;
    bool forward_ = true;
};

gl::DrawOptions listsBy(gl::ListsBy who)
{
    gl::DrawOptions options;
    options.clustered = true;
    options.listsBy = who;
    return options;
}

/// Small steps, to and fro, of some lights spread over all.
class MovingLights {
public:
    explicit MovingLights(std::vector<LightVectors> lights) : lights_(std::move(lights)) {}
    const std::vector<LightVectors>& next()
    {
        const float step = forward_ ? 0.003f : -0.003f;
        for (size_t i = 0; i < lights_.size(); i += lights_.size() / kMovingLights)
            lights_[i][0].x += step;
        forward_ = !forward_;
        return lights_;
    }

private:
    std::vector<LightVectors> lights_;
    bool forward_ = true;
};

Draw drawing(const Scene& scene, const gl::DrawOptions& options)
{
    const std::shared_ptr<gl::GpuMaterial> material =
        scene.renderer.createMaterial(benchMaterial("hdio"));
    const std::shared_ptr<gl::GpuMesh> mesh = scene.renderer.createMesh(scene.stage.mesh);
    const auto view = std::make_shared<MovingView>(scene.stage.view);
    return [material, mesh, options, view, &scene] {
        const auto stats = scene.renderer.draw(
            scene.target, view->next(), {{material.get(), mesh.get()}}, scene.lights, options);
        if (stats.itemsFailed > 0 || !stats.whyReplaced.empty())
            throw Error(ErrorKind::gl, "runtime",
                        "cannot draw lists of lights: " + stats.whyReplaced);
    };
}

/// Why the GPU makes no lists in the rig's context; "" where it does.
std::string whyNotByGpu(Rig& rig)
{
    const Scene scene = rig.scene(makeStage("triangle", 1.0), spreadLights(4, 1.0));
    const auto material = scene.renderer.createMaterial(benchMaterial("hdio"));
    const auto mesh = scene.renderer.createMesh(scene.stage.mesh);
    return scene.renderer
        .draw(scene.target, scene.stage.view, {{material.get(), mesh.get()}}, scene.lights,
              listsBy(gl::ListsBy::gpu))
        .whyListsByCpu;
}

ReachRow measuredRow(Rig& rig, int reaching, double aspect, bool hasGpuLists)
{
    const Scene many = rig.scene(makeStage("triangle", aspect), spreadLights(reaching, aspect)),
                few = rig.scene(makeStage("triangle", aspect), stageLights(reaching));
    const auto vectors = inEyeSpace(many), spots = spotsInEyeSpace(many);
    ClusterBuilder builder, editor, spotBuilder;
    MovingView view(many.stage.view), spotView(many.stage.view);
    MovingLights moving(vectors);
    const glm::dmat4 projection(many.stage.view.projection);
    std::vector<Run> runs;
    runs.push_back({"clustered", drawing(many, listsBy(gl::ListsBy::cpu))});
    runs.push_back({"one list", drawing(few, {})});
    runs.push_back(
        {"building", [&] { builder.update(vectors, glm::dmat4(view.next().projection)); }, false});
    runs.push_back({"editing", [&] { editor.update(moving.next(), projection); }, false});
    runs.push_back({"spots",
                    [&] { spotBuilder.update(spots, glm::dmat4(spotView.next().projection)); },
                    false});
    if (hasGpuLists) runs.push_back({"by the GPU", drawing(many, listsBy(gl::ListsBy::gpu))});
    time(rig, runs);
    const Averages averages = averagesOf(many, builder.clusters(), aspect);
    const auto median = [&](size_t run) { return scene::spreadOf(runs[run].frames).median; };
    return {reaching,  averages.reaching, averages.listed, median(0),
            median(2), median(3),         median(4),       hasGpuLists ? median(5) : 0.0,
            median(1)};
}

/// Lights all around a camera that sees a twelfth of them.
CulledRow measuredCulling(Rig& rig)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::vector<LightVectors> lights;
    for (int i = 0; i < kCulledLights; ++i) {
        Light light;
        light.position = {50.0f * place(random), 2.0f * place(random), 50.0f * place(random)};
        light.radius = 0.7f;
        lights.push_back(lightVectors(light, glm::dmat4(1.0)));
    }
    gl::View camera;
    camera.projection = glm::perspective(glm::radians(18.5f), 16.0f / 9.0f, 0.1f, 50.0f);
    MovingView view(camera);
    ClusterBuilder builder;
    std::vector<Run> runs;
    runs.push_back(
        {"culling", [&] { builder.update(lights, glm::dmat4(view.next().projection)); }, false});
    time(rig, runs);
    return {lights.size(), builder.clusters().lights.size(),
            scene::spreadOf(runs[0].frames).median};
}

}  // namespace

ReachMeasurement measureReach(const Options& options)
{
    Rig rig(options);
    ReachMeasurement result{rig.renderer.glRenderer(),
                            rig.renderer.glVersion(),
                            options.width,
                            options.height,
                            options.clock,
                            {},
                            {},
                            whyNotByGpu(rig)};
    const double aspect = double(options.width) / options.height;
    for (const int reaching : options.lights)
        result.rows.push_back(measuredRow(rig, reaching, aspect, result.whyNotByGpu.empty()));
    result.culled = measuredCulling(rig);
    return result;
}

std::string asText(const ReachMeasurement& m)
{
    std::string text = fmt::format(
        "{}, OpenGL {}, {}x{} pixels, {} time\n\n{} lights with a radius: ms a frame\n"
        "{:>8} {:>9} {:>9} {:>10} {:>10} {:>8} {:>8} {:>10} {:>10} {:>6}\n",
        m.glRenderer, m.glVersion, m.width, m.height, clockName(m.clock), kReachLights, "wanted",
        "reaching", "listed", "clustered", "of these", "edited", "spots", "by GPU", "one list",
        "ratio");
    for (const ReachRow& row : m.rows)
        text += fmt::format(
            "{:>8} {:>9.1f} {:>9.1f} {:>10.2f} {:>10.2f} {:>8.2f} {:>8.2f} {:>10} {:>10.2f} "
            "{:>6.2f}\n",
            row.wanted, row.reaching, row.listed, row.clustered, row.building, row.editing,
            row.spots, row.byGpu > 0.0 ? fmt::format("{:.2f}", row.byGpu) : "none", row.oneList,
            row.clustered / row.oneList);
    text += fmt::format("\n{} lights of {} are seen: their lists take {:.2f} ms\n", m.culled.seen,
                        m.culled.given, m.culled.building);
    if (!m.whyNotByGpu.empty()) text += "no lists by the GPU: " + m.whyNotByGpu + "\n";
    return text +
           "reaching, listed: lights, of an average pixel; clustered: with lists of the CPU; of "
           "these: to make them anew; edited: where " +
           std::to_string(kMovingLights) +
           " lights have moved; spots: to make those of as many spots; by GPU: with lists of the "
           "GPU; one list: of as many lights as "
           "wanted\n";
}

std::string asJson(const ReachMeasurement& m)
{
    auto rows = nlohmann::ordered_json::array();
    for (const ReachRow& row : m.rows) {
        rows.push_back({{"wanted", row.wanted},
                        {"reaching", row.reaching},
                        {"listed", row.listed},
                        {"clustered", row.clustered},
                        {"building", row.building},
                        {"editing", row.editing},
                        {"spots", row.spots},
                        {"one_list", row.oneList},
                        {"ratio", row.clustered / row.oneList}});
        if (row.byGpu > 0.0) rows.back()["by_gpu"] = row.byGpu;
    }
    return nlohmann::ordered_json{{"renderer", m.glRenderer},
                                  {"version", m.glVersion},
                                  {"size", {m.width, m.height}},
                                  {"clock", clockName(m.clock)},
                                  {"lights", kReachLights},
                                  {"rows", rows},
                                  {"culled",
                                   {{"given", m.culled.given},
                                    {"seen", m.culled.seen},
                                    {"building", m.culled.building}}},
                                  {"why_not_by_gpu", m.whyNotByGpu}}
               .dump(2) +
           "\n";
}

}  // namespace fbrdf::bench
