// ExpectError.h - what every failure must look like: one Error of a kind that has the given words,
// on one line unless it quotes the log of a shader compiler.
#pragma once
#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <string>

namespace fbrdf::test {

template <class Action>
void expectError(ErrorKind kind, const std::string& words, const Action& action)
{
    try {
        action();
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << what;
        EXPECT_NE(what.find(words), std::string::npos)
            << what << "\n  expected the words: " << words;
        if (kind != ErrorKind::gl) {
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        }
        return;
    }
    ADD_FAILURE() << "nothing was thrown, expected an error with the words: " << words;
}

}  // namespace fbrdf::test
