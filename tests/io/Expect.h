// Expect.h - what every failing read and write must look like: one Error of a kind, whose one line
// says a given text.
#pragma once
#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <string>

namespace fbrdf::test {

template <class Action>
void expectError(ErrorKind kind, const std::string& text, const Action& action)
{
    try {
        action();
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << what;
        EXPECT_NE(what.find(text), std::string::npos) << what << "\n  should say: " << text;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return;
    }
    ADD_FAILURE() << "nothing was thrown; expected an error that says: " << text;
}

}  // namespace fbrdf::test
