// XServer.h - an X server for the tests of a program: Debian's VTK draws with X alone. The server
// chooses a display that nobody has, and ends with the tests.
#pragma once
#include <gtest/gtest.h>

#include <sys/types.h>

namespace fbrdf::test {

class XServer : public ::testing::Environment {
public:
    /// Fails where there is no Xvfb.
    void SetUp() override;
    void TearDown() override;

private:
    pid_t server_ = 0;
};

}  // namespace fbrdf::test
