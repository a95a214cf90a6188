// fbrdf sample, fbrdf pdf: directions in proportion to what a material reflects, and the density
// with which they are drawn.
#include "Arguments.h"
#include "Commands.h"
#include "EvalStream.h"
#include "Output.h"
#include "Progress.h"
#include "Reflectance.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace fbrdf::tool {
namespace {

struct SampleCommand {
    std::string source, wo;
    SourceOptions sourceOptions;
    uint64_t count = 0, seed = 1;
    int threads = 0;
};

struct PdfCommand {
    std::string source, pairs;
    SourceOptions sourceOptions;
    int threads = 0;
};

/// A reflectance and the lobes it is sampled by: those of its file, or fitted now.
struct Sampled {
    Reflectance opened;
    LobeTable lobes;
};

Sampled openSampled(const std::string& spec, const SourceOptions& options, int threads)
{
    Sampled sampled{openReflectance(spec, options, Precision::shader), {}};
    requireFunction(sampled.opened, spec);
    sampled.lobes = lobesOf(sampled.opened, threads);
    return sampled;
}

Vec3d viewFromText(const std::string& text)
{
    Vec3d wo(0.0);
    const char *at = text.data(), *const end = text.data() + text.size();
    for (int k = 0; k < 3; ++k) {
        const auto parsed = std::from_chars(at, end, wo[k]);
        const bool ends = k == 2 ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == ',';
        if (parsed.ec != std::errc() || !ends || !std::isfinite(wo[k])) {
            wo.z = 0.0;
            break;
        }
        at = parsed.ptr + 1;
    }
    if (!(wo.z > 0.0))
        throw Error(ErrorKind::usage, "--wo",
                    Found("'" + text + "'").expected("x,y,z of a direction with z > 0"));
    return glm::normalize(wo);
}

/// Numbers in [0, 1) that cover the square evenly, shifted by the seed.
Vec2<double> evenNumbers(uint64_t index, uint64_t seed)
{
    constexpr double kUnit = 1.0 / 18446744073709551616.0;  // 2^-64
    // Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2: the powers of
    // the inverse of the plastic number.
    const auto shifted = [&](double step, uint64_t salt) {
        const double shift = static_cast<double>(splitMix64(seed + salt) >> 11) * (kUnit * 2048.0);
        const double turns = step * static_cast<double>(index) + shift;
        return std::min(turns - std::floor(turns), 1.0 - 1e-12);
    };
    return {shifted(0.7548776662466927, 1), shifted(0.5698402909980532, 2)};
}

int runSample(const SampleCommand& command)
{
    const Vec3d wo = viewFromText(command.wo);
    const Sampled sampled = openSampled(command.source, command.sourceOptions, command.threads);
    writeOut("wi_x,wi_y,wi_z,pdf,r,g,b\n");
    constexpr uint64_t kRowsAtOnce = 4096;
    std::string rows;
    for (uint64_t i = 0; i < command.count; ++i) {
        const auto sample = sampleLobes(sampled.lobes, wo, evenNumbers(i, command.seed));
        const Vec3d f = sample.wi.z > 0.0 ? sampled.opened.brdf(wo, sample.wi) : Vec3d(0.0);
        fmt::format_to(std::back_inserter(rows),
                       "{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", sample.wi.x,
                       sample.wi.y, sample.wi.z, sample.pdf, f.x, f.y, f.z);
        if ((i + 1) % kRowsAtOnce != 0 && i + 1 != command.count) continue;
        writeOut(rows);
        rows.clear();
    }
    return 0;
}

int runPdf(const PdfCommand& command)
{
    const Sampled sampled = openSampled(command.source, command.sourceOptions, command.threads);
    LineBlocks blocks(command.pairs);
    const auto density = [&](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(wo.z > 0.0 ? lobePdf(sampled.lobes, wo, wi) : 0.0);
    };
    bool any = false;
    const auto writeHeader = [&] {
        if (!any) writeOut("pdf\n");
        any = true;
    };
    evaluateStream(blocks, {density, RowStyle::number, command.threads, [&](std::string_view rows) {
                                writeHeader();
                                writeOut(rows);
                            }});
    writeHeader();
    return 0;
}

}  // namespace

void addSampleCommand(CLI::App& app, Action& action)
{
    CLI::App* sub =
        app.add_subcommand("sample", "directions in proportion to what a material reflects");
    const auto command = std::make_shared<SampleCommand>();
    sub->add_option("MATERIAL", command->source, "material, file, or model NAME:key=value,...")
        ->required();
    sub->add_option("--wo", command->wo, "direction to the viewer; need not be unit")
        ->required()
        ->type_name("x,y,z");
    addInteger(*sub, "--count", command->count, 1, uint64_t(1) << 40, "how many")
        ->required()
        ->type_name("N");
    addInteger(*sub, "--seed", command->seed, 0, ~uint64_t(0), "another seed, other directions (1)")
        ->type_name("S");
    addCosine(*sub, command->sourceOptions);
    addThreads(*sub, command->threads);
    sub->callback([command, &action] { action = [command] { return runSample(*command); }; });
}

void addPdfCommand(CLI::App& app, Action& action)
{
    CLI::App* sub =
        app.add_subcommand("pdf", "the density in 1/sr with which sample draws a direction");
    const auto command = std::make_shared<PdfCommand>();
    sub->add_option("MATERIAL", command->source, "material, file, or model NAME:key=value,...")
        ->required();
    sub->add_option("--pairs", command->pairs,
                    "CSV with columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z; - is standard input")
        ->required()
        ->type_name("FILE|-");
    addCosine(*sub, command->sourceOptions);
    addThreads(*sub, command->threads);
    sub->callback([command, &action] { action = [command] { return runPdf(*command); }; });
}

}  // namespace fbrdf::tool
