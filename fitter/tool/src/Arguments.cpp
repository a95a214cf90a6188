#include "Arguments.h"

#include "PriorFile.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/FormFile.h>
#include <fbrdf/sources/OpenSource.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

namespace fbrdf::tool {
namespace {

constexpr uint64_t kMaxThreads = 1024;      // far above any machine this was written for
constexpr uint64_t kMaxResolution = 65536;  // the form knows its own limit; this is for the int
constexpr uint64_t kMaxLookups = 64;
constexpr uint64_t kMaxTerms = 64;  // as many as a form may have
constexpr uint64_t kAny = std::numeric_limits<uint64_t>::max();

// A file is read here, so that an error in it is reported before any work.
void setForm(FitOptions& options, const std::string& text)
{
    options.form = text;
    if (std::filesystem::path(text).extension() != ".json") return;
    options.formData = readForm(text);
    options.form = options.formData->name;
}

void setPrior(FitOptions& options, const std::string& text)
{
    options.usePrior = text != "none";
    if (text != "none" && text != "auto")
        options.prior = std::make_shared<TablePrior>(readPrior(text));
}

}  // namespace

uint64_t integerFromText(const std::string& where, const std::string& text, uint64_t lower,
                         uint64_t upper)
{
    uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || value < lower || value > upper)
        throw Error(ErrorKind::usage, where,
                    fmt::format(Found("'{}'").expected("a whole number {}"), text,
                                upper == kAny ? fmt::format("of at least {}", lower)
                                              : fmt::format("between {} and {}", lower, upper)));
    return value;
}

std::optional<double> smoothnessFromText(const std::string& text)
{
    if (text == "auto") return std::nullopt;
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value) || value <= 0.0)
        throw Error(ErrorKind::usage, "--smoothness",
                    Found("'" + text + "'").expected("auto or a number above 0"));
    return value;
}

void addThreads(CLI::App& command, int& threads)
{
    addInteger(command, "--threads", threads, 0, kMaxThreads, "threads; 0: one a core")
        ->type_name("T");
}

void addCosine(CLI::App& command, SourceOptions& options)
{
    command.add_flag("--cosine", options.cosine,
                     "the values of a CSV file include cos(theta_o): divide it out");
}

void addLobes(CLI::App& command, LobeFitOptions& options)
{
    addInteger(
        command, "--environment-lobes", options.lobes, 0, kMostTiltedLobes,
        "lobes for light from environments (2); of anisotropic materials 1, 3 or 7; 0: none are "
        "stored")
        ->type_name("K");
}

void addFitOptions(CLI::App& command, FitOptions& options)
{
    command
        .add_option_function<std::string>(
            "--form", [&options](const std::string& text) { setForm(options, text); },
            "form of the product (see fbrdf forms), a form as data FILE.json, auto, or best-of, "
            "which searches longer; default auto")
        ->type_name("FORM");
    addInteger(command, "--resolution", options.resolution, 1, kMaxResolution,
               "texels along the main axis; default: the form's own")
        ->type_name("N");
    addInteger(command, "--max-bytes", options.maxBytes, 1, kAny,
               "no material larger than this: texels x channels x bytes over all tables")
        ->type_name("B");
    addInteger(command, "--lookups", options.lookups, 1, kMaxLookups,
               "texture look-ups allowed in a pass; default 2")
        ->type_name("K");
    addInteger(command, "--terms", options.terms, 1, kMaxTerms,
               "terms of a sum that auto tries at most; default 2")
        ->type_name("N");
    command
        .add_option(
            "--seconds", options.seconds,
            "auto begins no trial after half of these seconds; 0: no limit, the same result "
            "on every machine")
        ->type_name("S")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        .add_option_function<std::string>(
            "--prior", [&options](const std::string& text) { setPrior(options, text); },
            "what fits of hdio to few samples lean on: auto (known materials, where that does "
            "better), none, or a file of learn-prior")
        ->type_name("P");
    command.add_flag("--conserve", options.conserve,
                     "scale the material down so that no directional albedo exceeds 1");
    command.add_flag_callback(
        "--as-mounted", [&options] { options.straightens = false; },
        "keep the normal of the file, also where the samples show that the surface was tilted");
    addFitTuning(command, options);
}

void addFitTuning(CLI::App& command, FitOptions& options)
{
    command
        .add_option_function<std::string>(
            "--storage",
            [&options](const std::string& name) { options.storage = storageFromName(name); },
            "log8, half, float or linear8; default log8")
        ->type_name("S");
    command
        .add_option_function<std::string>(
            "--metric",
            [&options](const std::string& name) { options.metric = metricFromName(name); },
            "log, cuberoot or log1p: the space of the residuals; default log")
        ->type_name("M");
    command.add_flag_callback(
        "--plain", [&options] { options.robust = false; }, "no robust reweighting of outliers");
    command
        .add_option_function<std::string>(
            "--smoothness",
            [&options](const std::string& text) { options.smoothness = smoothnessFromText(text); },
            "auto (by held-out error), or the strength")
        ->type_name("X");
    command.add_flag(
        "--shared", options.sharedShape,
        "one shape of every map for R, G and B, with a scale each: a third of the bytes");
    addInteger(command, "--seed", options.seed, 0, kAny, "of folds and sample sets; default 1")
        ->type_name("S");
    addThreads(command, options.threads);
}

}  // namespace fbrdf::tool
