// BuiltFile.h - where programs and libraries of this build are that a test runs or loads.
#pragma once
#include <cstdlib>
#include <string>

namespace fbrdf::test {

/// The path that the environment variable gives, for tests that run on another machine
/// (tests/run-gpu.sh), or else the one that the build wrote into the test.
inline std::string builtFile(const char* variable, const char* built)
{
    const char* const elsewhere = std::getenv(variable);
    return elsewhere && *elsewhere ? elsewhere : built;
}

}  // namespace fbrdf::test
