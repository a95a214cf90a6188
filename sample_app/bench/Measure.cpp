#include "bench/Measure.h"

#include "viewer/FrameTimer.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/scene/Stats.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

namespace fbrdf::bench {
namespace {

constexpr int kMostFrames = 15, kFewestFrames = 3;
// Of one variant with one number of lights: enough frames of what is fast, few of what is slow.
constexpr double kBudgetMilliseconds = 600.0;

gl::RendererOptions rendererOptions(const HeadlessContext& context)
{
    gl::RendererOptions options;
    options.load = context.loader();
    return options;
}

/// CPU time of all threads of this process.
double cpuMilliseconds()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Run {
    const Variant* variant;
    Draw draw;
    std::vector<double> frames;
    double spent = 0.0;

    bool wantsMore() const
    {
        const auto count = static_cast<int>(frames.size());
        return count < kFewestFrames || (count < kMostFrames && spent < kBudgetMilliseconds);
    }
};

class Bench {
public:
    explicit Bench(const Options& options)
        : options_(options),
          context_(HeadlessOptions{}),
          gl_(viewer::loadGlFunctions(context_.loader())),
          renderer_(rendererOptions(context_)),
          offscreen_(context_.loader(), {options.width, options.height}),
          timer_(context_.loader()),
          variants_(chosen(options.only))
    {
    }

    Measurement measured()
    {
        Measurement result{renderer_.glRenderer(), renderer_.glVersion(), options_.width,
                           options_.height,        options_.clock,        {}};
        for (const std::string& mesh : options_.meshes) {
            before_.clear();
            for (const int lights : options_.lights) result.tables.push_back(table(mesh, lights));
        }
        return result;
    }

private:
    static std::vector<Variant> chosen(const std::vector<std::string>& names)
    {
        std::vector<Variant> all = allVariants(), result;
        if (names.empty()) return all;
        for (const std::string& name : names) {
            const auto found = std::find_if(all.begin(), all.end(),
                                            [&](const Variant& v) { return v.name == name; });
            if (found == all.end())
                throw Error(ErrorKind::usage, "--only",
                            "found '" + name + "', expected a variant such as 'hdio single'");
            result.push_back(*found);
        }
        return result;
    }

    Table table(const std::string& mesh, int lights)
    {
        const Scene scene{gl_,
                          renderer_,
                          makeStage(mesh, double(options_.width) / options_.height),
                          stageLights(lights),
                          {offscreen_.framebuffer(), options_.width, options_.height}};
        Table result{mesh, lights, {}, {}};
        std::vector<Run> runs;
        for (const Variant& variant : variants_) {
            const double expected = expectedMilliseconds(variant.name, lights);
            if (expected > options_.frameLimit)
                result.leftOut.push_back(
                    {variant.name,
                     "about " + std::to_string(std::lround(expected)) + " ms a frame"});
            else
                runs.push_back({&variant, variant.make(scene), {}});
        }
        for (Run& run : runs) frame(run);  // drivers compile what they need while they draw
        for (Run& run : runs) run.frames.clear(), run.spent = 0.0;
        while (round(runs)) {
        }
        for (const Run& run : runs) addTiming(run, result);
        for (const Timing& timing : result.timings)
            before_[timing.variant] = {timing.milliseconds, lights};
        return result;
    }

    /// From the last number of lights; 0 where nothing is known.
    double expectedMilliseconds(const std::string& variant, int lights) const
    {
        const auto known = before_.find(variant);
        if (known == before_.end()) return 0.0;
        return known->second.first * lights / known->second.second;
    }

    void frame(Run& run)
    {
        timer_.begin();
        const double before = cpuMilliseconds();
        offscreen_.clear();
        run.draw();
        const double wall = timer_.end(), cpu = cpuMilliseconds() - before;
        run.frames.push_back(options_.clock == Options::Clock::cpu ? cpu : wall);
        run.spent += wall;
    }

    bool round(std::vector<Run>& runs)
    {
        bool any = false;
        for (Run& run : runs) {
            if (!run.wantsMore()) continue;
            frame(run);
            any = true;
        }
        return any;
    }

    static void addTiming(const Run& run, Table& table)
    {
        const double median = scene::spreadOf(run.frames).median;
        double ratio = 0.0;
        for (const Timing& other : table.timings)
            if (other.variant == "ggx") ratio = median / other.milliseconds;
        if (run.variant->name == "ggx") ratio = 1.0;
        table.timings.push_back(
            {run.variant->name, median, ratio, static_cast<int>(run.frames.size())});
    }

    const Options& options_;
    HeadlessContext context_;
    GladGLContext gl_;
    gl::Renderer renderer_;
    Offscreen offscreen_;
    viewer::FrameTimer timer_;
    std::vector<Variant> variants_;
    std::map<std::string, std::pair<double, int>> before_;
};

}  // namespace

Measurement measure(const Options& options)
{
    return Bench(options).measured();
}

}  // namespace fbrdf::bench
