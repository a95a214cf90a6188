// fbrdf-fit-bench: seconds of fits without reading, and how they grow with the data. Every figure
// in the documentation about the speed and memory of the fitter comes from here.
#include "FitTiming.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/fit/Clock.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/peers/Peer.h>
#include <fbrdf/sources/OpenSource.h>
#include <fbrdf/sources/Write.h>

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

constexpr char kPlastic[] = "ggx:alpha=0.1,f0=0.04,kd=0.3/0.2/0.1";

struct Settings {
    std::vector<std::string> only;
    int repeat = 3;
    uint64_t rows = 2000000;
    int materials = 100;
};

FitOptions formOptions(const std::string& form, bool robust)
{
    FitOptions options;
    options.form = form;
    options.robust = robust;
    return options;
}

class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& name)
        : path_((fs::temp_directory_path() / (std::to_string(getpid()) + name)).string())
    {
    }
    ~TemporaryFile() { fs::remove(path_); }
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

Source scattered(const Source& function, size_t count)
{
    Source source;
    source.name = function.name;
    source.format = "samples";
    source.isotropic = function.isotropic;
    source.samples = samplesAt(function, uniformPairs(count, 1), 0);
    return source;
}

// Many materials measured on one grid: seconds after 1, 3, 10, ... of them.
void benchMany(const Settings& settings, const Source& source, bool robust)
{
    FitOptions options = formOptions("hdio", robust);
    options.cache = makeFitCache();
    Timing sum;
    int next = 1;
    for (int i = 1; i <= settings.materials; ++i) {
        sum += timed(source, options);
        if (i != next && i != settings.materials) continue;
        print(fmt::format("{} MERL grids, hdio, {}", i, robust ? "robust" : "plain"), sum,
              fmt::format("{:.3f} s each", sum.seconds / i));
        next = next % 3 == 0 ? next / 3 * 10 : next * 3;
    }
}

void benchMerl(const Settings& settings)
{
    const TemporaryFile file(".binary");
    writeMerl(openSource(kPlastic), file.path());
    const Source source = openSource(file.path());
    print("MERL grid, RGB, hdio, plain, cold",
          best(settings.repeat, source, formOptions("hdio", false)));
    FitOptions cached = formOptions("hdio", false);
    cached.cache = makeFitCache();
    timed(source, cached);
    print("MERL grid, RGB, hdio, plain, grid cached", best(settings.repeat, source, cached));
    print("MERL grid, RGB, hdio, robust", best(settings.repeat, source, formOptions("hdio", true)));
    benchMany(settings, source, false);
    benchMany(settings, source, true);
    print("MERL grid, RGB, auto", best(settings.repeat, source, formOptions("auto", true)));
}

// The time that other methods need for the same table, in the same run.
void benchPeers(const Settings& settings)
{
    const TemporaryFile file(".binary");
    writeMerl(openSource(kPlastic), file.path());
    const Source source = openSource(file.path());
    const Timing ours = best(settings.repeat, source, formOptions("hdio", false));
    print("MERL grid, RGB, hdio, plain", ours);
    for (const Peer& peer : peers()) {
        PeerContext context;
        const auto fit = peer.fit(source, context);
        if (!fit || fit->seconds == 0.0) continue;
        fmt::print("{:<48} {:>8.3f} s  {:.1f} times hdio\n", "MERL grid, RGB, " + peer.title,
                   fit->seconds, fit->seconds / ours.seconds);
    }
    if (!peersLeftOut().empty()) fmt::print("{}\n", peersLeftOut());
}

void benchScattered(const Settings& settings)
{
    const Source source =
        scattered(openSource("ggx:alpha_x=0.1,alpha_y=0.4,f0=0.9/0.7/0.4,kd=0"), 150000);
    FitOptions options = formOptions("pqp", false);
    options.resolution = 64;
    print("150,000 scattered samples, RGB, pqp 64 x 64, plain",
          best(settings.repeat, source, options));
}

void writeColumns(const Source& function, uint64_t rows, const std::string& path)
{
    constexpr size_t kBlock = 1 << 16;  // pairs, which are written repeatedly
    const auto samples = samplesAt(function, uniformPairs(kBlock, 1), 0);
    std::ofstream file(path, std::ios::binary);
    file << "fbrdf-columns 1\nwo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b\n" << rows << "\n";
    std::vector<float> numbers;
    for (const Sample& s : samples)
        for (const Vec3f& v : {s.wo, s.wi, s.f}) numbers.insert(numbers.end(), {v.x, v.y, v.z});
    for (uint64_t row = 0; row < rows; row += kBlock) {
        const size_t count = std::min<uint64_t>(kBlock, rows - row);
        file.write(reinterpret_cast<const char*>(numbers.data()),
                   static_cast<std::streamsize>(count * 9 * sizeof(float)));
    }
}

void benchColumns(const Settings& settings)
{
    for (const uint64_t rows : {settings.rows / 4, settings.rows}) {
        const TemporaryFile file(".f32c");
        writeColumns(openSource(kPlastic), rows, file.path());
        const Source source = openSource(file.path());
        for (const bool robust : {false, true}) {
            const Timing t = timed(source, formOptions("hdio", robust));
            print(fmt::format("{} streamed rows, hdio, {}", rows, robust ? "robust" : "plain"), t,
                  fmt::format("{:.2f} M rows/s", static_cast<double>(rows) / t.seconds / 1e6));
        }
    }
}

void benchGrowth(const Settings& settings)
{
    const Source plastic = openSource(kPlastic);
    for (const size_t count :
         std::initializer_list<size_t>{10000, 30000, 100000, 300000, 1000000, 2900000})
        print(fmt::format("{} samples, hdio, plain", count),
              best(settings.repeat, scattered(plastic, count), formOptions("hdio", false)));
    const Source samples = scattered(plastic, 160000);
    for (const char* form : {"hdio", "pqp"})
        for (const int resolution : {16, 32, 48, 64, 96, 128}) {
            FitOptions options = formOptions(form, false);
            options.resolution = resolution;
            print(fmt::format("160,000 samples, {} of {}", form, resolution),
                  best(settings.repeat, samples, options));
        }
}

// A slider that is dragged: every fit is of another alpha, from the making of the source to the
// material, with the smoothness that the first fit chose.
void benchLive(const Settings& settings)
{
    constexpr int kSteps = 20;
    for (const char* form : {"io", "hdio", "hdpu", "hdsu"}) {
        FitOptions options = formOptions(form, true);
        options.heldOut = false;
        options.measured = 16384;  // as the window's fits
        options.cache = makeFitCache();
        const auto sourceAt = [](double alpha) {
            return openSource(fmt::format("ggx:alpha={},f0=0.04,kd=0.3/0.2/0.1", alpha));
        };
        options.smoothness = fitMaterial(sourceAt(0.2), options).summary.smoothness;
        double least = 1e9;
        for (int repeat = 0; repeat < settings.repeat; ++repeat) {
            const Clock clock;
            for (int i = 0; i < kSteps; ++i) fitMaterial(sourceAt(0.1 + 0.02 * i), options);
            least = std::min(least, clock.seconds() / kSteps);
        }
        fmt::print("{:<48} {:>8.3f} s  {:.1f} fits a second\n",
                   fmt::format("GGX with a dragged alpha, {}", form), least, 1.0 / least);
    }
}

using Bench = std::pair<const char*, void (*)(const Settings&)>;
constexpr Bench kBenches[] = {{"merl", benchMerl},       {"scattered", benchScattered},
                              {"columns", benchColumns}, {"growth", benchGrowth},
                              {"live", benchLive},       {"peers", benchPeers}};

}  // namespace
}  // namespace fbrdf

int main(int argc, char** argv)
{
    CLI::App app(
        "Seconds of fits and processor seconds of all threads, reading and errors apart; the most "
        "anonymous memory.");
    fbrdf::Settings settings;
    app.add_option("--only", settings.only,
                   "merl, scattered, columns, growth, live, peers; default all")
        ->delimiter(',');
    app.add_option("--repeat", settings.repeat, "fits of which the fastest counts");
    app.add_option("--rows", settings.rows, "of the streamed file: 36 bytes each");
    app.add_option("--materials", settings.materials, "of the run over many materials");
    CLI11_PARSE(app, argc, argv);
    try {
        for (const auto& [name, bench] : fbrdf::kBenches)
            if (settings.only.empty() ||
                std::count(settings.only.begin(), settings.only.end(), name) > 0)
                bench(settings);
    } catch (const fbrdf::Error& error) {
        fmt::print(stderr, "fbrdf-fit-bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
