// Options.h - the command line of fbrdf-bench.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::bench {

struct Options {
    std::vector<int> lights{1, 4, 16, 64, 256, 1024};
    int width = 256, height = 256;
    std::vector<std::string> meshes{"triangle", "sphere"};
    std::vector<std::string> only;  ///< names of variants, or of forms; empty: all
    double frameLimit = 2000.0;     ///< ms; variants that would take longer are left out
    /// The clock: wall time; CPU time of the process, which is nearly the same on a software
    /// renderer and does not depend on other load of the machine; or the GPU's own (timer queries),
    /// which leaves out what passes cost before they reach it.
    enum class Clock { wall, cpu, gpu } clock = Clock::wall;
    std::optional<int> device;  ///< of headlessDevices(); empty: the surfaceless platform's
    bool listDevices = false;
    bool accuracy = false;     ///< measure Accuracy.h instead
    bool reach = false;        ///< measure Reach.h instead; lights: how many reach a pixel
    bool environment = false;  ///< measure EnvironmentCost.h instead
    bool json = false;
    std::string help;  ///< not empty: --help was asked for, and this is the answer
};

/// Throws Error(usage) for everything that --help does not allow.
Options optionsFromArguments(int argc, const char* const* argv);

}  // namespace fbrdf::bench
