// fbrdf convert: materials between their formats, sources to samples and tables.
#include "Arguments.h"
#include "Commands.h"
#include "Progress.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/OpenSource.h>
#include <fbrdf/sources/Write.h>

#include <filesystem>

namespace fbrdf::tool {
namespace {

struct ConvertCommand {
    std::string input, output;
    SourceOptions sourceOptions;
};

enum class Target { material, csv, merl };

Target targetOf(const std::string& path)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".fbrdf" || extension == ".txt" || extension == ".json")
        return Target::material;
    if (extension == ".csv") return Target::csv;
    if (extension == ".binary") return Target::merl;
    throw Error(
        ErrorKind::usage, path,
        Found("extension '" + extension + "'")
            .expected(
                ".fbrdf, .txt (2001 layout), .json (manifest and PNG), .csv or .binary (MERL)"));
}

void convertMaterial(const ConvertCommand& command, const Source& source)
{
    if (source.format != "material")
        throw Error(ErrorKind::usage, command.input,
                    Found("reflectance (" + source.format + ")")
                        .expected("a material: fbrdf fit makes one"));
    writeMaterial(readMaterial(command.input), command.output);
}

int run(const ConvertCommand& command)
{
    requireWritable(command.output);
    const Target target = targetOf(command.output);
    Progress progress(true);
    progress.phase("reading " + command.input);
    const Source source = openSource(command.input, command.sourceOptions);
    progress.phase("writing " + command.output);
    switch (target) {
        case Target::material: convertMaterial(command, source); break;
        case Target::csv: writeCsv(source, command.output); break;
        case Target::merl: writeMerl(source, command.output); break;
    }
    return 0;
}

}  // namespace

void addConvertCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("convert", "materials and sources to other formats");
    const auto command = std::make_shared<ConvertCommand>();
    sub->add_option("IN", command->input, "material, data file, or model")->required();
    sub->add_option("OUT", command->output,
                    "of a material: .fbrdf, .txt (2001 layout), .json (manifest and PNG maps); of "
                    "anything: .csv, .binary (MERL)")
        ->required();
    addCosine(*sub, command->sourceOptions);
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool
