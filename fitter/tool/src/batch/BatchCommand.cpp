// fbrdf batch: many materials, spread over threads, and over ranks under mpirun.
#include "Arguments.h"
#include "batch/BatchResults.h"
#include "Commands.h"
#include "FitJob.h"
#include "Output.h"
#include "Ranks.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/io/MaterialFile.h>
#include <fmt/format.h>

#include <unistd.h>
#include <cstdio>
#include <filesystem>
#include <mutex>

namespace fbrdf::tool {
namespace {

namespace fs = std::filesystem;

struct BatchCommand {
    std::string list, folder;
    FitJob job;  // without a source
    bool resume = false, json = false, quiet = false;
};

struct Counts {
    size_t fitted = 0, kept = 0, failed = 0;
};

std::string materialPath(const BatchCommand& command, const BatchItem& item)
{
    return (fs::path(command.folder) / (item.name + ".fbrdf")).string();
}

std::string resultsPath(const BatchCommand& command)
{
    return (fs::path(command.folder) / "results.csv").string();
}

FitJob jobOf(const BatchCommand& command, const BatchItem& item, int threads)
{
    FitJob job = command.job;
    job.source = item.source;
    job.fit.threads = threads;
    return job;
}

// A source that was changed after its material was written is fitted again.
bool isOlder(const std::string& material, const std::string& source)
{
    std::error_code ignored;
    const std::string file =
        fs::exists(source, ignored) ? source : source.substr(0, source.find_last_of("@#"));
    return fs::exists(file, ignored) &&
           fs::last_write_time(material, ignored) < fs::last_write_time(file, ignored);
}

std::string note(const Material& material, const char* key)
{
    const auto found = material.notes.find(key);
    return found == material.notes.end() ? "" : found->second;
}

// True when the material is there, newer than its source, and fitted by the same version from the
// same source with the same options.
bool isDone(const std::string& path, const FitJob& job)
{
    std::error_code ignored;
    if (!fs::exists(path, ignored) || isOlder(path, job.source)) return false;
    try {
        const Material material = readMaterial(path);
        return note(material, kSourceNote) == sourceNote(job.source) &&
               note(material, kOptionsNote) == optionsNote(job) &&
               note(material, kGeneratorNote) == generatorNote();
    } catch (const Error&) {  // not a material: it is replaced
        return false;
    }
}

BatchOutcome fitItem(const BatchCommand& command, const BatchItem& item, int threads)
{
    const FitJob job = jobOf(command, item, threads);
    const std::string path = materialPath(command, item);
    if (command.resume && isDone(path, job)) return {BatchOutcome::State::kept, ""};
    Progress silent(false);
    writeMaterial(*runFitJob(job, silent).material, path);
    return {BatchOutcome::State::fitted, ""};
}

// A material that fails does not stop the others.
BatchOutcome tryItem(const BatchCommand& command, const BatchItem& item, int threads)
{
    try {
        return fitItem(command, item, threads);
    } catch (const std::bad_alloc&) {
        return {BatchOutcome::State::failed, "memory: found too little, expected less data"};
    } catch (const std::exception& error) {
        return {BatchOutcome::State::failed, oneLine(error.what())};
    }
}

// Index, state and error of an item on one line, as ranks send it to rank 0.
std::string lineOf(size_t index, const BatchOutcome& outcome)
{
    return fmt::format("{} {} {}\n", index, static_cast<int>(outcome.state), outcome.error);
}

std::vector<BatchOutcome> outcomesOf(const std::string& lines, size_t count)
{
    std::vector<BatchOutcome> outcomes(count);
    for (size_t begin = 0; begin < lines.size();) {
        const size_t end = lines.find('\n', begin);
        const size_t first = lines.find(' ', begin), second = lines.find(' ', first + 1);
        BatchOutcome& outcome = outcomes.at(std::stoul(lines.substr(begin, first - begin)));
        outcome.state = static_cast<BatchOutcome::State>(lines[first + 1] - '0');
        outcome.error = lines.substr(second + 1, end - second - 1);
        begin = end + 1;
    }
    return outcomes;
}

// Cores of this machine that belong to this rank. mpirun may have bound it to some already.
int threadsOfRank(const BatchCommand& command, const Ranks& ranks)
{
    if (command.job.fit.threads > 0) return command.job.fit.threads;
    const int online = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    return std::max(1, std::min(threadCount(0), online / ranks.onThisMachine()));
}

// Fits every count()-th item from rank() on. Threads take whole materials as long as there are
// enough.
std::string fitShare(const BatchCommand& command, const std::vector<BatchItem>& items,
                     const Ranks& ranks)
{
    const auto first = static_cast<size_t>(ranks.rank()), step = static_cast<size_t>(ranks.count());
    const size_t mine = items.size() > first ? (items.size() - first + step - 1) / step : 0;
    const int threads = threadsOfRank(command, ranks);
    const int workers = static_cast<int>(std::clamp<size_t>(mine, 1, static_cast<size_t>(threads)));
    Progress progress(ranks.rank() == 0 && !command.quiet);
    std::string lines;
    size_t done = 0;
    std::mutex mutex;
    progress.bar(0, mine, "fitting");
    parallelTasks(mine, workers, [&](size_t i) {
        const size_t index = first + i * step;
        const BatchOutcome outcome = tryItem(command, items[index], threads / workers);
        const std::lock_guard<std::mutex> lock(mutex);
        lines += lineOf(index, outcome);
        progress.bar(++done, mine, items[index].name);
    });
    return lines;
}

// Checks on rank 0 before any work. Returns the text of the list.
std::string prepare(const BatchCommand& command)
{
    const std::string text = readListFile(command.list);
    parseList(text, command.list);
    std::error_code error;
    fs::create_directories(command.folder, error);
    if (error)
        throw Error(ErrorKind::output, command.folder,
                    "cannot be made: " + systemErrorText(error.value()));
    requireWritable(resultsPath(command));
    return text;
}

// Returns the items on every rank, or none where rank 0 found an error, which it alone reports.
std::vector<BatchItem> sharedItems(const BatchCommand& command, const Ranks& ranks)
{
    std::string text;
    std::exception_ptr failure;
    try {
        if (ranks.rank() == 0) text = prepare(command);
    } catch (...) {
        failure = std::current_exception();
        text.clear();
    }
    text = ranks.broadcast(text);
    if (failure) std::rethrow_exception(failure);
    return text.empty() ? std::vector<BatchItem>() : parseList(text, command.list);
}

std::string resultsTable(const BatchCommand& command, const std::vector<BatchItem>& items,
                         const std::vector<BatchOutcome>& outcomes)
{
    std::string table = resultsHeader();
    for (size_t i = 0; i < items.size(); ++i)
        table += outcomes[i].state == BatchOutcome::State::failed
                     ? failureRow(items[i], outcomes[i].error)
                     : resultsRow(items[i], readMaterial(materialPath(command, items[i])));
    return table;
}

Counts countsOf(const std::vector<BatchOutcome>& outcomes)
{
    Counts counts;
    for (const BatchOutcome& outcome : outcomes) {
        counts.fitted += outcome.state == BatchOutcome::State::fitted;
        counts.kept += outcome.state == BatchOutcome::State::kept;
        counts.failed += outcome.state == BatchOutcome::State::failed;
    }
    return counts;
}

std::string summaryText(const BatchCommand& command, const Counts& counts)
{
    return fmt::format("{} fitted, {} kept, {} failed: {}\n", withSeparators(counts.fitted),
                       withSeparators(counts.kept), withSeparators(counts.failed),
                       resultsPath(command));
}

Json summaryJson(const BatchCommand& command, const Counts& counts)
{
    return {{"fitted", counts.fitted},
            {"kept", counts.kept},
            {"failed", counts.failed},
            {"results", resultsPath(command)}};
}

// Writes the table, a line on stderr for each failure, and the summary. Only rank 0 calls it.
int conclude(const BatchCommand& command, const std::vector<BatchItem>& items,
             const std::vector<BatchOutcome>& outcomes)
{
    writeFile(resultsPath(command), resultsTable(command, items, outcomes));
    for (size_t i = 0; i < items.size(); ++i)
        if (outcomes[i].state == BatchOutcome::State::failed)
            fmt::print(stderr, "fbrdf: {}: {}\n", oneLine(items[i].name), outcomes[i].error);
    const Counts counts = countsOf(outcomes);
    if (command.json)
        writeOut(text(summaryJson(command, counts)));
    else if (!command.quiet)
        writeOut(summaryText(command, counts));
    return counts.failed > 0 ? 1 : 0;
}

int run(BatchCommand command)
{
    const Ranks ranks;
    const std::vector<BatchItem> items = sharedItems(command, ranks);
    command.job.fit.cache = makeFitCache();
    if (items.empty()) return 0;
    const std::string lines = ranks.gather(fitShare(command, items, ranks));
    return ranks.rank() == 0 ? conclude(command, items, outcomesOf(lines, items.size())) : 0;
}

}  // namespace

void addBatchCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("batch", "fit many materials");
    const auto command = std::make_shared<BatchCommand>();
    sub->add_option("LIST", command->list, "lines name<TAB>source; '#' starts a comment line")
        ->required();
    sub->add_option("-o,--output", command->folder, "folder of NAME.fbrdf and results.csv")
        ->required()
        ->type_name("DIR");
    sub->add_flag("--resume", command->resume,
                  "keep materials that are there already, of the same source and options");
    addFitOptions(*sub, command->job.fit);
    addLobes(*sub, command->job.lobes);
    addCosine(*sub, command->job.sourceOptions);
    sub->add_flag("--json", command->json, "print one JSON object");
    sub->add_flag("--quiet", command->quiet, "print nothing but errors");
    sub->footer(
        "Alone it fits several materials at a time; mpirun -n N fbrdf batch ... spreads them\n"
        "over N processes. Exit code 1: some materials failed; results.csv has the reasons.");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool
