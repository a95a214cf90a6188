// Tool.h - runs the built program as a user or a script would, and keeps what it printed.
#pragma once
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace fbrdf::test {

struct ToolRun {
    int code = -1;           ///< exit code; 128 + signal for a program that was killed
    std::string out, err;    ///< all of stdout and stderr
    long maxResidentKb = 0;  ///< largest resident set
};

struct ToolOptions {
    std::string input;                     ///< given as stdin
    std::string stdoutPath;                ///< where stdout goes instead of ToolRun::out
    std::vector<std::string> environment;  ///< "NAME=value", added
    std::vector<std::string> launcher;     ///< program and arguments before the tool: mpirun
    bool terminal = false;  ///< stderr is a terminal (a pseudo terminal of 80 columns)
    /// Sent once when the terminal shows `signalAt`, as Ctrl-C is; 0 for none.
    int signal = 0;
    std::string signalAt;
};

/// Whether this machine gives pseudo terminals; a bare chroot without /dev/pts does not.
bool terminalsExist();

/// Runs `fbrdf arguments...` in the current folder.
ToolRun runTool(const std::vector<std::string>& arguments, const ToolOptions& options = {});

/// The object that a run with --json printed; a failed expectation and null when it did not.
nlohmann::json jsonFrom(const ToolRun& run);

/// Expects the exit code, nothing on stdout, and exactly one line "fbrdf: ..." on stderr that
/// contains `words`.
void expectError(const ToolRun& run, int code, const std::string& words);

std::vector<std::string> linesOf(const std::string& text);
std::string readText(const std::string& path);
void writeText(const std::string& path, const std::string& text);

}  // namespace fbrdf::test
