// XServer.h - an X server without a screen, for render systems of OGRE that have no other way to a
// context.
#pragma once
#include <sys/types.h>

namespace fbrdf::test {

/// Starts Xvfb at a display that it finds free, and sets DISPLAY. Throws std::runtime_error where
/// that fails.
class XServer {
public:
    XServer();
    ~XServer();
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;

private:
    pid_t process_ = -1;
};

}  // namespace fbrdf::test
