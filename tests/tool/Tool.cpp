#include "Tool.h"

#include "support/TemporaryDir.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace fbrdf::test {
namespace {

[[noreturn]] void becomeTool(std::vector<std::string> command,
                             const std::vector<std::string>& extra)
{
    for (const std::string& variable : extra) putenv(const_cast<char*>(variable.c_str()));
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

void redirect(int descriptor, const std::string& path, int flags)
{
    const int file = open(path.c_str(), flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
}

/// The two ends of a pseudo terminal.
struct Terminal {
    int master = -1, slave = -1;

    explicit Terminal(bool wanted)
    {
        winsize size{24, 80, 0, 0};
        if (wanted && openpty(&master, &slave, nullptr, nullptr, &size) != 0)
            throw std::runtime_error("no pseudo terminal");
    }
    ~Terminal()
    {
        if (master >= 0) close(master);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    // Until the last process that has the other end is gone. Calls `shown` with all of the text
    // whenever there is more.
    std::string readAll(const std::function<void(const std::string&)>& shown)
    {
        std::string text;
        if (master < 0) return text;
        close(slave);
        char buffer[4096];
        for (ssize_t count = 0; (count = read(master, buffer, sizeof buffer)) > 0;)
            shown(text.append(buffer, static_cast<size_t>(count)));
        return text;
    }
};

int codeOfStatus(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

bool terminalsExist()
{
    int master = -1, slave = -1;
    if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return false;
    close(master);
    close(slave);
    return true;
}

ToolRun runTool(const std::vector<std::string>& arguments, const ToolOptions& options)
{
    const TemporaryDir folder;
    writeText(folder.file("in"), options.input);
    std::vector<std::string> command = options.launcher;
    command.push_back(FBRDF_TOOL);
    command.insert(command.end(), arguments.begin(), arguments.end());
    const std::string out = options.stdoutPath.empty() ? folder.file("out") : options.stdoutPath;
    Terminal terminal(options.terminal);
    const pid_t child = fork();
    if (child == 0) {
        redirect(STDIN_FILENO, folder.file("in"), O_RDONLY);
        redirect(STDOUT_FILENO, out, O_CREAT | O_WRONLY);
        if (options.terminal)
            dup2(terminal.slave, STDERR_FILENO);
        else
            redirect(STDERR_FILENO, folder.file("err"), O_CREAT | O_WRONLY);
        becomeTool(command, options.environment);
    }
    ToolRun run;
    int signal = options.signal;
    run.err = terminal.readAll([&](const std::string& text) {
        if (signal == 0 || text.find(options.signalAt) == std::string::npos) return;
        kill(child, signal);
        signal = 0;
    });
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    run.code = codeOfStatus(status);
    run.maxResidentKb = usage.ru_maxrss;
    if (options.stdoutPath.empty()) run.out = readText(out);
    if (!options.terminal) run.err = readText(folder.file("err"));
    return run;
}

nlohmann::json jsonFrom(const ToolRun& run)
{
    EXPECT_EQ(run.code, 0) << run.err;
    nlohmann::json json = nlohmann::json::parse(run.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << run.out;
    return json.is_discarded() ? nlohmann::json() : json;
}

void expectError(const ToolRun& run, int code, const std::string& words)
{
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.out, "");
    const std::vector<std::string> lines = linesOf(run.err);
    ASSERT_EQ(lines.size(), 1u) << run.err;
    EXPECT_EQ(run.err.back(), '\n');
    EXPECT_EQ(lines[0].rfind("fbrdf: ", 0), 0u) << run.err;
    EXPECT_NE(lines[0].find(words), std::string::npos) << lines[0] << "\nexpected: " << words;
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string readText(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void writeText(const std::string& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace fbrdf::test
