// NewerFile.h - material files as a later version of the library would write them.
#pragma once
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace fbrdf::test {

/// Copies the file `from` to `to`, with format version 9 in every part.
inline void writeNewerVersion(const std::string& from, const std::string& to)
{
    std::ostringstream bytes;
    bytes << std::ifstream(from, std::ios::binary).rdbuf();
    std::string text = bytes.str();
    const std::string name("fbrdf:version\0int\0\4\0\0\0", 22);
    ASSERT_NE(text.find(name), std::string::npos);
    for (size_t i = text.find(name); i != std::string::npos; i = text.find(name, i + 1))
        text[i + name.size()] = 9;
    std::ofstream(to, std::ios::binary) << text;
}

}  // namespace fbrdf::test
