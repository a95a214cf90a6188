#include "bench/EnvironmentCost.h"

#include "bench/GgxEnvironment.h"
#include "bench/Materials.h"
#include "bench/Print.h"
#include "bench/Turns.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/scene/Stats.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace fbrdf::bench {
namespace {

const char* const kPeerName = "ggx, split sum";

/// A table of so many lobes: its numbers do not change the cost, so those of one fit are split.
LobeTable withLobes(const LobeTable& fitted, int lobes)
{
    LobeTable table = fitted;
    table.lobes = lobes;
    for (LobeKnot& knot : table.knots)
        for (size_t k = 1; k < static_cast<size_t>(lobes); ++k) {
            knot.lobes[k] = knot.lobes[0];
            knot.lobes[k].level *= 0.5f;
            knot.lobes[k].weight *= 0.1f;
        }
    return table;
}

/// `count` spheres, or rectangles, on the viewer's side.
std::vector<AreaLight> areaLights(int count, AreaLight::Shape shape)
{
    std::vector<AreaLight> lights;
    for (const Light& light : stageLights(count)) {
        AreaLight area;
        area.shape = shape;
        area.position = light.position;
        area.size = 0.3f;
        const Vec3f towards = glm::normalize(-light.position);
        area.axisU = 0.3f * glm::normalize(glm::cross(towards, Vec3f(0.1f, 1.0f, 0.2f)));
        area.axisV = 0.3f * glm::normalize(glm::cross(towards, area.axisU));
        area.radiance = light.intensity;
        lights.push_back(area);
    }
    return lights;
}

class Cost {
public:
    Cost(const Options& options, const std::string& mesh)
        : rig_(options),
          scene_(rig_.scene(makeStage(mesh, double(options.width) / options.height), {})),
          environment_(rig_.renderer.createEnvironment(proceduralEnvironment("studio", 512))),
          mesh_(rig_.renderer.createMesh(scene_.stage.mesh)),
          material_(benchMaterial("hdio")),
          fitted_(fitLobes(material_, {1, 3, 24, 0}))
    {
        result_ = {rig_.renderer.glRenderer(),
                   rig_.renderer.glVersion(),
                   mesh,
                   options.width,
                   options.height,
                   options.clock,
                   {}};
    }

    EnvironmentMeasurement measured()
    {
        const auto peer =
            std::make_shared<const GgxEnvironment>(rig_.gl, scene_.stage, environment_);
        add(kPeerName, 0, 3, [this, peer] { peer->draw(scene_.target); });
        gl::DrawOptions options;
        options.environment.map = environment_.get();
        for (const int lobes : {1, 2, 3}) {
            options.technique = Technique::single;
            addRuntime(fmt::format("K = {}, single", lobes), lobes, options);
        }
        options.technique = Technique::twoLookup;
        for (const int lobes : {1, 2})
            addRuntime(fmt::format("K = {}, two-lookup", lobes), lobes, options);
        options = {};
        for (const auto shape : {AreaLight::Shape::sphere, AreaLight::Shape::rectangle})
            for (const int count : {1, 4, 16}) {
                options.areaLights = areaLights(count, shape);
                addRuntime(fmt::format("K = 2, {} {}s", count, shapeName(shape)), 2, options);
            }
        time(rig_, runs_);
        for (size_t i = 0; i < runs_.size(); ++i) {
            EnvironmentRow& row = result_.rows[i];
            row.milliseconds = scene::spreadOf(runs_[i].frames).median;
            row.ratio = row.milliseconds / result_.rows[0].milliseconds;
        }
        return result_;
    }

private:
    void add(const std::string& name, int passes, int lookups, Draw draw)
    {
        result_.rows.push_back({name, 0.0, 0.0, passes, lookups});
        runs_.push_back({name, std::move(draw)});
    }

    void addRuntime(const std::string& name, int lobes, const gl::DrawOptions& options)
    {
        Material material = material_;
        material.lobes = withLobes(fitted_, lobes);
        const std::shared_ptr<gl::GpuMaterial> gpu = rig_.renderer.createMaterial(material);
        const auto draw = [this, gpu, options] {
            const auto stats = rig_.renderer.draw(scene_.target, scene_.stage.view,
                                                  {{gpu.get(), mesh_.get()}}, {}, options);
            if (stats.itemsFailed > 0 || stats.itemsWithoutEnvironment > 0)
                throw Error(ErrorKind::gl, "runtime",
                            "cannot draw lobes: " + stats.whyNoEnvironment);
            return stats;
        };
        const auto stats = draw();
        add(name, stats.passes, stats.maxLookups, [draw] { draw(); });
    }

    Rig rig_;
    Scene scene_;
    std::shared_ptr<gl::GpuEnvironment> environment_;
    std::shared_ptr<gl::GpuMesh> mesh_;
    Material material_;
    LobeTable fitted_;
    std::vector<Run> runs_;
    EnvironmentMeasurement result_;
};

}  // namespace

std::vector<EnvironmentMeasurement> measureEnvironment(const Options& options)
{
    std::vector<EnvironmentMeasurement> result;
    for (const std::string& mesh : options.meshes) result.push_back(Cost(options, mesh).measured());
    return result;
}

std::string asText(const std::vector<EnvironmentMeasurement>& measurements)
{
    std::string text;
    for (const EnvironmentMeasurement& m : measurements) {
        text += fmt::format(
            "{}{}, OpenGL {}, {}x{} pixels, {} time\n\n{}\n{:<24} {:>9} {:>6} {:>7} "
            "{:>9}\n",
            text.empty() ? "" : "\n", m.glRenderer, m.glVersion, m.width, m.height,
            clockName(m.clock), m.mesh, "", "ms", "ratio", "passes", "look-ups");
        for (const EnvironmentRow& row : m.rows)
            text += fmt::format("{:<24} {:>9.2f} {:>6.2f} {:>7} {:>9}\n", row.name,
                                row.milliseconds, row.ratio,
                                row.passes > 0 ? std::to_string(row.passes) : "1", row.lookups);
    }
    return text;
}

std::string asJson(const std::vector<EnvironmentMeasurement>& measurements)
{
    auto list = nlohmann::ordered_json::array();
    for (const EnvironmentMeasurement& m : measurements) {
        auto rows = nlohmann::ordered_json::array();
        for (const EnvironmentRow& row : m.rows)
            rows.push_back({{"name", row.name},
                            {"milliseconds", row.milliseconds},
                            {"ratio", row.ratio},
                            {"passes", std::max(1, row.passes)},
                            {"lookups", row.lookups}});
        list.push_back({{"renderer", m.glRenderer},
                        {"version", m.glVersion},
                        {"size", {m.width, m.height}},
                        {"clock", clockName(m.clock)},
                        {"mesh", m.mesh},
                        {"rows", rows}});
    }
    return list.dump(2) + "\n";
}

}  // namespace fbrdf::bench
