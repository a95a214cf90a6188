// ExpectError.h - that an act throws an error of the right kind with words that help.
#pragma once
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace fbrdf::test {

inline void expectError(ErrorKind kind, const std::string& words, const std::function<void()>& act)
{
    try {
        act();
        ADD_FAILURE() << "no error, expected '" << words << "'";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

}  // namespace fbrdf::test
