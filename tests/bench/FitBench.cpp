// fbrdf-fit-bench: seconds of fits, reading apart, and how they grow. Every figure that the
// documentation states about the speed and memory of the fitter comes from here.
#include <fbrdf/brdf/Error.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/fit/SampleSets.h>
#include <fbrdf/sources/Source.h>
#include <fbrdf/sources/Write.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
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

struct Timing {
    double seconds = 0.0, cpu = 0.0;  ///< of the fit, and of the process during it and its report
};

double cpuSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double peakMegabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

Timing timed(const Source& source, const FitOptions& options)
{
    const double before = cpuSeconds();
    const FitResult result = fitMaterial(source, options);
    return {result.summary.seconds, cpuSeconds() - before};
}

// The fastest of several: what other processes take is no part of the figure.
Timing best(const Settings& settings, const Source& source, const FitOptions& options)
{
    Timing least{1e9, 1e9};
    for (int i = 0; i < settings.repeat; ++i) {
        const Timing t = timed(source, options);
        if (t.seconds < least.seconds) least = t;
    }
    return least;
}

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

void print(const std::string& what, const Timing& timing, const std::string& more = "")
{
    fmt::print("{:<52} {:>9.3f} s  cpu {:>8.3f} s  {}\n", what, timing.seconds, timing.cpu, more);
    std::fflush(stdout);
}

void benchMerl(const Settings& settings)
{
    const TemporaryFile file(".binary");
    writeMerl(openSource(kPlastic), file.path());
    const Source source = openSource(file.path());
    print("MERL grid, RGB, hdio, plain, cold", best(settings, source, formOptions("hdio", false)));
    FitOptions cached = formOptions("hdio", false);
    cached.cache = makeFitCache();
    timed(source, cached);
    print("MERL grid, RGB, hdio, plain, grid cached", best(settings, source, cached));
    print("MERL grid, RGB, hdio, robust", best(settings, source, formOptions("hdio", true)));
    for (const bool robust : {false, true}) {
        FitOptions options = formOptions("hdio", robust);
        options.cache = makeFitCache();
        Timing sum;
        for (int i = 0; i < settings.materials; ++i) {
            const Timing t = timed(source, options);
            sum.seconds += t.seconds;
            sum.cpu += t.cpu;
        }
        print(
            fmt::format("{} MERL grids, hdio, {}", settings.materials, robust ? "robust" : "plain"),
            sum);
    }
    print("MERL grid, RGB, auto", timed(source, formOptions("auto", true)));
}

void benchScattered(const Settings& settings)
{
    const Source source =
        scattered(openSource("ggx:alpha_x=0.1,alpha_y=0.4,f0=0.9/0.7/0.4,kd=0"), 150000);
    FitOptions options = formOptions("pqp", false);
    options.resolution = 64;
    print("150,000 scattered samples, RGB, pqp 64 x 64, plain", best(settings, source, options));
}

void writeColumns(const Source& function, uint64_t rows, const std::string& path)
{
    constexpr size_t kBlock = 1 << 16;  // pairs that are written again and again
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
    const TemporaryFile file(".f32c");
    writeColumns(openSource(kPlastic), settings.rows, file.path());
    const Source source = openSource(file.path());
    for (const bool robust : {false, true}) {
        const Timing t = timed(source, formOptions("hdio", robust));
        print(fmt::format("{} streamed rows, hdio, {}", settings.rows, robust ? "robust" : "plain"),
              t,
              fmt::format("{:.2f} M rows/s, peak {:.0f} MB",
                          static_cast<double>(settings.rows) / t.seconds / 1e6, peakMegabytes()));
    }
}

void benchGrowth(const Settings& settings)
{
    const Source plastic = openSource(kPlastic);
    for (const size_t count : {10000, 40000, 160000, 640000, 2560000})
        print(fmt::format("{} samples, hdio, plain", count),
              best(settings, scattered(plastic, count), formOptions("hdio", false)));
    const Source samples = scattered(plastic, 160000);
    for (const char* form : {"hdio", "pqp"})
        for (const int resolution : {16, 32, 48, 64, 96, 128}) {
            FitOptions options = formOptions(form, false);
            options.resolution = resolution;
            print(fmt::format("160,000 samples, {} of {}", form, resolution),
                  best(settings, samples, options));
        }
}

using Bench = std::pair<const char*, void (*)(const Settings&)>;
constexpr Bench kBenches[] = {{"merl", benchMerl},
                              {"scattered", benchScattered},
                              {"columns", benchColumns},
                              {"growth", benchGrowth}};

}  // namespace
}  // namespace fbrdf

int main(int argc, char** argv)
{
    CLI::App app("Seconds of fits, reading apart; cpu counts the held-out errors as well.");
    fbrdf::Settings settings;
    app.add_option("--only", settings.only, "merl, scattered, columns, growth; default all")
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
