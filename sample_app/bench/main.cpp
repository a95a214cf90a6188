// fbrdf-bench: the runtime against other ways to draw a material. See README.md.
#include "bench/Options.h"
#include "bench/Print.h"

#include <fbrdf/brdf/Error.h>

#include <fmt/core.h>

#include <exception>

namespace {

using namespace fbrdf;

int run(int argc, char** argv)
{
    const bench::Options options = bench::optionsFromArguments(argc, argv);
    if (!options.help.empty()) {
        fmt::print("{}", options.help);
        return 0;
    }
    const bench::Measurement measurement = bench::measure(options);
    fmt::print("{}", options.json ? asJson(measurement) : asText(measurement));
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        fmt::print(stderr, "fbrdf-bench: {}\n", error.what());
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        fmt::print(stderr, "fbrdf-bench: unexpected: {}\n", error.what());
        return 1;
    }
}
