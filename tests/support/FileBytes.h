// FileBytes.h - whole files as bytes, for tests that compare or damage them.
#pragma once
#include <fstream>
#include <iterator>
#include <string>

namespace fbrdf::test {

inline std::string fileBytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

inline void putFile(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace fbrdf::test
