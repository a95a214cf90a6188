#include "bench/Reach.h"

#include "bench/Materials.h"
#include "bench/Print.h"
#include "bench/Turns.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightClusters.h>
#include <fbrdf/scene/Stats.h>

#include <fmt/format.h>
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

Draw drawing(const Scene& scene, const gl::DrawOptions& options)
{
    const std::shared_ptr<gl::GpuMaterial> material =
        scene.renderer.createMaterial(ggxMaterial("hdio"));
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

ReachRow measuredRow(Rig& rig, int reaching, double aspect)
{
    const Scene many = rig.scene(makeStage("triangle", aspect), spreadLights(reaching, aspect)),
                few = rig.scene(makeStage("triangle", aspect), stageLights(reaching));
    const auto vectors = inEyeSpace(many);
    ClusterBuilder builder;
    MovingView view(many.stage.view);
    gl::DrawOptions listed;
    listed.clustered = true;
    std::vector<Run> runs;
    runs.push_back({"clustered", drawing(many, listed)});
    runs.push_back({"one list", drawing(few, {})});
    runs.push_back(
        {"building", [&] { builder.update(vectors, glm::dmat4(view.next().projection)); }, false});
    time(rig, runs);
    const Averages averages = averagesOf(many, builder.clusters(), aspect);
    const auto median = [&](size_t run) { return scene::spreadOf(runs[run].frames).median; };
    return {reaching, averages.reaching, averages.listed, median(0), median(2), median(1)};
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
                            {}};
    for (const int reaching : options.lights)
        result.rows.push_back(measuredRow(rig, reaching, double(options.width) / options.height));
    return result;
}

std::string asText(const ReachMeasurement& m)
{
    std::string text = fmt::format(
        "{}, OpenGL {}, {}x{} pixels, {} time\n\n{} lights with a radius: ms a frame\n"
        "{:>8} {:>9} {:>9} {:>10} {:>10} {:>10} {:>6}\n",
        m.glRenderer, m.glVersion, m.width, m.height, clockName(m.clock), kReachLights, "wanted",
        "reaching", "listed", "clustered", "of these", "one list", "ratio");
    for (const ReachRow& row : m.rows)
        text += fmt::format("{:>8} {:>9.1f} {:>9.1f} {:>10.2f} {:>10.2f} {:>10.2f} {:>6.2f}\n",
                            row.wanted, row.reaching, row.listed, row.clustered, row.building,
                            row.oneList, row.clustered / row.oneList);
    return text +
           "reaching, listed: lights, of an average pixel; of these: to build the lists; one "
           "list: of as many lights as wanted\n";
}

std::string asJson(const ReachMeasurement& m)
{
    auto rows = nlohmann::ordered_json::array();
    for (const ReachRow& row : m.rows)
        rows.push_back({{"wanted", row.wanted},
                        {"reaching", row.reaching},
                        {"listed", row.listed},
                        {"clustered", row.clustered},
                        {"building", row.building},
                        {"one_list", row.oneList},
                        {"ratio", row.clustered / row.oneList}});
    return nlohmann::ordered_json{{"renderer", m.glRenderer},    {"version", m.glVersion},
                                  {"size", {m.width, m.height}}, {"clock", clockName(m.clock)},
                                  {"lights", kReachLights},      {"rows", rows}}
               .dump(2) +
           "\n";
}

}  // namespace fbrdf::bench
