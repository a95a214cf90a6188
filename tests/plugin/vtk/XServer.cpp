#include "XServer.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fbrdf::test {
namespace {

/// Becomes the server, which writes the number of its display to the pipe.
[[noreturn]] void runServer(int pipe)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // also where the tests crash
    const std::string number = std::to_string(pipe);
    if (!std::freopen("/dev/null", "w", stderr)) _exit(127);  // it names displays that are taken
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24", "-nolisten",
           "tcp", "-noreset", nullptr);
    _exit(127);
}

const auto* const kServer = ::testing::AddGlobalTestEnvironment(new XServer);

}  // namespace

void XServer::SetUp()
{
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    server_ = fork();
    if (server_ == 0) runServer(ends[1]);
    close(ends[1]);
    std::string display = ":";
    for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) display += digit;
    close(ends[0]);
    ASSERT_GT(display.size(), 1u) << "found no X server, expected Xvfb to start";
    setenv("DISPLAY", display.c_str(), 1);
}

void XServer::TearDown()
{
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

}  // namespace fbrdf::test
