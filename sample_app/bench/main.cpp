// fbrdf-bench: the runtime against other ways to draw a material. See README.md.
#include "bench/Accuracy.h"
#include "bench/EnvironmentCost.h"
#include "bench/Measure.h"
#include "bench/Options.h"
#include "bench/Print.h"
#include "bench/Reach.h"
#include "viewer/CommandLine.h"

#include <fmt/core.h>

namespace {

using namespace fbrdf;

template <class Measurement>
void print(const Measurement& measurement, bool json)
{
    fmt::print("{}", json ? asJson(measurement) : asText(measurement));
}

int run(int argc, char** argv)
{
    const bench::Options options = bench::optionsFromArguments(argc, argv);
    if (!options.help.empty()) {
        fmt::print("{}", options.help);
        return 0;
    }
    if (options.listDevices) {
        fmt::print("{}", viewer::devicesText());
        return 0;
    }
    if (options.accuracy) {
        const bench::Accuracy accuracy = bench::measureAccuracy(options);
        print(accuracy, options.json);
        return accuracy.holds() ? 0 : 1;
    }
    if (options.environment)
        print(bench::measureEnvironment(options), options.json);
    else if (options.reach)
        print(bench::measureReach(options), options.json);
    else
        print(bench::measure(options), options.json);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return fbrdf::viewer::exitCodeOf("fbrdf-bench", run, argc, argv);
}
