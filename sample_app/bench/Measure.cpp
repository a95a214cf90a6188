#include "bench/Measure.h"

#include "bench/Turns.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Stats.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace fbrdf::bench {
namespace {

class Comparison {
public:
    explicit Comparison(const Options& options)
        : options_(options), rig_(options), variants_(chosen(options.only))
    {
    }

    Measurement measured()
    {
        Measurement result{rig_.renderer.glRenderer(),
                           rig_.renderer.glVersion(),
                           options_.width,
                           options_.height,
                           options_.clock,
                           {}};
        for (const std::string& mesh : options_.meshes) {
            before_.clear();
            for (const int lights : options_.lights) result.tables.push_back(table(mesh, lights));
        }
        return result;
    }

private:
    static std::vector<Variant> chosen(const std::vector<std::string>& names)
    {
        if (names.empty()) return allVariants();
        std::vector<Variant> result;
        for (const std::string& name : names)
            for (Variant& variant : variantsNamed(name)) result.push_back(std::move(variant));
        return result;
    }

    Table table(const std::string& mesh, int lights)
    {
        const Scene scene = rig_.scene(makeStage(mesh, double(options_.width) / options_.height),
                                       stageLights(lights));
        Table result{mesh, lights, {}, {}};
        std::vector<Run> runs;
        for (const Variant& variant : variants_) {
            const double expected = expectedMilliseconds(variant.name, lights);
            if (expected > options_.frameLimit)
                result.leftOut.push_back(
                    {variant.name,
                     "about " + std::to_string(std::lround(expected)) + " ms a frame"});
            else
                runs.push_back({variant.name, variant.make(scene)});
        }
        time(rig_, runs);
        for (const Run& run : runs) {
            addTiming(run, result);
            const auto variant = std::find_if(variants_.begin(), variants_.end(),
                                              [&](const Variant& v) { return v.name == run.name; });
            result.timings.back().cost = variant->cost(scene);
        }
        for (const Timing& timing : result.timings)
            before_[timing.variant] = {timing.milliseconds, lights};
        return result;
    }

    /// An estimate from the last number of lights; 0 where nothing is known.
    double expectedMilliseconds(const std::string& variant, int lights) const
    {
        const auto known = before_.find(variant);
        if (known == before_.end()) return 0.0;
        return known->second.first * lights / known->second.second;
    }

    static void addTiming(const Run& run, Table& table)
    {
        const double median = scene::spreadOf(run.frames).median;
        double ratio = 0.0;
        for (const Timing& other : table.timings)
            if (other.variant == "ggx") ratio = median / other.milliseconds;
        if (run.name == "ggx") ratio = 1.0;
        table.timings.push_back({run.name, median, ratio, static_cast<int>(run.frames.size())});
    }

    const Options& options_;
    Rig rig_;
    std::vector<Variant> variants_;
    std::map<std::string, std::pair<double, int>> before_;
};

}  // namespace

Measurement measure(const Options& options)
{
    return Comparison(options).measured();
}

}  // namespace fbrdf::bench
