// OptionTexts.h - the options of fbrdf-viewer as they are described and given.
#pragma once
#include "Options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// Texts that CLI11 fills in, to be interpreted afterwards.
struct Texts {
    std::string backend, device, technique, lookUp, camera, size, background, compareMode;
    std::vector<std::string> materials, sides;
    std::string form = "auto";
    bool plain = false, full = false;
    std::optional<float> exposure;
    std::optional<int> lightCount, samples;
};

/// Describes every option but those of subcommands. What a text needs no interpretation goes into
/// `options` while CLI11 parses; all three must live until then.
void describeOptions(CLI::App& app, Options& options, Texts& texts);

/// Subcommands.
CLI::App* describeSheet(CLI::App& app, Options& options, Texts& texts);
CLI::App* describeTurntable(CLI::App& app, Texts& texts);
CLI::App* describeCompareSheet(CLI::App& app, Texts& texts);
CLI::App* describeFigures(CLI::App& app);

}  // namespace fbrdf::viewer
