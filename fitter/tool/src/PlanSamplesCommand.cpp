// fbrdf plan-samples: the directions at which few measurements say most.
#include "Arguments.h"
#include "Commands.h"
#include "CsvText.h"
#include "Output.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/fit/SamplePlan.h>

#include <cmath>
#include <memory>

namespace fbrdf::tool {
namespace {

struct PlanSamplesCommand {
    size_t count = 0;
    std::string output;
    bool inPlane = false, angles = false;
};

using Names = std::vector<std::string>;

std::string vectorsLine(const DirectionPair<double>& pair)
{
    Names fields;
    for (const Vec3d& v : {pair.wo, pair.wi})
        for (int k = 0; k < 3; ++k) fields.push_back(numberText(v[k], 9));
    return csvLine(fields);
}

// Turned about the normal so that the light is at azimuth 0.
std::string anglesLine(const DirectionPair<double>& pair)
{
    constexpr double kDegrees = 180.0 / kPi;
    const auto zenith = [](const Vec3d& v) { return std::atan2(std::hypot(v.x, v.y), v.z); };
    const Vec3d &i = pair.wi, &o = pair.wo;
    const double azimuth = std::atan2(i.x * o.y - i.y * o.x, i.x * o.x + i.y * o.y);
    return csvLine({fixedText(zenith(i) * kDegrees, 3), "0", fixedText(zenith(o) * kDegrees, 3),
                    fixedText(azimuth * kDegrees, 3)});
}

int run(const PlanSamplesCommand& command)
{
    if (!command.output.empty()) requireWritable(command.output);
    const SamplePlan plan = shippedPlan(
        command.inPlane ? PlanSpace::planeOfIncidence : PlanSpace::hemisphere, command.count);
    std::string text =
        csvLine(command.angles ? Names{"theta_i", "phi_i", "theta_o", "phi_o"}
                               : Names{"wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"});
    for (const auto& pair : plan) text += command.angles ? anglesLine(pair) : vectorsLine(pair);
    if (command.output.empty())
        writeOut(text);
    else
        writeFile(command.output, text);
    return 0;
}

}  // namespace

void addPlanSamplesCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("plan-samples", "directions to measure, best first");
    const auto command = std::make_shared<PlanSamplesCommand>();
    addInteger(*sub, "N", command->count, 1, 1u << 20, "how many; fewer are a prefix of more")
        ->required();
    sub->add_option("-o,--output", command->output, "CSV to write; default: standard output")
        ->type_name("FILE.csv");
    sub->add_flag("--in-plane", command->inPlane,
                  "only in the plane of incidence, for a simple goniometer");
    sub->add_flag("--angles", command->angles,
                  "columns theta_i,phi_i,theta_o,phi_o in degrees, not unit vectors");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool
