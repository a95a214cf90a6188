#include "XServer.h"

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
