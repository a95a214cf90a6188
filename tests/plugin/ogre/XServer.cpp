#include "XServer.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace fbrdf::test {

XServer::XServer()
{
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("Xvfb: found no pipe");
    process_ = fork();
    if (process_ == 0) {
        // A test that crashes takes its server along, which must not keep the test's output open.
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        const std::string number = std::to_string(ends[1]);
        close(ends[0]);
        execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24",
               "-nolisten", "tcp", "-noreset", "+extension", "GLX", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    // The server writes the number of its display and a line feed once it listens.
    std::string display;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) display += c;
    close(ends[0]);
    if (display.empty()) throw std::runtime_error("Xvfb: found none that starts (package xvfb)");
    setenv("DISPLAY", (":" + display).c_str(), 1);
}

XServer::~XServer()
{
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
}

}  // namespace fbrdf::test
