// Arguments.h - options whose bad values are reported as "--name: found X, expected Y".
#pragma once
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/sources/OpenSource.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace fbrdf::tool {

/// Whole number of `text` within [lower, upper]. Throws Error(usage) naming `where`.
uint64_t integerFromText(const std::string& where, const std::string& text, uint64_t lower,
                         uint64_t upper);

/// Adds an option for a whole number within [lower, upper].
template <class T>
CLI::Option* addInteger(CLI::App& command, const std::string& name, T& target, uint64_t lower,
                        uint64_t upper, const std::string& help)
{
    const auto parse = [name, &target, lower, upper](const std::string& text) {
        target = static_cast<T>(integerFromText(name, text, lower, upper));
    };
    return command.add_option_function<std::string>(name, parse, help);
}

/// The strength of --smoothness: a number above 0, or nothing for "auto". Throws Error(usage).
std::optional<double> smoothnessFromText(const std::string& text);

/// Adds --threads; 0, the default, means one a core.
void addThreads(CLI::App& command, int& threads);
/// Adds --cosine.
void addCosine(CLI::App& command, SourceOptions& options);
/// Adds --environment-lobes.
void addLobes(CLI::App& command, LobeFitOptions& options);
/// Adds --storage, --metric, --plain, --smoothness, --seed and --threads, which mean the same for
/// every form.
void addFitTuning(CLI::App& command, FitOptions& options);
/// Adds --form, --resolution, --max-bytes, --lookups, and the options of addFitTuning.
void addFitOptions(CLI::App& command, FitOptions& options);

}  // namespace fbrdf::tool
